// Sky objects, blended over the plain sky, or over everything outdoors, in drawing order. Out: premultiplied colour; no
// id; the depth to test.
#include "textures.glsl"
#include "gate.glsl"
#include "skylight.glsl"
#include "split.glsl"

layout(location = kVaryingSkyUv) SMOOTH in vec2 vUv;
layout(location = kVaryingSkyInstance) flat in uint vInstance;
layout(location = kVaryingSkyMaterial) flat in uint vMaterial;
layout(location = kVaryingSkyLight) SMOOTH in vec3 vLight;
layout(location = kOutputBlended) out vec4 outColour;

void main() {
    SkyInstance object = skyInstances[vInstance];
    gl_FragDepth = skyDepth(object);
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    if (!gl_FrontFacing || !keepOutside()) {
        discard;
    }
    Material material = materialAt(vMaterial);
    vec4 texel = vec4(1.0);
    if (material.texture != kNoTexture) {
        texel = sampleTexture(material.texture, vUv, dx, dy);
    }
    float alpha = isAddedWhole(material.flags) ? 1.0 : (material.flags & kMaterialInvAlpha) != 0u ? 1.0 - texel.a : texel.a;
    alpha *= material.colour.a * object.opacity;
    vec3 colour = material.colour.rgb * texel.rgb * vLight;
    outColour = vec4(colour * alpha, (material.flags & kMaterialAdditive) != 0u ? 0.0 : alpha);
}
