#pragma once

#include "dat/Codec.h"

#include <filesystem>

namespace limen::dat {

/// The bytes of a file, mapped read-only, or a copy in memory. Empty when moved from.
class Mapping {
public:
    /// Errors: the file is missing, is a directory, or cannot be opened or mapped. An empty file gives no
    /// bytes.
    [[nodiscard]] static Result<Mapping> open(const std::filesystem::path& path);
    [[nodiscard]] static Mapping copyOf(ByteView bytes);

    Mapping(Mapping&& other) noexcept;
    Mapping& operator=(Mapping&& other) noexcept;
    ~Mapping();

    [[nodiscard]] ByteView bytes() const { return {data_, size_}; }

    /// Releases the pages of the file from this process's memory until they are read again. The system may
    /// keep them in its cache. Safe while other threads read.
    void letPagesGo() const;

private:
    Mapping() = default;
    void release();

    const std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    Bytes owned_; ///< holds the bytes unless they are mapped
};

} // namespace limen::dat
