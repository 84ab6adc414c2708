#pragma once

#include <cstdint>
#include <span>

namespace limen::world {

/// Which of the block formats: BC1, BC2, BC3.
enum class DxtKind { Dxt1, Dxt3, Dxt5 };

/// Decodes ceil(width/4) * ceil(height/4) blocks to R,G,B,A bytes, top row first. Requires `blocks` to hold
/// them all and `rgba` to hold width * height * 4 bytes. Ref: the S3TC extension's description of the blocks.
void decodeDxt(DxtKind kind, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> blocks,
               std::span<std::uint8_t> rgba);

} // namespace limen::world
