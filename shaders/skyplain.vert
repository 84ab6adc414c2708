// One triangle over the whole screen, behind everything. Out: view direction in world axes, unnormalised.
#include "buffers.glsl"

layout(location = kVaryingDirection) out vec3 vDirection;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 nearPoint = inverse(frame.clipFromEye) * vec4(corner, 1.0, 1.0);
    vDirection = nearPoint.xyz / nearPoint.w;
    gl_Position = vec4(corner, kSkyDepth, 1.0);
}
