// Detail pictures: a grain that is repeated over the ground, exteriors and shells near the eye
// (docs/formats/textures.md#detail-pictures). After textures.glsl.

// Metres of view depth between which the grain of the ground fades.
const float kGrainFullTo = 10.0;
const float kNoGrainFrom = 50.0;

// Colour of a wall under its grain: destination times source, plus destination times (1 - source alpha).
vec3 grained(vec3 colour, vec4 grain) {
    return colour * (1.0 + grain.rgb - grain.a);
}

// Colour of the ground under its grain, which covers it by its alpha.
vec3 grainedGround(vec3 colour, vec4 grain, float viewDepth) {
    float share = clamp((kNoGrainFrom - viewDepth) / (kNoGrainFrom - kGrainFullTo), 0.0, 1.0);
    return mix(colour, grain.rgb, grain.a * share);
}

#ifndef FAST
// Texels of one of the detail pictures, which exists.
vec4 grainTexels(uint detail, vec2 uv, vec2 dx, vec2 dy) {
    float tiling = frame.detailTiling[detail];
    return sampleTexture(frame.detailTextures[detail], uv * tiling, dx * tiling, dy * tiling);
}

uint detailOf(uint kind) {
    return kind == kKindShell ? kDetailOfShells : kind == kKindExterior ? kDetailOfExteriors : kNoDetail;
}
#endif
