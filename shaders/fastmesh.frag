// Opaque and CUTOUT surfaces of the fast way of drawing. Out: colour; IDS: the polygon's id, and FLAT its colour.
#include "textures.glsl"
#include "split.glsl"
#include "fastgate.glsl"
#include "idcolour.glsl"
#define LOOK in
#include "fastlook.glsl"
#include "fastlit.glsl"

layout(location = kOutputColour) out vec4 outColour;
#ifdef IDS
layout(location = kOutputId) out uint outId;
#endif

#ifdef CUTOUT
float alphaOf(vec4 texel) {
#ifdef IDS
    if ((frame.flags & kFrameExactCutOuts) != 0u && vPicture != kNoTexture) {
        texel = nearestTexel(vPicture, vUv);
    }
#endif
    return texel.a * vAlpha.x + vAlpha.y;
}
#endif

void main() {
#ifdef CUTOUT
    bool isExact = (frame.flags & kFrameExactCutOuts) != 0u;
    float farHere = isExact ? 0.0 : farShare(vec2(vAlpha.w), dFdx(vUv), dFdy(vUv));
#endif
    vec4 texel = texelsAt(vTexture, vUv);
#ifdef GATED
    if (!isSeen(vMembers)) {
        discard;
    }
#endif
#ifdef CUTOUT
    float alpha = alphaOf(texel);
    float least = mix(vAlpha.z, kFarCutOutAlpha, farHere);
    if (alpha < least) {
        discard;
    }
#endif
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    outColour = vec4(litColour(texel.rgb), 1.0);
#endif
#ifdef IDS
    outId = vId;
#endif
}
