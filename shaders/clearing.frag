// Clears the pixels whose ray leaves the root before the surface that was drawn there, so that other visits can be drawn
// (FrameView::rootFirst). A pixel that the root fills with nothing is cleared, too. Out: a void's colour and id (IDS), FLAT: its
// colour by id; the depth of a pixel without a surface.
#include "gate.glsl"
#include "place.glsl"
#include "idcolour.glsl"

#ifdef MULTISAMPLED
layout(binding = kUnitDepth) uniform sampler2DMS drawnDepth;
#else
layout(binding = kUnitDepth) uniform sampler2D drawnDepth;
#endif
layout(location = kOutputColour) out vec4 outColour;
#ifdef IDS
layout(location = kOutputId) out uint outId;
#endif

float depthHere() {
#ifdef MULTISAMPLED
    return texelFetch(drawnDepth, ivec2(gl_FragCoord.xy), gl_SampleID).r;
#else
    return texelFetch(drawnDepth, ivec2(gl_FragCoord.xy), 0).r;
#endif
}

void main() {
    float depth = depthHere();
    vec3 at = placeAt(max(depth, kVoidDepth));
    bool isKept = isBeforeExit(at);
#ifdef FLAT
    outColour = colourOfId(kVoidId);
#else
    outColour = frame.voidColour;
#endif
#ifdef IDS
    outId = kVoidId;
#endif
    if (isKept) {
        discard;
    }
}
