// For every tile of the picture, the least depth of its pixels, which is the farthest, of what has been drawn so far: walls and the
// ground. What lies farther all over a tile is hidden there, whatever it is, for depth is what decides.
#include "tiles.glsl"

layout(local_size_x = kTileThreads) in;
layout(binding = kUnitDepth) uniform sampler2D depthSoFar;

void main() {
    ivec2 size = ivec2(frame.viewport.xy);
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    ivec2 begin = min(tile * int(kTileSize), size);
    ivec2 end = min(begin + int(kTileSize), size);
    float least = 1.0;
    for (int y = begin.y; y < end.y; ++y) {
        for (int x = begin.x; x < end.x; ++x) {
            least = min(least, texelFetch(depthSoFar, ivec2(x, y), 0).r);
        }
    }
    if (begin.x < size.x) {
        tileDepths[tileIndex(uvec2(tile))] = least;
    }
}
