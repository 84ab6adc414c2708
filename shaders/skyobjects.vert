// Meshes of the sky, around the eye and behind everything. In: one vertex of the arena; gl_BaseInstance: the sky instance.
#extension GL_ARB_shader_draw_parameters : require
#include "transform.glsl"
#include "samples.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 2) in vec2 inUv;
layout(location = 3) in uint inPolygonSurface;

layout(location = 0) SMOOTH out vec2 vUv;
layout(location = 1) flat out uint vInstance;
layout(location = 2) flat out uint vMaterial;

void main() {
    uint index = uint(gl_BaseInstanceARB);
    SkyInstance object = skyInstances[index];
    vec4 clip = clipFromEye(blockFromModel(inPosition, object.row0, object.row1, object.row2));
    gl_Position = vec4(clip.xy, kSkyDepth * clip.w, clip.w);
    vUv = inUv + vec2(object.uvOffsetX, object.uvOffsetY);
    vInstance = index;
    vMaterial = materialRefs[object.firstMaterial + (inPolygonSurface >> 16)];
}
