// Counts the surfaces of the transparent stage, as layers.frag does, for the fast way of drawing.
#define LOOK in
#include "fastlook.glsl"
#include "fastgate.glsl"
#include "eyeplane.glsl"
#include "layers.glsl"

layout(location = kOutputBlended) out vec4 outLayers;

void main() {
    if (isInEyesPlane()) {
        discard;
    }
#ifdef GATED
    if (!isSeen(vMembers)) {
        discard;
    }
#endif
    outLayers = vec4(1.0, layerHash(vId), 0.0, 0.0);
}
