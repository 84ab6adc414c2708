#include "core/platform/FileView.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace limen::platform {
namespace {

/// Closes a descriptor on destruction.
struct MappedDescriptor {
    int fd = -1;
    ~MappedDescriptor() {
        if (fd >= 0)
            ::close(fd);
    }
};

} // namespace

Result<FileView> mapFile(const std::filesystem::path& path) {
    const MappedDescriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
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
    if (info.st_size == 0)
        return FileView();
    const auto size = static_cast<std::size_t>(info.st_size);
    void* address = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.fd, 0);
    if (address == MAP_FAILED)
        return fail(ErrorCode::Unreadable, path.string(), std::strerror(errno));
    return FileView{static_cast<const std::byte*>(address), size};
}

void unmapFile(FileView view) {
    if (view.data != nullptr)
        ::munmap(const_cast<std::byte*>(view.data), view.size);
}

void letPagesGo(FileView view) {
    if (view.data != nullptr)
        ::madvise(const_cast<std::byte*>(view.data), view.size, MADV_DONTNEED); // failure is harmless
}

} // namespace limen::platform
