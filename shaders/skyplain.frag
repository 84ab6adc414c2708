// The plain sky: pixels without a surface whose ray ended outside. Out: gradient from horizon to zenith; the sky's id.
// FLAT: colour of the id. FAST: the ownership test only if GATED, the id only with IDS.
#include "gate.glsl"
#include "idcolour.glsl"

layout(location = kVaryingDirection) in vec3 vDirection;
layout(location = kOutputColour) out vec4 outColour;
#if !defined(FAST) || defined(IDS)
#define WITH_ID
layout(location = kOutputId) out uint outId;
#endif

void main() {
#if !defined(FAST) || defined(GATED)
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
