// Vertices of every mesh of the solid and late stages, terrain included.
// In: one vertex of the arena, model space; gl_BaseInstance: the instance. Out: clip position; eye-relative position
// and world-axes normal for the tests and the light; what is constant over a polygon.
// TERRAIN: `surface` is the landcell's index in its block, else the surface's slot in its mesh.
#extension GL_ARB_shader_draw_parameters : require
#include "transform.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec4 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in uint inPolygon;
layout(location = 4) in uint inSurface;

invariant gl_Position;
layout(location = 0) out vec3 vEyeRelative;
layout(location = 1) out vec3 vNormal;
layout(location = 2) out vec2 vUv;
layout(location = 3) flat out uint vInstance;
layout(location = 4) flat out uint vSurface;
layout(location = 5) flat out uint vId;

void main() {
    uint index = uint(gl_BaseInstanceARB);
    Instance instance = instanceAt(index);
    vec3 local = blockFromModel(inPosition, instance.row0, instance.row1, instance.row2);
    vec3 eyeRelative = eyeFromBlock(local, instance.block);
    gl_Position = clipFromEye(eyeRelative);
    vEyeRelative = eyeRelative;
    vNormal = vec3(dot(instance.row0.xyz, inNormal.xyz), dot(instance.row1.xyz, inNormal.xyz),
                   dot(instance.row2.xyz, inNormal.xyz));
    vUv = inUv;
    vInstance = index;
#ifdef TERRAIN
    vSurface = instance.firstMaterial + inSurface;
#else
    vSurface = materialRefs[instance.firstMaterial + inSurface];
#endif
    vId = instance.idBase + inPolygon;
}
