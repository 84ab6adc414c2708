// Stage 1: writes the number of the visit that owns the pixel. A later polygon is a nearer one.
// The clip set is tested here and not by gl_ClipDistance: clipping makes new vertices, and edges through new vertices
// are no longer exactly the edges of the walls beside them. Discarding leaves the polygon's own edges untouched.
// MULTISAMPLED: each sample of the pixel is tested for itself.
#include "SharedLayout.h"
#ifdef MULTISAMPLED
#include "samples.glsl"
#endif

layout(location = 0) flat in uint vVisit;
layout(location = 1) in vec4 vClipLow;
layout(location = 2) in vec4 vClipHigh;
layout(location = 0) out uint outVisit;

bool isClipped(vec4 low, vec4 high) {
    return any(lessThan(low, vec4(0.0))) || any(lessThan(high, vec4(0.0)));
}

void main() {
#ifdef MULTISAMPLED
    uint kept = 0u;
    for (int i = 0; i < int(kSamples); ++i) {
        bool clipped = isClipped(atSample(vClipLow, sampleOffset(i)), atSample(vClipHigh, sampleOffset(i)));
        kept |= clipped ? 0u : 1u << i;
    }
    gl_SampleMask[0] = int(kept);
    bool isGone = kept == 0u;
#else
    bool isGone = isClipped(vClipLow, vClipHigh);
#endif
    if (isGone) {
        discard;
    }
    outVisit = vVisit;
}
