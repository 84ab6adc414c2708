// Vertices of every mesh of the solid and transparent stages, terrain included.
// In: one vertex of the arena, model space; gl_BaseInstance + gl_InstanceID: the instance, and kGated. Out: clip
// position; eye-relative position for the gate; the light; values that are constant over a triangle.
// TERRAIN: the surface is the landcell's index in its block, else the surface's slot in its mesh.
// EXACT: triangles are drawn slightly larger, and fragments outside are discarded (outline.glsl).
#extension GL_ARB_shader_draw_parameters : require
#include "frommodel.glsl"
#include "incident.glsl"
#include "samples.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeNormal) in vec4 inNormal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;
layout(location = kAttributeFacet) in vec3 inFacet;
layout(location = kAttributeRest) in vec3 inRest;

invariant gl_Position;
#include "clip.glsl"
layout(location = kVaryingEyeRelative) SMOOTH out vec3 vEyeRelative;
layout(location = kVaryingLight) SMOOTH out vec3 vLight;
layout(location = kVaryingUv) SMOOTH out vec3 vUv; // z: see paintAround
layout(location = kVaryingNumbers, component = kPartInstance) flat out uint vInstance; // also has kGated
layout(location = kVaryingNumbers, component = kPartSurface) flat out uint vSurface;
layout(location = kVaryingNumbers, component = kPartId) flat out uint vId;
#ifdef PIXEL_LAMPS
layout(location = kVaryingNormal) SMOOTH out vec3 vNormal; // world axes
#endif
#ifdef EXACT
layout(location = kVaryingNumbers, component = kPartTriangle) flat out uint vTriangle; // its first vertex in the arena
layout(location = kVaryingFacet) flat out vec4 vFacet; // its plane, eye-relative: dot(vFacet.xyz, p) = vFacet.w
layout(location = kVaryingCorners) flat out vec3 vCorners[3]; // eye-relative, the same for all three vertices
layout(location = kVaryingOutline) flat out vec3 vOutline[3]; // the same corners, by screenFromEye
layout(location = kVaryingRests) flat out vec3 vRests[3]; // remainders of close corners, beyond their floats
#endif

#ifdef SURFACE_DIFFUSE
float diffuse = 1.0; // of the surface
#else
const float diffuse = 1.0;
#endif

Incident incidentOn(Instance instance) {
    LightSet set = lightSets[memberThatLights(instance).lightSet];
    bool isOutdoors = set.kind == kLitOutdoors;
#ifdef TERRAIN
    vec3 ofSky = frame.landAmbient.rgb;
#else
    vec3 ofSky = frame.skyAmbient.rgb;
#endif
    return Incident(set.sealed != 0u ? frame.sealedAmbient.rgb : ofSky, isOutdoors ? frame.sunColour.rgb * diffuse : vec3(0.0), set.kind,
                    set.firstLamp, set.lampCount);
}

vec3 turned(vec3 normal, Instance instance) {
    mat3 rows = rowsOf(instance);
    return vec3(dot(rows[0], normal), dot(rows[1], normal), dot(rows[2], normal));
}

float emission = 0.0; // of the surface

// Light of a vertex of `instance`; `normal`: model space.
vec3 lightOf(Instance instance, vec3 eyeRelative, vec3 normal) {
    vec3 origin = eyeFromBlock(originOf(instance), vec3(0.0), instance.block);
    return lightAt(incidentOn(instance), emission, eyeRelative, litNormal(turned(normal, instance)), origin);
}

#ifdef EXACT
vec3 corners[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0)); // vCorners
uint triangle = 0u;                                         // vTriangle

vec3 outlineCorner(uint i) {
    return i == 0u ? corners[0] : i == 1u ? corners[1] : corners[2];
}
#include "grow.glsl"
#include "close.glsl"

// Fragments are also cut at the near plane one by one; the clipper must not remove those within rounding of it.
const float kBeforeNear = 0.999;

// Clip positions of a vertex and its neighbours, in the triangle's order.
struct Around {
    vec4 before;
    vec4 own;
    vec4 after;
};

// Growth of a vertex's corner. With `all`, it fails for all three vertices if it fails for any corner. A loop that
// rarely has a second turn rather than a branch: drivers that execute every branch for all vertices still leave a loop
// early.
Growth growthOf(Around clip, bool all) {
    Growth growth = Growth(0.0, 0.0, vec2(0.0), false);
    uint turns = all ? 3u : 1u;
    uint turn = 0u;
    do {
        Growth next = growthAt(clip.before, clip.own, clip.after, true);
        bool fails = growth.fails || next.fails;
        if (turn == 0u) {
            growth = next;
        }
        growth.fails = fails && all;
        clip = Around(clip.own, clip.after, clip.before);
        ++turn;
    } while (turn < turns); // at the end: see walkChain in gate.glsl
    return growth;
}

vec2 aroundTriangle(vec4 first, vec4 second, vec4 third, uint corner) {
    vec2 most = device.viewport.xy * 0.5;
    vec2 low = -most;
    vec2 high = most;
    if (min(min(first.w, second.w), third.w) >= kNearestPlace) {
        vec2 a = first.xy / first.w * most;
        vec2 b = second.xy / second.w * most;
        vec2 c = third.xy / third.w * most;
        low = clamp(min(min(a, b), c), -most, most);
        high = clamp(max(max(a, b), c), -most, most);
    }
    return aroundBox(low, high, corner, true);
}

// One triangle around the whole triangle; fragments are tested one by one.
void drawAround(vec2 pixelsFromMiddle) {
    gl_Position = vec4(pixelsFromMiddle / (device.viewport.xy * 0.5), 0.5, 1.0);
}

