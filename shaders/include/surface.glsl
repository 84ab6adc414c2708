// What every mesh fragment receives from mesh.vert, and its material's colour.
#include "textures.glsl"
#include "lighting.glsl"

layout(location = 0) SMOOTH in vec3 vEyeRelative;
layout(location = 1) SMOOTH in vec3 vNormal;
layout(location = 2) SMOOTH in vec3 vUv; // z: see paintedHere
layout(location = 3) flat in uint vInstance; // and kGated
layout(location = 4) flat in uint vSurface;
layout(location = 5) flat in uint vId;
#ifdef EXACT
layout(location = 6) flat in uint vTriangle;
layout(location = 7) flat in vec4 vFacet;
layout(location = 8) flat in vec3 vCorners[3];
layout(location = 11) flat in vec3 vOutline[3];
#endif

#include "onpolygon.glsl"

// Pictures with alpha of all strengths (foliage, banners) are drawn in two parts: with what is solid, and with its depth, where they
// are nearly opaque; back to front where they are not, and not at all where next to nothing is. Two that reach through each other, or
// are sorted badly, then look right but for their seams. Only in frames that are painted and nothing else: such surfaces have no id and no
// depth, whatever their alpha.
const float kSolidAlpha = 0.95;
const float kLeastAlpha = 0.05;

bool isSplit(Material material) {
    return (material.flags & kMaterialSplit) != 0u && (device.flags & kFrameSplits) != 0u;
}

// What is interpolated over a triangle, here.
struct Painted {
    vec2 uv;
    vec3 normal; // of any length
    vec3 at;     // eye-relative
};

// Of a triangle that is drawn as one around the window, vUv.z is a share of all three that is 0 at its plane's horizon; else it is 0.
Painted paintedHere() {
    float whole = vUv.z == 0.0 ? 1.0 : 1.0 / vUv.z;
    return Painted(vUv.xy * whole, vNormal * whole, vEyeRelative * whole);
}

Instance drawnInstance() {
    return instanceAt(vInstance & ~kGated);
}

// The caller discards when `kept` is false.
Keep keepOf(Instance instance) {
    Place place;
    if (!findOnPolygon(kindOf(instance), place)) {
        return Keep(false, 0u, 0u);
    }
#ifdef GATED
    return keepWhereVisited(instance, place, (vInstance & kGated) != 0u);
#else
    return keepInRoot(instance);
#endif
}

// Colour and alpha of the material here. Derivatives are parameters: see textures.glsl.
vec4 materialColour(Material material, vec2 uv, vec2 dx, vec2 dy) {
    vec4 colour = material.colour;
    if (material.texture != kNoTexture) {
        colour *= sampleTexture(material.texture, uv, dx, dy);
    }
    return colour;
}

// Lit, fogged and highlighted colour of an opaque surface.
vec4 opaqueColour(vec3 albedo, float luminosity, float diffuse, Painted painted, Instance instance, Keep keep) {
    vec3 colour = lit(albedo, luminosity, diffuse, keep, painted.at, painted.normal);
    colour = mix(colour, frame.fogColour.rgb, fogShare(keep, painted.at));
    return vec4(highlighted(colour, instance.highlight), 1.0);
}
