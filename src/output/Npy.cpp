#include "output/Npy.h"

#include "core/Assert.h"

#include <bit>
#include <fmt/format.h>
#include <string_view>

namespace limen::output {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays are written byte by byte from memory");

std::vector<std::byte> encode(std::string_view type, std::uint32_t width, std::uint32_t height,
                              std::span<const std::byte> values) {
    LIMEN_ASSERT(values.size() == static_cast<std::size_t>(width) * height * 4, "four bytes an element");
    constexpr std::size_t kPrefix = 10,
                          kAlignment = 64; // magic, version, header length; NumPy aligns the data
    std::string header =
        fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}, {}), }}", type, height, width);
    header.append(kAlignment - (kPrefix + header.size() + 1) % kAlignment, ' ');
    header += '\n';
    const std::string prefix =
        fmt::format("\x93NUMPY{}{}{}{}", '\x01', '\0', static_cast<char>(header.size() & 0xFF),
                    static_cast<char>(header.size() >> 8));
    std::vector<std::byte> bytes;
    bytes.reserve(prefix.size() + header.size() + values.size());
    for (const std::string_view text : {std::string_view(prefix), std::string_view(header)}) {
        const auto part = std::as_bytes(std::span(text));
        bytes.insert(bytes.end(), part.begin(), part.end());
    }
    bytes.insert(bytes.end(), values.begin(), values.end());
    return bytes;
}

} // namespace

std::vector<std::byte> encodeNpy(std::uint32_t width, std::uint32_t height,
                                 std::span<const std::uint32_t> values) {
    return encode("<u4", width, height, std::as_bytes(values));
}

std::vector<std::byte> encodeNpy(std::uint32_t width, std::uint32_t height, std::span<const float> values) {
    return encode("<f4", width, height, std::as_bytes(values));
}

} // namespace limen::output
