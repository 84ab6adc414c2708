// Cut-out surfaces: a texel counts where alpha >= 0.5, else there is nothing. With kFrameExactCutOuts the texel that
// holds the pixel's centre decides, at mip 0, as the reference does. Out: colour; the polygon's id. FLAT: the colour is
// the id's, and cut-outs are exact in any case: drivers that run every branch for all fragments would spend most of such a
// frame on filtering textures that nobody sees.
// MULTISAMPLED: exact ones are tested at each sample; others cover as many samples as alpha, made as steep as a pixel,
// says.
#include "surface.glsl"
#include "idcolour.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

const float kAlphaThreshold = 0.5;

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

#ifdef MULTISAMPLED
uint solidSamples(Material material) {
    uint solid = 0u;
    for (int i = 0; i < int(kSamples); ++i) {
        solid |= exactAlpha(material, atSample(vUv, sampleOffset(i))) >= kAlphaThreshold ? 1u << i : 0u;
    }
    return solid;
}

// Which samples stand for a share of the pixel, in quarters.
const uint kCoverage[5] = uint[5](0x0u, 0x1u, 0x9u, 0xBu, 0xFu);
const float kFlattest = 1.0e-4; // change of alpha across a pixel below which it is either solid or not

uint coveredSamples(float alpha) {
    float share = (alpha - kAlphaThreshold) / max(fwidth(alpha), kFlattest) + 0.5;
    return kCoverage[int(clamp(share, 0.0, 1.0) * float(kSamples) + 0.5)];
}
#endif

void main() {
#ifndef FLAT
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
#endif
    Instance instance = instanceAt(vInstance);
    Keep keep = keepOf(instance);
    Material material = materials[vSurface];
#ifdef FLAT
    float alpha = 1.0;
#else
    vec4 colour = materialColour(material, dx, dy);
    float alpha = colour.a;
#endif
#ifdef MULTISAMPLED
    uint solid = isExact() ? solidSamples(material) : coveredSamples(alpha);
#ifdef GATED
    solid &= uint(gl_SampleMask[0]);
#endif
    gl_SampleMask[0] = int(solid);
    bool isSolid = solid != 0u;
#else
    if (isExact()) {
        alpha = exactAlpha(material, uvOnPolygon());
    }
    bool isSolid = alpha >= kAlphaThreshold;
#endif
    if (!keep.kept || !isSolid) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    outColour = opaqueColour(colour.rgb, material.luminosity, material.diffuse, instance, keep);
#endif
    outId = vId;
}
