// Stage 1: the openings, in tree order. No vertex input: corners are pulled by gl_VertexID.
// In: the corners of an opening in block-local metres (the same transform as the walls around it), or a clip set alone.
// Out: clip position; the visit's number; what tells whether a ray passes the opening and those before it.
// EXACT: openings are drawn a little larger than they are, and fragments beside them dropped (outline.glsl).
//
// Depth is 0 (infinitely far) for every corner: portals are met at any distance, so that neither the near nor the far
// plane may cut them, and the stage has no depth buffer. What is left is the cut at w = 0, the eye's plane.
#include "transform.glsl"

invariant gl_Position;
layout(location = 0) flat out uint vVisit;
layout(location = 1) flat out uvec3 vOpening; // first vertex of the fan, number of corners (0: none), clip set
layout(location = 2) flat out vec4 vPlane;    // the opening's: dot(vPlane.xyz, p) = vPlane.w
layout(location = 3) flat out uint vCovers;   // 1: drawn around the whole window

uvec3 opening = uvec3(0u);
vec4 plane = vec4(0.0); // vPlane
#include "openingcorner.glsl"
#include "grow.glsl"

const float kNearest = 1.0e-4; // metres: openings are met at any distance

vec4 planeOfOutline() {
    vec3 origin = outlineCorner(0u);
    vec3 sum = vec3(0.0);
    for (uint i = 2u; i < opening.y; ++i) {
        sum += cross(outlineCorner(i - 1u) - origin, outlineCorner(i) - origin);
    }
    float size = length(sum);
    vec3 normal = size > 0.0 ? sum / size : vec3(0.0);
    return vec4(normal, dot(normal, origin));
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
    uint role = part % 3u; // the middle, the corner that has the triangle's number, the next
    Thin thin = thinAt(opening.y, part < 3u ? role : 2u, kNearest); // of the whole fan one triangle stays
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
    vVisit = corner.visit;
    opening = uvec3(corner.outlineFirst, corner.outlineCount & ~kCoverWindow, corner.clipSet);
    vOpening = opening;
    if (opening.y > 0u) {
        plane = planeOfOutline();
    }
    vPlane = plane;
    vCovers = (corner.outlineCount & kCoverWindow) != 0u ? 1u : 0u;
    if (vCovers != 0u) {
        gl_Position = everywhere(min(part, 3u));
        return;
    }
    vec4 clip = clipFromEye(eyeFromBlock(corner.position, corner.rest, corner.block));
    gl_Position = vec4(clip.xy, 0.0, clip.w);
#ifdef EXACT
    drawLarger(part);
#endif
}
