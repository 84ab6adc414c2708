// Writes the draw commands of a frame, one work group a command, and compacts the indices of the triangles it keeps.
// Order is preserved, because of two fragments at equal depth the later one is seen. A command without triangles draws
// nothing.
//
// An instance is dropped outside its level-of-detail range. A triangle is dropped if it faces away, covers no pixel
// centre, or is outside its run's rectangles (beyond them the ownership test would discard every fragment). Triangles
// are dropped only with EXACT outlines: there a ray through the pixel centre decides, so a triangle clear of all
// centres shows nothing, however the rasteriser snaps it.
//
// Modes (cullMode): the draws of walls and ground, or all draws; the other draws, without triangles that are behind the depth
// tiles. A grid of kTileLayers layers finds the depth tiles, when walls and ground are drawn.
#include "Tolerances.h"
#include "frommodel.glsl"
#include "levels.glsl"

layout(local_size_x = kCullThreads) in;
layout(location = kUniformCullMode) uniform uint cullMode;
layout(binding = kUnitDepth) uniform sampler2D depthSoFar;

// Pixels. Bounds the error of an outline computed here, plus the distance of a pixel's ray from its centre (kBesideX),
// with room to spare: corners are 24-bit floats.
const float kMargin = 1.0 / 32.0;
// Relative rounding error of a sum: more than ten roundings.
const float kRounding = 1.0e-6;
// Metres, and metres per metre of distance, that the eye must be behind a triangle's plane. mesh.vert computes the
// plane again.
const float kBehind = 1.0e-3;
const float kBehindSlope = 1.0e-6;

bool facesAway(uint vertex, Instance instance, vec3 corner) {
    vec4 plane = facetFromModel(facetAt(vertex), instance, corner);
    return plane.w > kBehind + kBehindSlope * length(corner);
}

// Distance of a point to the inner side of an edge, times the edge's length, plus a margin of kMargin. `turn`: 1 for a
// counter-clockwise outline, -1 for a clockwise one; either for an outline thinner than kMargin.
float withinEdge(vec2 from, vec2 to, vec2 point, float turn) {
    vec2 along = to - from;
    vec2 reach = point - from;
    return turn * (along.x * reach.y - along.y * reach.x) + kMargin * length(along);
}

bool isNear(vec2 a, vec2 b, vec2 c, float turn, vec2 point) {
    return min(min(withinEdge(a, b, point, turn), withinEdge(b, c, point, turn)), withinEdge(c, a, point, turn)) >= 0.0;
}

// Pixels whose centres a triangle may cover, low and high included.
struct Pixels {
    vec2 low;
    vec2 high;
    bool any;
};

// Pixels with centres in the rectangle around three corners on the screen. Up to 2 x 2 of them are tested against the
// triangle itself.
Pixels pixelsOf(vec3 first, vec3 second, vec3 third) {
    vec2 most = device.viewport.xy * 0.5;
    vec2 a = first.xy / first.z + most;
    vec2 b = second.xy / second.z + most;
    vec2 c = third.xy / third.z + most;
    vec2 low = ceil(max(min(min(a, b), c) - kMargin, vec2(0.0)) - 0.5);
    vec2 high = floor(min(max(max(a, b), c) + kMargin, device.viewport.xy) - 0.5);
    if (any(greaterThan(low, high))) {
        return Pixels(low, high, false);
    }
    if (any(greaterThan(high - low, vec2(1.0)))) {
        return Pixels(low, high, true);
    }
    float turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0.0 ? -1.0 : 1.0;
    vec2 near = low + 0.5;
    vec2 far = high + 0.5;
    bool isOnOne = isNear(a, b, c, turn, near) || isNear(a, b, c, turn, vec2(far.x, near.y)) ||
                   isNear(a, b, c, turn, vec2(near.x, far.y)) || isNear(a, b, c, turn, far);
    return Pixels(low, high, isOnOne);
}

// Relative error by which a fragment may be nearer than the nearest corner: a thousand roundings.
const float kNearer = 1.0e-4;

// Tiles of kTileSize pixels per side, row by row from the bottom. The last of a row or column may be partial.
uvec2 tilesOfPicture() {
    return (uvec2(device.viewport.xy) + kTileSize - 1u) / kTileSize;
}

// Whether the depth tiles are nearer than a triangle at every pixel that it may cover. Stored depth (near plane / view
// depth) is linear on the screen, so no point of a triangle is nearer than its nearest corner.
bool isOccluded(Pixels pixels, float nearest) {
    uvec2 from = uvec2(pixels.low) / kTileSize;
    uvec2 count = uvec2(pixels.high) / kTileSize - from + 1u;
    uint tiles = count.x * count.y;
    if (cullMode != kCullOccludees || tiles > kMostTiles) {
        return false;
    }
    float depth = frame.nearPlane / nearest * (1.0 + kNearer);
    uint row = tilesOfPicture().x;
    for (uint i = 0u; i < tiles; ++i) {
        if (tileDepths[(from.y + i / count.x) * row + from.x + i % count.x] <= depth) {
            return false;
        }
    }
    return true;
}

// Whether all three corners, and so the whole visible triangle, are beyond one edge of a rectangle (least and greatest
// x and y, in pixels from the window's middle). Corners are pixels times depth, in which linear tests also hold behind
// the eye.
bool isBeside(vec3 a, vec3 b, vec3 c, vec4 rect) {
    vec3 depths = vec3(a.z, b.z, c.z);
    vec3 across = vec3(a.x, b.x, c.x);
    vec3 up = vec3(a.y, b.y, c.y);
    vec3 spareAcross = kMargin * abs(depths) + kRounding * (abs(across) + device.viewport.x * abs(depths));
    vec3 spareUp = kMargin * abs(depths) + kRounding * (abs(up) + device.viewport.y * abs(depths));
    return all(lessThan(across - rect.x * depths, -spareAcross)) || all(lessThan(up - rect.y * depths, -spareUp)) ||
           all(greaterThan(across - rect.z * depths, spareAcross)) || all(greaterThan(up - rect.w * depths, spareUp));
}

