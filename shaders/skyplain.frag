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
#if !defined(FAST) || defined(GATED)
    if (!keepOutside()) {
        discard;
    }
#endif
}
