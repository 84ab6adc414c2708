// Stage 1: the openings, in tree order. No vertex input: corners are fetched by gl_VertexID.
// In: the corners of an opening in block-local metres (the same transform as the walls around it), or a clip set alone.
// Out: clip position; the visit's number; the values that the fragment stage tests rays with.
// EXACT: openings are drawn slightly larger, and fragments outside are discarded (outline.glsl).
//
// Depth is 0 (infinitely far) for every corner: a ray passes a portal at any distance, so neither the near nor the far
// plane may clip it, and the stage has no depth buffer. The only remaining clipping is at w = 0, the eye's plane.
#include "transform.glsl"
#ifdef FAST
#include "wide.glsl"
#endif

invariant gl_Position;
layout(location = kVaryingVisit) flat out uint vVisit;
layout(location = kVaryingOpening) flat out uvec3 vOpening; // first vertex of the fan, number of corners (0: none), clip set
layout(location = kVaryingPlane) flat out vec4 vPlane;    // the opening's: dot(vPlane.xyz, p) = vPlane.w
layout(location = kVaryingCovers) flat out uint vCovers;   // 1: drawn around the whole window
#ifdef FAST
layout(location = kVaryingClip) flat out uvec3 vClip; // coverage.glsl
#endif

uvec3 opening = uvec3(0u);
vec4 plane = vec4(0.0); // vPlane
#include "openingcorner.glsl"
#include "grow.glsl"

const float kNearest = 1.0e-4; // metres: an opening may be at any distance

#ifdef FAST
uvec3 clipOf(OwnershipVertex corner) {
    return uvec3(corner.clipSet, corner.clipEdges, corner.clipSet == 0u ? 1u : corner.clipEdges + 1u);
}
#endif

// The plane of the flood. The outline alone does not give it: corners may be off one plane by more than the eye.
vec4 planeOfVisit(uint visit) {
    vec4 entry = entryPlaneAt(visit);
    return vec4(-entry.xyz, entry.w);
}

uint zoneOfVisit(uint visit) {
    return ringTexel(device.firstVisit + visit * kVisitTexels + 1u).x;
}

// One triangle around the whole window.
vec4 everywhere(uint part) {
    return vec4(part == 1u ? 3.0 : -1.0, part == 2u ? 3.0 : -1.0, 0.0, 1.0);
}

#ifdef EXACT
Growth growthOf(uint own, out vec3 before, out vec3 at, out vec3 after) {
    at = outlineCorner(own);
    before = outlineCorner(own == 0u ? opening.y - 1u : own - 1u);
    after = outlineCorner(own + 1u == opening.y ? 0u : own + 1u);
    return growthAt(clipFromEye(before), clipFromEye(at), clipFromEye(after), plane.w < 0.0);
}

bool anyFails() {
    vec3 before;
    vec3 at;
    vec3 after;
    for (uint i = 0u; i < opening.y; ++i) {
        if (growthOf(i, before, at, after).fails) {
            return true;
        }
    }
    return false;
}

vec4 grownCorner(uint own) {
    vec3 before;
    vec3 at;
    vec3 after;
    Growth growth = growthOf(own, before, at, after);
    at += growth.before * (at - before) + growth.after * (at - after);
    vec4 clip = clipFromEye(at);
    clip.xy += growth.shift * clip.w / (device.viewport.xy * 0.5);
    return clip;
}

// `part`: the vertex's number in the fan.
void drawLarger(uint part) {
    uint role = part % 3u; // 0: the middle; 1: the corner with the triangle's number; 2: the next corner
    Thin thin = thinAt(opening.y, part < 3u ? role : 2u, kNearest); // one triangle of the whole fan remains
    if (thin.is) {
        gl_Position = vec4(thin.at / (device.viewport.xy * 0.5), 0.0, 1.0);
    } else if (anyFails()) {
        gl_Position = everywhere(min(part, 3u));
    } else if (role != 0u) {
        vec4 clip = grownCorner((part / 3u + role - 1u) % opening.y);
        gl_Position = vec4(clip.xy, 0.0, clip.w);
    }
}
#endif

void main() {
    OwnershipVertex corner = ownershipVertices[gl_VertexID];
    uint part = uint(gl_VertexID) - corner.outlineFirst;
    vVisit = corner.visit | (zoneOfVisit(corner.visit) == kOutside ? kOwnedOutside : 0u);
    opening = uvec3(corner.outlineFirst, corner.outlineCount & ~kCoverWindow, corner.clipSet);
    vOpening = opening;
    if (opening.y > 0u) {
        plane = planeOfVisit(corner.visit);
    }
    vPlane = plane;
    bool covers = (corner.outlineCount & kCoverWindow) != 0u;
    vCovers = covers ? 1u : 0u;
    bool isOnScreen = false;
#ifdef FAST
    vClip = clipOf(corner);
    isOnScreen = (corner.outlineCount & kOnScreen) != 0u;
#endif
    if (isOnScreen) {
        gl_Position = vec4(corner.position.xy, 0.0, corner.position.z);
    } else if (covers) {
        gl_Position = everywhere(min(part, 3u));
    } else {
        vec4 clip = clipFromEye(eyeFromBlock(corner.position, corner.rest, corner.block));
        gl_Position = vec4(clip.xy, 0.0, clip.w);
#ifdef EXACT
        drawLarger(part);
#endif
    }
#ifdef FAST
    gl_Position = widened(gl_Position);
#endif
}
