// Cut-out surfaces: a texel counts where alpha >= 0.5, else there is nothing. With kFrameExactCutOuts the texel that
// holds the pixel's centre decides, at mip 0, as the reference does. Out: colour; the polygon's id.
#include "surface.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

const float kAlphaThreshold = 0.5;

void main() {
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    Instance instance = instanceAt(vInstance);
    Keep keep = keepOf(instance, vEyeRelative);
    Material material = materials[vSurface];
    vec4 colour = materialColour(material, dx, dy);
    float alpha = colour.a;
    if ((frame.flags & kFrameExactCutOuts) != 0u && material.texture != kNoTexture) {
        alpha = material.colour.a * nearestTexel(material.texture, vUv).a;
    }
    if (!keep.kept || alpha < kAlphaThreshold) {
        discard;
    }
    outColour = opaqueColour(colour.rgb, material.luminosity, material.diffuse, instance, keep);
    outId = vId;
}
