// Transparent surfaces of the transparent stage, back to front. Output is premultiplied, so that one blend function
// (one, one minus source alpha) serves all: alpha (c a, a), additive (c a, 0), inverse alpha (c (1-a), 1-a). No id and
// no depth.
#define TRANSLUCENT
#include "surface.glsl"

layout(location = kOutputBlended) out vec4 outColour;

void main() {
    Painted painted = paintedHere();
    vec2 dx = dFdx(painted.uv);
    vec2 dy = dFdy(painted.uv);
    Instance instance = drawnInstance();
    bool keep = isKept(instance);
    if (!keep) {
        discard;
    }
    Material material = materialAt(vSurface);
    vec4 texel = vec4(1.0);
    if (material.texture != kNoTexture) {
        texel = sampleTexture(material.texture, painted.uv, dx, dy);
    }
    float alpha = isAddedWhole(material.flags) ? 1.0 : (material.flags & kMaterialInvAlpha) != 0u ? 1.0 - texel.a : texel.a;
    alpha *= material.colour.a * instance.opacity;
    if (isSplit(material) && (alpha >= kSolidAlpha + kSplitOverlap || alpha < kLeastAlpha)) {
        discard;
    }
    bool isAdditive = (material.flags & kMaterialAdditive) != 0u;
    vec3 colour = highlighted(material.colour.rgb * texel.rgb * lightHere(painted, instance), instance.highlight);
    colour = mix(colour, frame.fogColour.rgb, isAdditive ? 0.0 : fogHere(painted, instance)); // fog passes additive ones by
    outColour = vec4(colour * alpha, isAdditive ? 0.0 : alpha);
}
