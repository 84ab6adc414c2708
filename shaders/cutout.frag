// Cut-out surfaces: a texel counts where alpha >= 0.5, else there is nothing. With kFrameExactCutOuts the texel that
// holds the pixel's centre decides, at mip 0, as the reference does. Out: colour; the polygon's id. FLAT: the colour is
// the id's; no texture is read but for alpha.
#include "surface.glsl"
#include "idcolour.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

const float kAlphaThreshold = 0.5;

bool isExact(Material material) {
    return (frame.flags & kFrameExactCutOuts) != 0u && material.texture != kNoTexture;
}

void main() {
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    Instance instance = instanceAt(vInstance);
    Keep keep = keepOf(instance, vEyeRelative);
    Material material = materials[vSurface];
#ifdef FLAT
    float alpha = 1.0;
    if (!isExact(material)) {
        alpha = materialColour(material, dx, dy).a;
    }
#else
    vec4 colour = materialColour(material, dx, dy);
    float alpha = colour.a;
#endif
    if (isExact(material)) {
        alpha = material.colour.a * nearestTexel(material.texture, vUv).a;
    }
    if (!keep.kept || alpha < kAlphaThreshold) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    outColour = opaqueColour(colour.rgb, material.luminosity, material.diffuse, instance, keep);
#endif
    outId = vId;
}
