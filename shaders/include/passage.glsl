// Whether the ray through a point of the window passes an opening drawn by ownership.vert.
// EXACT: the opening's own edges are tested like those of walls (outline.glsl).
#define OWNERSHIP
#include "transform.glsl"
#include "ray.glsl"
#include "samples.glsl"

layout(location = kVaryingVisit) flat in uint vVisit;
layout(location = kVaryingOpening) flat in uvec3 vOpening;
layout(location = kVaryingPlane) flat in vec4 vPlane;
layout(location = kVaryingCovers) flat in uint vCovers;

uvec3 opening = uvec3(0u);
#include "openingcorner.glsl"

vec3 cornerOnScreen(uint i) {
    return screenFromEye(outlineCorner(i));
}
#include "outline.glsl"

// The corners of an opening close to the eye, in double (close.glsl).
dvec3 exactCorner(uint i) {
    OwnershipVertex corner = ownershipVertices[opening.x + 3u * i + 1u];
    return ((dvec3(corner.position) + dvec3(corner.rest)) + dvec3(blockOrigin(corner.block)) -
            dvec3(frame.eyeHigh.xyz)) - dvec3(frame.eyeLow.xyz);
}

struct Passage {
    float depth; // where the ray crosses the opening's plane; not positive: never
    bool isOver; // the ray passes over the outline
};

// Of such an opening; isOver as by isOverOutline().
Passage exactPassage(vec3 direction) {
    dvec3 ray = dvec3(direction);
    dvec3 toRight = cross(dvec3(device.rayUp.xyz), ray);
    dvec3 toTop = cross(ray, dvec3(device.rayRight.xyz));
    dvec3 corner = exactCorner(opening.y - 1u);
    bool inside = false;
    for (uint i = 0u; i < opening.y; ++i) {
        dvec3 next = exactCorner(i);
        dvec2 from = dvec2(dot(corner, toRight), dot(corner, toTop));
        dvec2 to = dvec2(dot(next, toRight), dot(next, toTop));
        if ((from.y < 0.0LF) != (to.y < 0.0LF)) {
            dvec2 below = from.y < 0.0LF ? from : to;
            dvec2 above = from.y < 0.0LF ? to : from;
            inside = inside != (below.x * above.y - above.x * below.y > 0.0LF);
        }
        corner = next;
    }
    return Passage(float(double(vPlane.w) / dot(dvec3(vPlane.xyz), ray)), inside);
}

Passage passageOf(vec3 direction, vec2 window) {
#ifdef EXACT
    Passage found = Passage(0.0, false);
    bool isClose = vCovers != 0u;
    for (uint turn = 0u; turn < (isClose ? 1u : 0u); ++turn) {
        found = exactPassage(direction);
    }
    if (isClose) {
        return found;
    }
#endif
    return Passage(vPlane.w / dot(vPlane.xyz, direction), isOverOutline(opening.y, window));
}

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

// The ray through a point of the window at the opening; isOver: it passes the opening within the clip set.
Passage passageAt(vec2 window) {
    vec3 direction = rayThrough(window);
    Passage passage = opening.y > 0u ? passageOf(direction, window) : Passage(1.0, true);
    passage.isOver = passage.depth > 0.0 && !isClipped(clipSets[opening.z], direction, passage.depth) &&
                     (!testsOutline() || passage.isOver);
    return passage;
}
