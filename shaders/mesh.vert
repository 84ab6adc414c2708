// Vertices of every mesh of the solid and late stages, terrain included.
// In: one vertex of the arena, model space; gl_BaseInstance: the instance. Out: clip position; eye-relative position
// and world-axes normal for the tests and the light; what is constant over a triangle.
// TERRAIN: the surface is the landcell's index in its block, else the surface's slot in its mesh.
// EXACT: triangles are drawn a little larger than they are, and fragments beside them dropped (outline.glsl).
#extension GL_ARB_shader_draw_parameters : require
#include "transform.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec4 inNormal;
layout(location = 2) in vec2 inUv;
layout(location = 3) in uint inPolygonSurface;
layout(location = 4) in vec3 inFacet;

invariant gl_Position;
layout(location = 0) out vec3 vEyeRelative;
layout(location = 1) out vec3 vNormal;
layout(location = 2) out vec2 vUv;
layout(location = 3) flat out uint vInstance;
layout(location = 4) flat out uint vSurface;
layout(location = 5) flat out uint vId;
#ifdef EXACT
layout(location = 6) flat out uint vTriangle; // its first vertex in the arena
layout(location = 7) flat out vec4 vFacet;    // its plane, eye-relative: dot(vFacet.xyz, p) = vFacet.w
#endif

vec3 eyeFromModel(vec3 position, Instance instance) {
    return eyeFromBlock(blockFromModel(position, instance.row0, instance.row1, instance.row2), instance.block);
}

#ifdef EXACT
// The plane of a triangle with this normal through a point, eye-relative. Planes turn with the cofactors of a matrix; a
// mirroring one turns the winding over, and the normal with it.
vec4 facetFromModel(vec3 facet, Instance instance, vec3 through) {
    vec3 normal = vec3(dot(cross(instance.row1.xyz, instance.row2.xyz), facet),
                       dot(cross(instance.row2.xyz, instance.row0.xyz), facet),
                       dot(cross(instance.row0.xyz, instance.row1.xyz), facet));
    float size = length(normal);
    normal = size > 0.0 ? normal / size : vec3(0.0);
    return vec4(normal, dot(normal, through));
}

Instance outlineInstance = Instance(vec4(0.0), vec4(0.0), vec4(0.0), 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0.0);
uint outlineFirst = 0u;

vec3 outlineCorner(uint i) {
    return eyeFromModel(cornerAt(outlineFirst + i), outlineInstance);
}
#include "grow.glsl"

// The near plane cuts fragment by fragment, too; the clipper must leave what may round to either side of it.
const float kBeforeNear = 0.999;

// All three corners must come to the same decisions, so each of them takes them for the triangle as a whole, in the same
// order.
struct Seen {
    vec3 at[3];
    vec4 clip[3];
};

Seen seenTriangle() {
    Seen seen;
    for (uint i = 0u; i < 3u; ++i) {
        seen.at[i] = outlineCorner(i);
        seen.clip[i] = clipFromEye(seen.at[i]);
    }
    return seen;
}

Growth growthOf(Seen seen, uint corner) {
    return growthAt(seen.clip[(corner + 2u) % 3u], seen.clip[corner], seen.clip[(corner + 1u) % 3u], true);
}

bool anyFails(Seen seen) {
    return growthOf(seen, 0u).fails || growthOf(seen, 1u).fails || growthOf(seen, 2u).fails;
}

vec2 aroundTriangle(Seen seen, uint corner) {
    vec2 most = frame.viewport.xy * 0.5;
    vec2 low = -most;
    vec2 high = most;
    if (min(min(seen.clip[0].w, seen.clip[1].w), seen.clip[2].w) >= frame.nearPlane) {
        vec2 a = seen.clip[0].xy / seen.clip[0].w * most;
        vec2 b = seen.clip[1].xy / seen.clip[1].w * most;
        vec2 c = seen.clip[2].xy / seen.clip[2].w * most;
        low = clamp(min(min(a, b), c), -most, most);
        high = clamp(max(max(a, b), c), -most, most);
    }
    return aroundBox(low, high, corner, true);
}

// A triangle around the whole one; which fragments lie on it is decided one by one.
void drawAround(vec2 pixelsFromMiddle) {
    gl_Position = vec4(pixelsFromMiddle / (frame.viewport.xy * 0.5), 0.5, 1.0);
}

// Moves the corner of a triangle that faces the eye outwards, with what is interpolated from it.
void drawLarger(uint own) {
    Seen seen = seenTriangle();
    bool mayThin = mayBeThin(seen.clip[0], seen.clip[1], seen.clip[2]);
    if (mayThin) {
        Thin thin = thinAt(3u, own, frame.nearPlane);
        if (thin.is) {
            drawAround(thin.at);
            return;
        }
    }
    if ((mayThin || mayFail(seen.clip[0], seen.clip[1], seen.clip[2])) && anyFails(seen)) {
        drawAround(aroundTriangle(seen, own));
        return;
    }
    Growth growth = growthOf(seen, own);
    uint before = (own + 2u) % 3u;
    uint after = (own + 1u) % 3u;
    vec3 at = seen.at[own];
    at += growth.before * (at - seen.at[before]) + growth.after * (at - seen.at[after]);
    vec4 clip = clipFromEye(at);
    clip.xy += growth.shift * clip.w / (frame.viewport.xy * 0.5);
    gl_Position = clip;
    vEyeRelative = at;
    vUv = inUv + growth.before * (inUv - uvAt(outlineFirst + before)) + growth.after * (inUv - uvAt(outlineFirst + after));
}
#endif

void main() {
    uint index = uint(gl_BaseInstanceARB);
    Instance instance = instanceAt(index);
    vec3 eyeRelative = eyeFromModel(inPosition, instance);
    gl_Position = clipFromEye(eyeRelative);
    vEyeRelative = eyeRelative;
    vNormal = vec3(dot(instance.row0.xyz, inNormal.xyz), dot(instance.row1.xyz, inNormal.xyz),
                   dot(instance.row2.xyz, inNormal.xyz));
    vUv = inUv;
    vInstance = index;
#ifdef TERRAIN
    vSurface = instance.firstMaterial + (inPolygonSurface >> 16);
#else
    vSurface = materialRefs[instance.firstMaterial + (inPolygonSurface >> 16)];
#endif
    vId = instance.idBase + (inPolygonSurface & 0xFFFFu);
#ifdef EXACT
    uint corner = uint(gl_VertexID) % 3u;
    outlineInstance = instance;
    outlineFirst = uint(gl_VertexID) - corner;
    vTriangle = outlineFirst;
    vec4 facet = facetFromModel(inFacet, instance, outlineCorner(0u)); // of the same corner for all three
    vFacet = facet;
    if (facet.w < 0.0) {
        drawLarger(corner);
        gl_Position.z *= kBeforeNear;
    } else {
        gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // faces away, or has no area
    }
#endif
}
