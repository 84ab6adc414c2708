// The plain sky, where no surface was met and the ray got outside. Out: horizon to zenith; the sky's id. FLAT: the
// colour is the id's.
#include "gate.glsl"
#include "idcolour.glsl"

layout(location = 0) in vec3 vDirection;
layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

void main() {
    if (!keepOutside()) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(kSkyId);
#else
    // The square root brings the zenith's colour down: haze is thick only near the horizon.
    float height = sqrt(clamp(normalize(vDirection).z, 0.0, 1.0));
    outColour = vec4(mix(frame.fogColour.rgb, frame.skyZenith.rgb, height), 1.0);
#endif
    outId = kSkyId;
}
