// Transparent surfaces of the fast way of drawing; blended as by blended.frag. Out: premultiplied colour.
#define LOOK in
#include "fastlook.glsl"
#include "textures.glsl"
#include "fastgate.glsl"
#include "eyeplane.glsl"
#include "fastlit.glsl"

layout(location = kOutputBlended) out vec4 outColour;

void main() {
    bool inPlane = isInEyesPlane();
    vec4 texel = texelsAt(vTexture, vUv);
    float alpha = texel.a * vAlpha.x + vAlpha.y;
#ifdef GATED
    if (!isSeen(vMembers)) {
        discard;
    }
#endif
    if (alpha < vAlpha.z || alpha >= vAlpha.w || inPlane) {
        discard;
    }
    outColour = vec4(litColour(texel.rgb) * alpha, alpha * vCover);
}
