// Cut-out surfaces: a texel is present if its alpha is large enough. With kFrameExactCutOuts the texel at the pixel's centre
// decides, at mip level 0, as in the reference. Out: colour; the polygon's id. FLAT: colour of the id, always with
// exact cut-outs. Drivers that execute every branch for all fragments would otherwise spend most of a flat frame on
// filtering unused textures.
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
    bool keep = isKept(instance);
    Material material = materialAt(vSurface);
#ifdef FLAT
    float alpha = 1.0;
#else
    vec4 colour = materialColour(material, painted.uv, dx, dy);
    float alpha = colour.a;
#endif
    if (isExact()) {
        alpha = exactAlpha(material, uvOnPolygon());
    }
    float least = leastAlpha(material.flags);
#ifndef FLAT
    if (material.texture != kNoTexture && !isExact()) {
        least = mix(least, kFarCutOutAlpha, farShare(vec2(textureSizeOf(textureRefAt(material.texture))), dx, dy));
    }
#endif
    bool isHere = true;
    if ((material.flags & kMaterialSplit) != 0u) {
        isHere = isSplit(material);
        least = kSolidAlpha;
        alpha *= instance.opacity;
    }
    if (!keep || !isHere || alpha < least) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    outColour = opaqueColour(colour.rgb, painted, instance);
#endif
    outId = vId;
}
