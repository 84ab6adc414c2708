#include "dat/container/Mapping.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace limen::dat {
namespace {

/// Closes a descriptor on destruction.
struct Descriptor {
    int fd = -1;
    ~Descriptor() {
        if (fd >= 0)
            ::close(fd);
    }
};

} // namespace

Result<Mapping> Mapping::open(const std::filesystem::path& path) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.fd < 0) {
        if (errno == ENOENT || errno == ENOTDIR)
            return fail(ErrorCode::NotFound, path.string(), "there is no such file");
        return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
    }
    struct stat info {};
    if (::fstat(file.fd, &info) != 0)
        return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
    if (!S_ISREG(info.st_mode))
        return fail(ErrorCode::Unreadable, path.string(), "this is not a regular file");
    Mapping mapping;
    mapping.size_ = static_cast<std::size_t>(info.st_size);
    if (mapping.size_ == 0)
        return mapping;
    void* address = ::mmap(nullptr, mapping.size_, PROT_READ, MAP_PRIVATE, file.fd, 0);
    if (address == MAP_FAILED) {
        mapping.size_ = 0;
        return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
    }
    mapping.data_ = static_cast<const std::byte*>(address);
    return mapping;
}

Mapping Mapping::copyOf(ByteView bytes) {
    Mapping mapping;
    mapping.owned_.assign(bytes.begin(), bytes.end());
    mapping.data_ = mapping.owned_.data();
    mapping.size_ = mapping.owned_.size();
    return mapping;
}

Mapping::Mapping(Mapping&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)),
      owned_(std::move(other.owned_)) {}

Mapping& Mapping::operator=(Mapping&& other) noexcept {
    if (this != &other) {
        release();
        data_ = std::exchange(other.data_, nullptr);
        size_ = std::exchange(other.size_, 0);
        owned_ = std::move(other.owned_);
    }
    return *this;
}

Mapping::~Mapping() {
    release();
}

void Mapping::letPagesGo() const {
    if (data_ != nullptr && owned_.empty() && size_ != 0)
        ::madvise(const_cast<std::byte*>(data_), size_,
                  MADV_DONTNEED); // a hint: failure is harmless
}

void Mapping::release() {
    if (data_ != nullptr && owned_.empty() && size_ != 0)
        ::munmap(const_cast<std::byte*>(data_), size_);
    data_ = nullptr;
    size_ = 0;
}

} // namespace limen::dat
