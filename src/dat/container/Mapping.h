#pragma once

#include "dat/Codec.h"

#include <filesystem>

namespace limen::dat {

/// The bytes of a file: mapped read-only, or a copy kept in memory. Empty when moved from.
class Mapping {
public:
    /// Errors: the file is missing, is a directory, or cannot be opened or mapped. An empty file maps to no
    /// bytes.
    [[nodiscard]] static Result<Mapping> open(const std::filesystem::path& path);
    [[nodiscard]] static Mapping copyOf(ByteView bytes);

    Mapping(Mapping&& other) noexcept;
    Mapping& operator=(Mapping&& other) noexcept;
    ~Mapping();

    [[nodiscard]] ByteView bytes() const { return {data_, size_}; }

    /// Has no page of the file count as this process's memory until it is read again; the system keeps them as long as it has room. Others
    /// may read meanwhile.
    void letPagesGo() const;

private:
    Mapping() = default;
    void release();

    const std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    Bytes owned_; ///< holds the bytes unless they are mapped
};

} // namespace limen::dat
