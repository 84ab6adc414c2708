// Sky objects, unlit, blended over the plain sky in drawing order. Out: premultiplied colour; no id; the sky's depth.
#include "textures.glsl"
#include "gate.glsl"
#include "split.glsl"

layout(location = kVaryingSkyUv) SMOOTH in vec2 vUv;
layout(location = kVaryingSkyInstance) flat in uint vInstance;
layout(location = kVaryingSkyMaterial) flat in uint vMaterial;
layout(location = kOutputBlended) out vec4 outColour;

void main() {
    gl_FragDepth = kSkyDepth; // equal to the plain sky's to the bit: objects are drawn over it and over one another
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    if (!gl_FrontFacing || !keepOutside()) {
        discard;
    }
    SkyInstance object = skyInstances[vInstance];
    Material material = materials[vMaterial];
    vec4 texel = vec4(1.0);
    if (material.texture != kNoTexture) {
        texel = sampleTexture(material.texture, vUv, dx, dy);
    }
    float alpha = isAddedWhole(material.flags) ? 1.0 : (material.flags & kMaterialInvAlpha) != 0u ? 1.0 - texel.a : texel.a;
    alpha *= material.colour.a * object.opacity;
    vec3 colour = material.colour.rgb * texel.rgb * object.luminosity;
    outColour = vec4(colour * alpha, (material.flags & kMaterialAdditive) != 0u ? 0.0 : alpha);
}
