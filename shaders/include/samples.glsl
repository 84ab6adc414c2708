// Where on the window a fragment is asked for. MULTISAMPLED: fragments are shaded for each sample of their pixel, for that
// each has a ray, an owner and a depth of its own; whoever reads gl_SampleID has the whole shader run so.
#include "buffers.glsl"

// SMOOTH: of what is interpolated; drivers want it the same in both stages.
#ifdef MULTISAMPLED
#define SMOOTH sample
#else
#define SMOOTH
#endif

#ifdef FRAGMENT_STAGE
#ifdef LIMEN_WITHOUT_BESIDE // tests show that it is needed (docs/proof.md)
const vec2 kBeside = vec2(0.0);
#else
const vec2 kBeside = vec2(kBesideX, kBesideY) / float(kPartsOfAPixel);
#endif

vec2 windowPlace() {
#ifdef MULTISAMPLED
    uvec2 offset = uvec2(device.samplesX, device.samplesY) >> (8 * gl_SampleID) & 0xFFu;
    return floor(gl_FragCoord.xy) + vec2(offset) / 256.0;
#else
    return gl_FragCoord.xy + kBeside;
#endif
}
#endif
