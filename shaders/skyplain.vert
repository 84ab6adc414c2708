// Triangles over the whole screen, behind everything. Out: view direction in world axes, unnormalised. CLIPPED: each
// triangle is clipped by the clip set with its number.
#include "buffers.glsl"
#include "clip.glsl"

layout(location = kVaryingDirection) out vec3 vDirection;

void main() {
    int part = gl_VertexID % 3;
    vec2 corner = vec2(part == 1 ? 3.0 : -1.0, part == 2 ? 3.0 : -1.0);
    vec4 nearPoint = inverse(frame.clipFromEye) * vec4(corner, 1.0, 1.0);
    vDirection = nearPoint.xyz / nearPoint.w;
    gl_Position = vec4(corner, kSkyDepth, 1.0);
    clipBy(uint(gl_VertexID) / 3u);
}
