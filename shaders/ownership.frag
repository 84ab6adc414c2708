// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one. The clip set is tested
// here, not by gl_ClipDistance: clipping creates vertices, and edges through new vertices no longer coincide exactly
// with the edges of adjacent walls.
// EXACT: the opening's own edges are tested like those of walls (outline.glsl).
#define OWNERSHIP
#include "transform.glsl"
#include "ray.glsl"
#include "samples.glsl"

layout(location = kVaryingVisit) flat in uint vVisit;
layout(location = kVaryingOpening) flat in uvec3 vOpening;
layout(location = kVaryingPlane) flat in vec4 vPlane;
layout(location = kVaryingCovers) flat in uint vCovers;
layout(location = kOutputVisit) out uint outVisit;

uvec3 opening = uvec3(0u);
#include "openingcorner.glsl"

vec3 cornerOnScreen(uint i) {
    return screenFromEye(outlineCorner(i));
}
#include "outline.glsl"

// Without EXACT the rasteriser's coverage decides, unless a larger shape was drawn.
bool testsOutline() {
#ifdef EXACT
    return opening.y > 0u;
#else
    return opening.y > 0u && vCovers != 0u;
#endif
}

// All planes but the last pass through the eye.
bool isClipped(ClipSet set, vec3 direction, float depth) {
    for (int i = 0; i < 7; ++i) {
        if (dot(set.planes[i].xyz, direction) + set.planes[i].w < 0.0) {
            return true;
        }
    }
    return dot(set.planes[7].xyz, direction) * depth + set.planes[7].w < 0.0;
}

// Whether the ray through a point of the window passes the opening.
bool passes(vec2 window) {
    vec3 direction = rayThrough(window);
    float depth = opening.y > 0u ? vPlane.w / dot(vPlane.xyz, direction) : 1.0;
    return depth > 0.0 && !isClipped(clipSets[opening.z], direction, depth) &&
           (!testsOutline() || isOverOutline(opening.y, window));
}

void main() {
    opening = vOpening;
    if (!passes(windowPosition())) {
        discard;
    }
    outVisit = vVisit;
}
