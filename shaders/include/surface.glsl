// Inputs of every mesh fragment from mesh.vert, and the colour of its material.
#include "textures.glsl"
#include "lighting.glsl"
#include "split.glsl"

layout(location = kVaryingEyeRelative) SMOOTH in vec3 vEyeRelative;
layout(location = kVaryingLight) SMOOTH in vec3 vLight;
layout(location = kVaryingUv) SMOOTH in vec3 vUv; // z: see paintedHere
layout(location = kVaryingNumbers, component = kPartInstance) flat in uint vInstance; // also has kGated
layout(location = kVaryingNumbers, component = kPartSurface) flat in uint vSurface;
layout(location = kVaryingNumbers, component = kPartId) flat in uint vId;
#ifdef PIXEL_LAMPS
layout(location = kVaryingNormal) SMOOTH in vec3 vNormal;
#endif
#ifdef EXACT
layout(location = kVaryingNumbers, component = kPartTriangle) flat in uint vTriangle;
layout(location = kVaryingFacet) flat in vec4 vFacet;
layout(location = kVaryingCorners) flat in vec3 vCorners[3];
layout(location = kVaryingOutline) flat in vec3 vOutline[3];
layout(location = kVaryingRests) flat in vec3 vRests[3];
#endif

#include "onpolygon.glsl"

bool isSplit(Material material) {
    return (material.flags & kMaterialSplit) != 0u && (device.flags & kFrameSplits) != 0u;
}

// The interpolated values at this fragment.
struct Painted {
    vec2 uv;
    vec3 light;
    vec3 at; // eye-relative
};

// In a triangle drawn around the window, vUv.z is the sum of the three corner shares, which is 0 at the plane's
// horizon. In any other triangle it is 0.
Painted paintedHere() {
    float whole = vUv.z == 0.0 ? 1.0 : 1.0 / vUv.z;
    return Painted(vUv.xy * whole, clamp(vLight * whole, 0.0, 1.0), vEyeRelative * whole);
}

Instance drawnInstance() {
    return instanceAt(vInstance & ~kGated);
}

// Light of the fragment. PIXEL_LAMPS: with the lamps of walls.
vec3 lightHere(Painted painted, Instance instance) {
#ifdef PIXEL_LAMPS
    LightSet set = lightSets[memberThatLights(instance).lightSet];
    if (set.kind == kLitWalls) {
        vec3 normal = unitOrZero(vUv.z < 0.0 ? -vNormal : vNormal); // divided by vUv.z, it keeps its direction
        return clamp(painted.light + lampsOnWall(set.firstLamp, set.lampCount, painted.at, normal), 0.0, 1.0);
    }
#endif
    return painted.light;
}

// Whether the fragment is seen; the caller discards others.
bool isKept(Instance instance) {
    SurfacePoint point;
    if (!findOnPolygon(instance, point)) {
        return false;
    }
#ifdef GATED
    bool isGated = (vInstance & kGated) != 0u;
    bool afterFilling;
    bool isSeen = walkChain(instance, point, isGated, afterFilling) || !isGated; // others are wholly inside one visit
#if defined(EXACT) && !defined(TRANSLUCENT) && !defined(NO_SHELLS)
    // A wall in the plane of a shut opening, at their common edge, which the filling may leave free.
    bool isBesideFilling = !isSeen && afterFilling && kindOf(instance) == kKindShell;
    gl_FragDepth = isBesideFilling ? behindAll(gl_FragDepth) : gl_FragDepth;
    isSeen = isSeen || isBesideFilling;
#endif
    return isSeen;
#else
    return true; // a frame with one visit: everything is seen from the root's zone
#endif
}

// Colour and alpha of the material. Derivatives are parameters: see textures.glsl.
vec4 materialColour(Material material, vec2 uv, vec2 dx, vec2 dy) {
    vec4 colour = material.colour;
    if (material.texture != kNoTexture) {
        colour *= sampleTexture(material.texture, uv, dx, dy);
    }
    return colour;
}

float fogHere(Painted painted, Instance instance) {
#ifdef NO_CELL_FOG
    return fogOn(lightSets[memberThatLights(instance).lightSet].kind, painted.at);
#else
    return fogAt(painted.at);
#endif
}

// Fogged and highlighted colour of a lit opaque surface.
vec4 coveredColour(vec3 lit, Painted painted, Instance instance) {
    vec3 colour = mix(lit, frame.fogColour.rgb, fogHere(painted, instance));
    return vec4(highlighted(colour, instance.highlight), 1.0);
}

vec4 opaqueColour(vec3 albedo, Painted painted, Instance instance) {
    return coveredColour(albedo * lightHere(painted, instance), painted, instance);
}
