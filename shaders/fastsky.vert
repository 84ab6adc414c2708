// Meshes of the sky for the fast way of drawing: skyobjects.vert, with the material at the vertex. In: one vertex of the
// arena; gl_BaseInstance: the sky instance. Out: factors of the texel, the texture, the limits of alpha.
#extension GL_ARB_shader_draw_parameters : require
#define BLENDED
#define SKY
#include "transform.glsl"
#include "split.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;

#define LOOK out
#include "fastlook.glsl"

void main() {
    SkyInstance object = skyInstances[uint(gl_BaseInstanceARB)];
    Material material = materials[materialRefs[object.firstMaterial + (inPolygonSurface >> 16)]];
    vec4 clip = clipFromEye(blockFromModel(inPosition, object.row0, object.row1, object.row2));
    gl_Position = vec4(clip.xy, kSkyDepth * clip.w, clip.w);
    vUv = inUv + vec2(object.uvOffsetX, object.uvOffsetY);
    bool hasTexture = material.texture != kNoTexture;
    bool isInverse = (material.flags & kMaterialInvAlpha) != 0u;
    vec3 colour = material.colour.rgb * object.luminosity;
    float whole = material.colour.a * object.opacity;
    vTimes = hasTexture ? colour : vec3(0.0);
    vPlus = hasTexture ? vec3(0.0) : colour;
    vAlpha = isInverse ? vec4(-whole, whole, -kAnyAlpha, kAnyAlpha) : vec4(whole, 0.0, -kAnyAlpha, kAnyAlpha);
    vAlpha.xy = hasTexture ? vAlpha.xy : vec2(0.0, vAlpha.x + vAlpha.y);
    vCover = (material.flags & kMaterialAdditive) != 0u ? 0.0 : 1.0;
    vTexture = hasTexture ? textureRefs[material.texture].place.xy : uvec2(0u);
}
