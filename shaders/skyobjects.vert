// Meshes of the sky, behind everything or over everything outdoors. In: one vertex of the arena; gl_BaseInstance: the sky
// instance.
#extension GL_ARB_shader_draw_parameters : require
#include "skylight.glsl"
#include "clip.glsl"
#include "samples.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeNormal) in vec4 inNormal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;

layout(location = kVaryingSkyUv) SMOOTH out vec2 vUv;
layout(location = kVaryingSkyInstance) flat out uint vInstance;
layout(location = kVaryingSkyMaterial) flat out uint vMaterial;
layout(location = kVaryingSkyLight) SMOOTH out vec3 vLight;

void main() {
    uint index = uint(gl_BaseInstanceARB);
    SkyInstance object = skyInstances[index];
    gl_Position = skyPosition(object, inPosition);
    clipBy(object.clipSet);
    vUv = inUv + vec2(object.uvOffsetX, object.uvOffsetY);
    vInstance = index;
    vMaterial = materialRefAt(object.firstMaterial + (inPolygonSurface >> 16));
    vLight = skyLight(object, materialAt(vMaterial), inNormal.xyz);
}
