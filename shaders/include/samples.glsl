// Window position that a fragment is evaluated at: pixels from the lower left corner of the whole picture. A target can
// be a tile of it, whose origin is a whole number of pixels, so that all sums here are exact. MULTISAMPLED: fragments are shaded per sample, because each sample
// has its own ray, owner and depth. Reading gl_SampleID enables per-sample shading.
#include "buffers.glsl"

// SMOOTH: interpolation qualifier; drivers require the same in both stages.
#ifdef MULTISAMPLED
#define SMOOTH sample
#else
#define SMOOTH
#endif

#ifdef FRAGMENT_STAGE
#ifdef LIMEN_WITHOUT_BESIDE // tests show the effect of leaving this out (docs/proof.md)
const vec2 kBeside = vec2(0.0);
#else
const vec2 kBeside = vec2(kBesideX, kBesideY) / float(kPartsOfAPixel);
#endif

vec2 pixelOfPicture() {
    return gl_FragCoord.xy + vec2(device.windowOrigin & 0xFFFFu, device.windowOrigin >> 16);
}

vec2 windowPosition() {
#ifdef MULTISAMPLED
    uvec2 offset = uvec2(device.samplesX, device.samplesY) >> (8 * gl_SampleID) & 0xFFu;
    return floor(pixelOfPicture()) + vec2(offset) / 256.0;
#else
    return pixelOfPicture() + kBeside;
#endif
}
#endif
