#pragma once

#include <cstdint>
#include <span>

namespace limen::world {

/// The block formats, also known as BC1, BC2 and BC3.
enum class DxtKind { Dxt1, Dxt3, Dxt5 };

/// Decodes ceil(width/4) * ceil(height/4) blocks to R,G,B,A bytes, top row first. Requires: `blocks` holds
/// all of them, and `rgba` has width * height * 4 bytes. Ref: the description of the blocks in the OpenGL
/// extension for S3TC.
void decodeDxt(DxtKind kind, std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> blocks,
               std::span<std::uint8_t> rgba);

} // namespace limen::world
