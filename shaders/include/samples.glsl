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
// Pixels from its centre that a pixel is asked for. Eyes stand in the planes of walls and over edges, and what is built on a grid
// lies at angles that pixels' centres lie at, too: rays through centres then pass along edges, one behind the other, and each
// decides for itself by roundings which side it is on. No such line passes here.
#ifdef LIMEN_WITHOUT_BESIDE // tests show that it is needed (docs/proof.md)
const vec2 kBeside = vec2(0.0);
#else
const vec2 kBeside = vec2(0.00073, 0.00031);
#endif

vec2 windowPlace() {
#ifdef MULTISAMPLED
    uvec2 offset = uvec2(frame.samplesX, frame.samplesY) >> (8 * gl_SampleID) & 0xFFu;
    return floor(gl_FragCoord.xy) + vec2(offset) / 256.0;
#else
    return gl_FragCoord.xy + kBeside;
#endif
}
#endif
