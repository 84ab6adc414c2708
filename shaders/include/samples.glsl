// A fragment's values at the samples of its pixel (MULTISAMPLED).
//
// What perspective interpolation divides by is linear on the screen, and so is what it divides: both are carried from
// the pixel's centre to the sample by their derivatives, exactly however much the surface recedes across the pixel, and
// even where the centre lies beyond the triangle or behind the eye. interpolateAtSample ought to yield the same; on
// llvmpipe it is off by more than the gate's tolerance.
#include "buffers.glsl"

// From the pixel's centre, in pixels.
vec2 sampleOffset(int i) {
    uvec2 at = uvec2(frame.samplesX, frame.samplesY) >> (8 * i) & 0xFFu;
    return vec2(at) / 256.0 - 0.5;
}

// One over the view depth at a sample.
float inverseDepthAt(vec2 offset) {
    float q = gl_FragCoord.w;
    return q + dFdx(q) * offset.x + dFdy(q) * offset.y;
}

vec4 atSample(vec4 value, vec2 offset) {
    vec4 scaled = value * gl_FragCoord.w;
    return (scaled + dFdx(scaled) * offset.x + dFdy(scaled) * offset.y) / inverseDepthAt(offset);
}

vec3 atSample(vec3 value, vec2 offset) {
    return atSample(vec4(value, 0.0), offset).xyz;
}

vec2 atSample(vec2 value, vec2 offset) {
    return atSample(vec4(value, 0.0, 0.0), offset).xy;
}
