// Voids of the fast way of drawing: pixels without a surface whose ray did not end outside. They are cracks, where corners of
// adjacent surfaces were rounded apart, or holes of the data. Out: colour and id (IDS) of a neighbour that has a surface, else
// those of a void; FLAT: its colour by id. The depth is before the sky's (skyplain.vert), so later draws of the sky need no test.
// MULTISAMPLED: voids are not filled, because a shader reads one sample a pixel.
#include "gate.glsl"
#include "idcolour.glsl"

layout(location = kOutputColour) out vec4 outColour;
#ifdef IDS
layout(location = kOutputId) out uint outId;
#endif

#ifndef MULTISAMPLED
layout(binding = kUnitDepth) uniform sampler2D drawnDepth;
layout(binding = kUnitColour) uniform sampler2D drawnColour;
#ifdef IDS
layout(binding = kUnitId) uniform usampler2D drawnIds;
#endif

const int kNeighbours = 8;
const ivec2 kAround[kNeighbours] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1),
                                 ivec2(-1, 1), ivec2(1, 1));

// Fills `isVoid` pixels from a neighbour that has a surface. This draw writes no such neighbour. Its depth tells it from
// another void, whichever of the two is drawn first. The loop has no turn for a pixel of the sky: drivers that execute every
// branch for all pixels then execute its body once.
void fill(bool isVoid) {
    ivec2 last = textureSize(drawnDepth, 0) - 1;
    int i = isVoid ? 0 : kNeighbours;
    while (i < kNeighbours) {
        ivec2 at = clamp(ivec2(gl_FragCoord.xy) + kAround[i], ivec2(0), last);
        ++i;
        if (texelFetch(drawnDepth, at, 0).r > kVoidDepth) {
            outColour = texelFetch(drawnColour, at, 0);
#ifdef IDS
            outId = texelFetch(drawnIds, at, 0).r;
#endif
            i = kNeighbours;
        }
    }
}
#endif

void main() {
    bool isVoid = frame.visitCount == 1u || !keepOutside(); // one visit: to a cell
#ifdef FLAT
    outColour = colourOfId(kVoidId);
#else
    outColour = frame.voidColour;
#endif
#ifdef IDS
    outId = kVoidId;
#endif
#ifndef MULTISAMPLED
    fill(isVoid);
#endif
    if (!isVoid) {
        discard;
    }
}
