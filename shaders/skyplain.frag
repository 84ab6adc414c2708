// The plain sky: pixels without a surface whose ray ended outside. Out: gradient from horizon to zenith; the sky's id.
// FLAT: colour of the id. FAST: the ownership test only if GATED, the id only with IDS.
// FAST, GATED, one sample a pixel: other pixels without a surface take the colour and id of a neighbour. They are cracks,
// where corners of adjacent surfaces were rounded apart.
#include "gate.glsl"
#include "idcolour.glsl"

layout(location = kVaryingDirection) in vec3 vDirection;
layout(location = kOutputColour) out vec4 outColour;
#if !defined(FAST) || defined(IDS)
#define WITH_ID
layout(location = kOutputId) out uint outId;
#endif

#if defined(FAST) && defined(GATED) && !defined(MULTISAMPLED)
#define FILLS_VOIDS
layout(binding = kUnitDepth) uniform sampler2D drawnDepth;
layout(binding = kUnitColour) uniform sampler2D drawnColour;
#ifdef WITH_ID
layout(binding = kUnitId) uniform usampler2D drawnIds;
#endif

const int kNeighbours = 8;
const ivec2 kAround[kNeighbours] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1),
                                 ivec2(-1, 1), ivec2(1, 1));

// Fills from a neighbour that has a surface, unless `hasSky`. False if there is none. This draw writes no pixel with a
// depth, so such a neighbour can be read. The loop has no turn for a pixel of the sky: drivers that execute every branch
// for all pixels still leave a loop early.
bool fillVoid(bool hasSky) {
    ivec2 last = textureSize(drawnDepth, 0) - 1;
    int i = hasSky ? kNeighbours : 0;
    bool isFilled = false;
    while (i < kNeighbours) {
        ivec2 at = clamp(ivec2(gl_FragCoord.xy) + kAround[i], ivec2(0), last);
        ++i;
        if (texelFetch(drawnDepth, at, 0).r > 0.0) {
            outColour = texelFetch(drawnColour, at, 0);
#ifdef WITH_ID
            outId = texelFetch(drawnIds, at, 0).r;
#endif
            isFilled = true;
            i = kNeighbours;
        }
    }
    return isFilled;
}
#endif

vec4 skyColour() {
#ifdef FLAT
    return colourOfId(kSkyId);
#else
    // The square root lowers the zenith's colour: haze is thick only near the horizon.
    float height = sqrt(clamp(normalize(vDirection).z, 0.0, 1.0));
    return vec4(mix(frame.fogColour.rgb, frame.skyZenith.rgb, height), 1.0);
#endif
}

void main() {
    outColour = skyColour();
#ifdef WITH_ID
    outId = kSkyId;
#endif
#if defined(FAST) && !defined(GATED)
    return;
#else
    bool hasSky = keepOutside();
#ifdef FILLS_VOIDS
    hasSky = fillVoid(hasSky) || hasSky;
#endif
    if (!hasSky) {
        discard;
    }
#endif
}
