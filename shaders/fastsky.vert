// Meshes of the sky for the fast way of drawing: skyobjects.vert, with the material at the vertex. In: one vertex of the
// arena; gl_BaseInstance: the sky instance. Out: factors of the texel, the texture, the limits of alpha.
#extension GL_ARB_shader_draw_parameters : require
#define BLENDED
#define SKY
#include "skylight.glsl"
#include "clip.glsl"
#include "wide.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeNormal) in vec4 inNormal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;

#define LOOK out
#include "fastlook.glsl"
#include "fastmaterial.glsl"

void main() {
    SkyInstance object = skyInstances[uint(gl_BaseInstanceARB)];
    Material material = materialAt(materialRefAt(object.firstMaterial + (inPolygonSurface >> 16)));
    gl_Position = skyPosition(object, inPosition);
    clipBy(object.clipSet);
    gl_Position = widened(gl_Position);
    vUv = inUv + vec2(object.uvOffsetX, object.uvOffsetY);
    setTexture(material, Look(material.colour.rgb * skyLight(object, material, inNormal.xyz), vec3(0.0)));
    vAlpha = blendedAlpha(material, object.opacity, kAllAlpha);
    vCover = (material.flags & kMaterialAdditive) != 0u ? 0.0 : 1.0;
}
