// Meshes of the sky, around the eye and behind everything. In: one vertex of the arena; gl_BaseInstance: the sky
// instance.
#extension GL_ARB_shader_draw_parameters : require
#include "transform.glsl"
#include "samples.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;

layout(location = kVaryingSkyUv) SMOOTH out vec2 vUv;
layout(location = kVaryingSkyInstance) flat out uint vInstance;
layout(location = kVaryingSkyMaterial) flat out uint vMaterial;

void main() {
    uint index = uint(gl_BaseInstanceARB);
    SkyInstance object = skyInstances[index];
    vec4 clip = clipFromEye(blockFromModel(inPosition, object.row0, object.row1, object.row2));
    gl_Position = vec4(clip.xy, kSkyDepth * clip.w, clip.w);
    vUv = inUv + vec2(object.uvOffsetX, object.uvOffsetY);
    vInstance = index;
    vMaterial = materialRefs[object.firstMaterial + (inPolygonSurface >> 16)];
}
