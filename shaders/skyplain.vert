// Triangles over the whole screen, or over rectangles, behind everything. Out: view direction in world axes, unnormalised.
// CLIPPED: each triangle is clipped by the clip set with its number. VOIDS: for voids.frag, before the sky.
// CLEARING: for clearing.frag, with the depth of a pixel without a surface.
#include "buffers.glsl"
#include "clip.glsl"
#ifdef FAST
#include "wide.glsl"
#endif

layout(location = kVaryingDirection) out vec3 vDirection;

// Vertices from kSkyRectVertices on: six for each rectangle of the plan.
vec2 cornerOf(uint vertex) {
    uint part = vertex % 3u;
    if (vertex < kSkyRectVertices) {
        return vec2(part == 1u ? 3.0 : -1.0, part == 2u ? 3.0 : -1.0);
    }
    uint rectVertex = vertex - kSkyRectVertices;
    vec4 rect = uintBitsToFloat(ringTexel(device.firstRect + rectVertex / 6u));
    uint corner = part + (part > 0u ? rectVertex / 3u % 2u : 0u); // 0, 1, 2 and 0, 2, 3 around the rectangle
    return vec2(corner == 1u || corner == 2u ? rect.z : rect.x, corner >= 2u ? rect.w : rect.y);
}

void main() {
    vec2 corner = cornerOf(uint(gl_VertexID));
    vec4 nearPoint = inverse(frame.clipFromEye) * vec4(corner, 1.0, 1.0);
    vDirection = nearPoint.xyz / nearPoint.w;
#ifdef VOIDS
    gl_Position = vec4(corner, kVoidDepth, 1.0);
#elif defined(CLEARING)
    gl_Position = vec4(corner, 0.0, 1.0);
#else
    gl_Position = vec4(corner, kSkyDepth, 1.0);
#endif
    clipBy(uint(gl_VertexID) / 3u);
#ifdef FAST
    gl_Position = widened(gl_Position);
#endif
}
