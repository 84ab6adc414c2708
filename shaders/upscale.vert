// One triangle over the whole window. Out: place in the drawn picture, in texels from its lower left corner.
#include "SharedLayout.h"
#include "varyings.glsl"

layout(binding = kUnitPicture) uniform sampler2D picture;

layout(location = kVaryingTexel) out vec2 vTexel;

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vTexel = (corner * 0.5 + 0.5) * vec2(textureSize(picture, 0));
    gl_Position = vec4(corner, 0.0, 1.0);
}
