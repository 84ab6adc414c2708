// The picture in tiles of kTileSize pixels a side, row by row from the bottom; the last of a row or column may be cut.
#include "buffers.glsl"

uint tileIndex(uvec2 tile) {
    return tile.y * ((uint(frame.viewport.x) + kTileSize - 1u) / kTileSize) + tile.x;
}
