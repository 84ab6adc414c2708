#include "dat/container/Mapping.h"

#include "core/platform/FileView.h"

#include <utility>

namespace limen::dat {

Result<Mapping> Mapping::open(const std::filesystem::path& path) {
    const Result<platform::FileView> view = platform::mapFile(path);
    if (!view)
        return Failure(view.error());
    Mapping mapping;
    mapping.data_ = view->data;
    mapping.size_ = view->size;
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
    if (owned_.empty())
        platform::letPagesGo({data_, size_});
}

void Mapping::release() {
    if (owned_.empty())
        platform::unmapFile({data_, size_});
    data_ = nullptr;
    size_ = 0;
}

} // namespace limen::dat
