#pragma once

namespace limen::bench {

// The shaders of the plain renderer. CUT_OUT and BLENDED are the variants of the fragment shader.

inline constexpr const char* kPlainVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in mat4 placement;
layout(location = 0) uniform mat4 clipFromScene;
layout(location = 1) uniform vec3 towardsSun;
layout(location = 2) uniform vec3 sunColour;
layout(location = 3) uniform vec3 ambient;
layout(location = 4) uniform vec4 colour;
layout(location = 5) uniform float luminosity;
layout(location = 0) out vec4 vColour;
layout(location = 1) out vec2 vUv;

void main() {
    vec3 facing = normalize(mat3(placement) * normal);
    vec3 light = clamp(luminosity + ambient + sunColour * max(dot(facing, towardsSun), 0.0), 0.0, 1.0);
    vColour = vec4(colour.rgb * light, colour.a);
    vUv = uv;
    gl_Position = clipFromScene * (placement * vec4(position, 1.0));
}
)";

inline constexpr const char* kPlainFragmentShader = R"(
layout(location = 0) in vec4 vColour;
layout(location = 1) in vec2 vUv;
layout(binding = 0) uniform sampler2D picture;
#ifdef BLENDED
layout(location = 6) uniform float inverted; // 1: one minus the texture's alpha
layout(location = 7) uniform float added;    // 1: the surface hides nothing
#endif
layout(location = 0) out vec4 outColour;

void main() {
    vec4 texel = texture(picture, vUv);
#ifdef CUT_OUT
    if (texel.a < 0.5) {
        discard;
    }
#endif
#ifdef BLENDED
    float alpha = mix(texel.a, 1.0 - texel.a, inverted) * vColour.a;
    outColour = vec4(vColour.rgb * texel.rgb * alpha, mix(alpha, 0.0, added));
#else
    outColour = vec4(vColour.rgb * texel.rgb, 1.0);
#endif
}
)";

} // namespace limen::bench
