#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::output {

/// A NumPy array file (format version 1.0) of shape (height, width), C order, little-endian. Requires
/// values.size() == width * height.
/// Source: NumPy enhancement proposal 1, "A simple file format for NumPy arrays".
[[nodiscard]] std::vector<std::byte> encodeNpy(std::uint32_t width, std::uint32_t height,
                                               std::span<const std::uint32_t> values);
[[nodiscard]] std::vector<std::byte> encodeNpy(std::uint32_t width, std::uint32_t height,
                                               std::span<const float> values);

} // namespace limen::output
