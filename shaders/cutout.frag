// Cut-out surfaces: a texel counts where alpha >= 0.5, else there is nothing. With kFrameExactCutOuts the texel that
// holds the pixel's centre decides, at mip 0, as the reference does. Out: colour; the polygon's id. FLAT: the colour is
// the id's, and cut-outs are exact in any case: drivers that run every branch for all fragments would spend most of such a
// frame on filtering textures that nobody sees.
#include "Tolerances.h"
#include "surface.glsl"
#include "idcolour.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

bool isExact() {
#ifdef FLAT
    return true;
#else
    return (frame.flags & kFrameExactCutOuts) != 0u;
#endif
}

float exactAlpha(Material material, vec2 uv) {
    return material.texture == kNoTexture ? material.colour.a
                                          : material.colour.a * nearestTexel(material.texture, uv).a;
}

void main() {
#ifndef FLAT
    Painted painted = paintedHere();
    vec2 dx = dFdx(painted.uv);
    vec2 dy = dFdy(painted.uv);
#endif
    Instance instance = drawnInstance();
    GateResult keep = keepOf(instance);
    Material material = materials[vSurface];
#ifdef FLAT
    float alpha = 1.0;
#else
    vec4 colour = materialColour(material, painted.uv, dx, dy);
    float alpha = colour.a;
#endif
    if (isExact()) {
        alpha = exactAlpha(material, uvOnPolygon());
    }
    float least = kCutOutAlpha;
    bool isHere = true;
    if ((material.flags & kMaterialSplit) != 0u) {
        isHere = isSplit(material);
        least = kSolidAlpha;
        alpha *= instance.opacity;
    }
    if (!keep.kept || !isHere || alpha < least) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    outColour = opaqueColour(colour.rgb, material.luminosity, material.diffuse, painted, instance, keep);
#endif
    outId = vId;
}
