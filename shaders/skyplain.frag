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

const ivec2 kAround[8] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1), ivec2(-1, -1), ivec2(1, -1),
                                 ivec2(-1, 1), ivec2(1, 1));

// This draw writes no pixel with a depth, so neighbours with one can be read.
void fillVoid() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(drawnDepth, 0) - 1;
    for (int i = 0; i < 8; ++i) {
        ivec2 at = clamp(here + kAround[i], ivec2(0), last);
        if (texelFetch(drawnDepth, at, 0).r > 0.0) {
            outColour = texelFetch(drawnColour, at, 0);
#ifdef WITH_ID
            outId = texelFetch(drawnIds, at, 0).r;
#endif
            return;
        }
    }
    discard;
}
#endif

void main() {
#ifdef FILLS_VOIDS
    if (!keepOutside()) {
        fillVoid();
        return;
    }
#elif !defined(FAST) || defined(GATED)
    if (!keepOutside()) {
        discard;
    }
#endif
#ifdef FLAT
    outColour = colourOfId(kSkyId);
#else
    // The square root lowers the zenith's colour: haze is thick only near the horizon.
    float height = sqrt(clamp(normalize(vDirection).z, 0.0, 1.0));
    outColour = vec4(mix(frame.fogColour.rgb, frame.skyZenith.rgb, height), 1.0);
#endif
#ifdef WITH_ID
    outId = kSkyId;
#endif
}
