#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace limen {

/// FNV-1a (Fowler, Noll, Vo 1991), to compare results; not for secrets. Equal on machines of the same byte
/// order.
class Hash {
public:
    /// Adds a value byte by byte. The type must not have padding.
    template <class T>
    void add(const T& value) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
        for (std::size_t i = 0; i < sizeof value; ++i)
            mix(bytes[i]);
    }
    /// Adds many bytes, eight at a time; the last word is filled with zeros. The hash differs from that of
    /// add().
    void addWords(std::span<const std::byte> bytes) {
        for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
            mix(word);
            value_ ^= value_ >> 32;
        }
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    void mix(std::uint64_t word) { value_ = (value_ ^ word) * 0x100000001B3u; }

    std::uint64_t value_ = 0xCBF29CE484222325u;
};

} // namespace limen