// Whether a triangle may overlap one of its run's rectangles (DrawRun), or the window.
bool isWithin(vec3 a, vec3 b, vec3 c, uint rects) {
    vec4 most = device.viewport.xyxy * 0.5;
    uint count = rects >> 16;
    bool isIn = count == 0u && !isBeside(a, b, c, vec4(-1.0, -1.0, 1.0, 1.0) * (most + 2.0));
    for (uint i = 0u; i < count; ++i) {
        vec4 rect = uintBitsToFloat(ringTexel(device.firstRect + (rects & 0xFFFFu) + i));
        isIn = isIn || !isBeside(a, b, c, rect * most);
    }
    return isIn;
}

bool mayShow(uint vertex, Instance instance, uint rects) {
    vec3 first = eyeFromVertex(vertex, instance);
    if (facesAway(vertex, instance, first)) {
        return false;
    }
    vec3 a = screenFromEye(first);
    vec3 b = screenFromEye(eyeFromVertex(vertex + 1u, instance));
    vec3 c = screenFromEye(eyeFromVertex(vertex + 2u, instance));
    if (!isWithin(a, b, c, rects)) {
        return false;
    }
    float nearest = min(min(a.z, b.z), c.z);
    if (nearest < kNearestPlace) {
        return true;
    }
    Pixels pixels = pixelsOf(a, b, c);
    return pixels.any && !isOccluded(pixels, nearest);
}

shared uint keptBy[kCullThreads];

// The least stored depth of a tile is its farthest point. A triangle farther than that in all its tiles is occluded,
// because the depth test decides.
void coverTile(uint number) {
    uvec2 tiles = tilesOfPicture();
    ivec2 begin = ivec2(number % tiles.x, number / tiles.x) * int(kTileSize);
    ivec2 end = min(begin + int(kTileSize), ivec2(device.viewport.xy));
    float least = 1.0;
    for (int y = begin.y; y < end.y; ++y) {
        for (int x = begin.x; x < end.x; ++x) {
            least = min(least, texelFetch(depthSoFar, ivec2(x, y), 0).r);
        }
    }
    if (number < tiles.x * tiles.y) {
        tileDepths[number] = least;
    }
}

void main() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    if (gl_NumWorkGroups.z == kTileLayers) {
        if (gl_WorkGroupID.z == 0u) {
            coverTile(group * kCullThreads + gl_LocalInvocationID.x);
        }
        return;
    }
    bool isFirst = cullMode == kCullOccluders;
    uint begins = isFirst ? 0u : device.firstOccludee;
    uint ends = isFirst ? device.firstOccludee : device.slotCount;
    // Rows have equal length, so there may be more groups than slots. The surplus repeats the last slot and writes the
    // same values.
    uint slot = min(begins + group, ends - 1u);
    uint rects;
    RunOffsets offsets = offsetsOf(slot, rects);
    DrawPiece piece = pieceAt((slot + offsets.piece) & ~kGated);
    bool drawsStaticIndices = (device.flags & kFrameStaticIndices) != 0u;
    bool neverCulled = (piece.triangles & kNeverCulled) != 0u;
    uint triangles = piece.triangles & ~kNeverCulled;
    Instance instance = instanceAt(neverCulled ? 0u : piece.instance);
    bool isHere = neverCulled || isInLevelRange(instance);
    uint toLookAt = drawsStaticIndices || !isHere ? 0u : triangles;
    uint me = gl_LocalInvocationID.x;
    uint each = (toLookAt + kCullThreads - 1u) / kCullThreads;
    uint begin = min(me * each, toLookAt);
    uint end = min(begin + each, toLookAt);
    uint kept = 0u;
    for (uint i = begin; i < end; ++i) {
        uint vertex = indices[piece.firstIndex + 3u * i];
        kept |= neverCulled || mayShow(vertex - vertex % 3u, instance, rects) ? 1u << (i - begin) : 0u;
    }
    keptBy[me] = bitCount(kept);
    barrier();
    uint before = 0u;
    uint all = 0u;
    for (uint thread = 0u; thread < kCullThreads; ++thread) {
        before = thread == me ? all : before;
        all += keptBy[thread];
    }
    uint first = piece.indicesBefore + offsets.kept;
    uint to = first + 3u * before;
    while (kept != 0u) {
        uint i = begin + uint(findLSB(kept));
        kept &= kept - 1u;
        uint from = piece.firstIndex + 3u * i;
        keptIndices[to] = indices[from];
        keptIndices[to + 1u] = indices[from + 1u];
        keptIndices[to + 2u] = indices[from + 2u];
        to += 3u;
    }
    if (me == 0u) {
        uint command = slot * kWordsPerCommand;
        uint drawn = drawsStaticIndices && isHere ? triangles : all;
        commands[command] = 3u * drawn;
        commands[command + 1u] = drawn > 0u ? 1u : 0u;
        commands[command + 2u] = drawsStaticIndices ? piece.firstIndex : first;
        commands[command + 3u] = 0u;
        commands[command + 4u] = neverCulled ? piece.instance : recordOf(piece.instance) | (offsets.piece & kGated);
    }
}
