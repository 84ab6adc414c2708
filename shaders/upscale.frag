// Enlarges the drawn picture to the window's size. Out: colour.
// The square between four texels is split into two triangles along the diagonal whose ends differ less. An edge between
// two colours runs along that diagonal, so no triangle mixes both sides of it.
#include "SharedLayout.h"
#include "varyings.glsl"

layout(binding = kUnitPicture) uniform sampler2D picture;

layout(location = kVaryingTexel) in vec2 vTexel;
layout(location = kOutputColour) out vec4 outColour;

// Share of a texel's width in which colours change; 1: linear. Less is sharper, with larger steps along edges.
const float kRamp = 0.75;

void main() {
    vec2 place = vTexel - 0.5;
    vec2 low = floor(place);
    vec2 part = clamp((place - low - 0.5) / kRamp + 0.5, 0.0, 1.0);
    ivec2 last = textureSize(picture, 0) - 1;
    ivec2 from = clamp(ivec2(low), ivec2(0), last);
    ivec2 to = min(ivec2(low) + 1, last);
    vec3 a = texelFetch(picture, from, 0).rgb;
    vec3 b = texelFetch(picture, ivec2(to.x, from.y), 0).rgb;
    vec3 c = texelFetch(picture, ivec2(from.x, to.y), 0).rgb;
    vec3 d = texelFetch(picture, to, 0).rgb;
    vec3 rising = abs(a - d), falling = abs(b - c);
    bool isRising = rising.r + rising.g + rising.b < falling.r + falling.g + falling.b;
    // Mirrored so that the diagonal always runs from the first corner to the last.
    float x = isRising ? part.x : 1.0 - part.x;
    vec3 first = isRising ? a : b, right = isRising ? b : a;
    vec3 up = isRising ? c : d, far = isRising ? d : c;
    vec3 side = x > part.y ? right : up;
    float most = max(x, part.y), least = min(x, part.y);
    outColour = vec4(first * (1.0 - most) + side * (most - least) + far * least, 1.0);
}