float cross2(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

// Attributes at a corner of the triangle drawn around another one. The shares of the three original corners, and their
// sum, are linear on the screen; the sum is 0 at the plane's horizon. Attributes and sum are interpolated, and divided
// per fragment.
void paintAround(vec2 pixelsFromMiddle, Instance instance) {
    vec2 across[3];
    for (uint i = 0u; i < 3u; ++i) {
        vec3 onScreen = screenFromEye(outlineCorner(i));
        across[i] = onScreen.xy - pixelsFromMiddle * onScreen.z;
    }
    vec3 shares = vec3(cross2(across[1], across[2]), cross2(across[2], across[0]), cross2(across[0], across[1]));
    vUv = vec3(0.0);
    vLight = vec3(0.0);
    vEyeRelative = vec3(0.0);
#ifdef PIXEL_LAMPS
    vNormal = vec3(0.0);
#endif
    for (uint i = 0u; i < 3u; ++i) {
        float share = i == 0u ? shares.x : i == 1u ? shares.y : shares.z;
        vUv += share * vec3(uvAt(triangle + i), 1.0);
        vLight += share * lightOf(instance, outlineCorner(i), normalAt(triangle + i));
        vEyeRelative += share * outlineCorner(i);
#ifdef PIXEL_LAMPS
        vNormal += share * turned(normalAt(triangle + i), instance);
#endif
    }
}

// Moves the corner of a triangle that faces the eye outwards, with its attributes. All three vertices must make the
// same decisions, so each evaluates them for the whole triangle in the same order.
// A close triangle is drawn around the window, and each fragment is tested: clipping makes corners from floats.
void drawLarger(uint own, vec3 before, vec3 after, bool isClose, Instance instance) {
    vec4 clip[3] = vec4[3](clipFromEye(corners[0]), clipFromEye(corners[1]), clipFromEye(corners[2]));
    bool mayThin = mayBeThin(clip[0], clip[1], clip[2]);
    if (mayThin) {
        Thin thin = thinAt(3u, own, frame.nearPlane);
        if (thin.is) {
            drawAround(thin.at);
            return;
        }
    }
    bool all = mayThin || mayFail(clip[0], clip[1], clip[2]);
    Growth growth = growthOf(Around(clipFromEye(before), gl_Position, clipFromEye(after)), all);
    if (growth.fails || isClose) {
        vec2 at = aroundTriangle(clip[0], clip[1], clip[2], own);
        drawAround(at);
        paintAround(at, instance);
        return;
    }
    vec3 at = outlineCorner(own);
    vec2 uvBefore = uvAt(triangle + (own + 2u) % 3u);
    vec2 uvAfter = uvAt(triangle + (own + 1u) % 3u);
    at += growth.before * (at - before) + growth.after * (at - after);
    vEyeRelative = at;
    vUv.xy = inUv + growth.before * (inUv - uvBefore) + growth.after * (inUv - uvAfter);
    vec4 moved = clipFromEye(at);
    moved.xy += growth.shift * moved.w / (device.viewport.xy * 0.5);
    gl_Position = moved;
}
#endif

void main() {
    uint drawn = uint(gl_BaseInstanceARB + gl_InstanceID);
    Instance instance = instanceAt(drawn & ~kGated);
    vec3 eyeRelative = eyeFromModel(inPosition, inRest, instance);
    gl_Position = clipFromEye(eyeRelative);
    vEyeRelative = eyeRelative;
    vUv = vec3(inUv, 0.0);
    vInstance = drawn;
#ifdef TERRAIN
    vSurface = instance.firstMaterial + (inPolygonSurface >> 16);
#else
    vSurface = materialRefAt(instance.firstMaterial + (inPolygonSurface >> 16));
    Material material = materialAt(vSurface);
    emission = material.luminosity;
#ifdef SURFACE_DIFFUSE
    diffuse = material.diffuse;
#endif
#endif
    vLight = lightOf(instance, eyeRelative, inNormal.xyz);
#ifdef PIXEL_LAMPS
    vNormal = turned(inNormal.xyz, instance);
#endif
    vId = instance.idBase + (inPolygonSurface & 0xFFFFu);
#ifdef EXACT
    uint corner = uint(gl_VertexID) % 3u;
    triangle = uint(gl_VertexID) - corner;
    vec3 before = eyeFromVertex(triangle + (corner + 2u) % 3u, instance);
    vec3 after = eyeFromVertex(triangle + (corner + 1u) % 3u, instance);
    corners[0] = corner == 0u ? eyeRelative : corner == 1u ? before : after;
    corners[1] = corner == 1u ? eyeRelative : corner == 2u ? before : after;
    corners[2] = corner == 2u ? eyeRelative : corner == 0u ? before : after;
    vec4 facet = facetFromModel(inFacet, instance, corners[0]); // from the same corner for all three vertices
    vTriangle = triangle;
    vCorners = corners;
    vOutline = vec3[3](screenFromEye(corners[0]), screenFromEye(corners[1]), screenFromEye(corners[2]));
    vRests = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
    bool close = isClose(facet.w, min(min(vOutline[0].z, vOutline[1].z), vOutline[2].z));
    for (uint turn = 0u; turn < (close ? 1u : 0u); ++turn) {
        CloseTriangle exact = exactTriangle(triangle, instance);
        facet.w = exactFacetHeight(exact);
        vRests = vec3[3](vec3(exact.a - dvec3(corners[0])), vec3(exact.b - dvec3(corners[1])), vec3(exact.c - dvec3(corners[2])));
    }
    vFacet = facet;
    if (facet.w < (close ? -kEyeInPlaneTolerance : 0.0)) {
        drawLarger(corner, before, after, close, instance);
        gl_Position.z *= kBeforeNear;
    } else {
        gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // faces away, or has no area
    }
#endif
    clipBy(clipSetOf(drawn & ~kGated));
}
