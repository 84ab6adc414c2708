// Stage 1: the portal polygons, in tree order. No vertex input: corners are pulled by gl_VertexID.
// In: block-local metres (the same transform as the walls around the opening), or clip x, y, w of a screen polygon.
// Out: clip position; the visit's number; distances to the clip set's planes.
//
// Depth is 0 (infinitely far) for every corner: portals are met at any distance, so that neither the near nor the far
// plane may cut them, and the stage has no depth buffer. What is left is the cut at w = 0, the eye's plane.
#include "transform.glsl"

invariant gl_Position;
layout(location = 0) flat out uint vVisit;
layout(location = 1) out vec4 vClipLow;
layout(location = 2) out vec4 vClipHigh;

vec4 distances(ClipSet set, int first, vec3 p) {
    vec4 at = vec4(p, 1.0);
    return vec4(dot(set.planes[first], at), dot(set.planes[first + 1], at), dot(set.planes[first + 2], at),
                dot(set.planes[first + 3], at));
}

void main() {
    OwnershipVertex corner = ownershipVertices[gl_VertexID];
    vVisit = corner.visit;
    if (corner.block == kNoVisit) {
        gl_Position = vec4(corner.position.xy, 0.0, corner.position.z);
        vClipLow = vec4(1.0);
        vClipHigh = vec4(1.0);
    } else {
        vec3 eyeRelative = eyeFromBlock(corner.position, corner.block);
        vec4 clip = clipFromEye(eyeRelative);
        gl_Position = vec4(clip.xy, 0.0, clip.w);
        ClipSet set = clipSets[corner.clipSet];
        vClipLow = distances(set, 0, eyeRelative);
        vClipHigh = distances(set, 4, eyeRelative);
    }
}
