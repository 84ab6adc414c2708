// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one.
// The clip set is tested here and not by gl_ClipDistance: clipping makes new vertices, and edges through new vertices
// are no longer exactly the edges of the walls beside them.
// EXACT: the opening's own edges are tested, too, as those of the walls are (outline.glsl).
#define OWNERSHIP
#include "transform.glsl"
#include "ray.glsl"
#include "samples.glsl"

layout(location = 0) flat in uint vVisit;
layout(location = 1) flat in uvec3 vOpening;
layout(location = 2) flat in vec4 vPlane;
layout(location = 3) flat in uint vCovers;
layout(location = 0) out uint outVisit;

uvec3 opening = uvec3(0u);
#include "openingcorner.glsl"

vec3 cornerOnScreen(uint i) {
    return screenFromEye(outlineCorner(i));
}
#include "outline.glsl"

// Without EXACT the rasteriser has decided, unless something larger was drawn.
bool testsOutline() {
#ifdef EXACT
    return opening.y > 0u;
#else
    return opening.y > 0u && vCovers != 0u;
#endif
}

// All but the last of the planes pass through the eye.
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
    if (!passes(windowPlace())) {
        discard;
    }
    outVisit = vVisit;
}
