// Vertices of every mesh for the fast way of drawing, terrain included: light, fog, highlight and material at the
// vertex, so that a fragment reads one texel and little else (fastlook.glsl).
// In: one vertex of the arena, model space; the DrawRecord of its draw. Out: clip position; factors of the texel; the
// texture.
// TERRAIN: the surface is the landcell's index in its block, else the surface's slot in its mesh. CUTOUT, BLENDED: the
// limits of alpha. GATED: the members that the ownership test needs. LAMPS: with the lamps of the record. IDS: the
// polygon's id.
#include "incident.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeNormal) in vec4 inNormal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;
layout(location = kAttributeRow0) in vec4 inRow0; // DrawRecord
layout(location = kAttributeRow1) in vec4 inRow1;
layout(location = kAttributeRow2) in vec4 inRow2;
layout(location = kAttributeOffsetRest) in vec4 inOffsetRest;
layout(location = kAttributeAmbient) in vec4 inAmbient;
layout(location = kAttributeSun) in vec4 inSun;
layout(location = kAttributeLook) in uvec4 inLook;
layout(location = kAttributeMembers) in uvec4 inMembers;

invariant gl_Position;
#define LOOK out
#include "fastlook.glsl"
#include "fastmaterial.glsl"

vec3 turned(vec3 v) {
    precise vec3 result = vec3(inRow0.x * v.x + inRow0.y * v.y + inRow0.z * v.z, inRow1.x * v.x + inRow1.y * v.y + inRow1.z * v.z,
                               inRow2.x * v.x + inRow2.y * v.y + inRow2.z * v.z);
    return result;
}

// Near the eye, the first sum is exact: the offset is the eye's position, rounded.
vec3 eyeRelativePlace() {
    precise vec3 result = (turned(inPosition) + vec3(inRow0.w, inRow1.w, inRow2.w)) + inOffsetRest.xyz;
    return result;
}

#ifdef LAMPS
vec3 lampsAt(vec3 eyeRelative, vec3 normal) {
    vec3 light = vec3(0.0);
    for (uint i = 0u; i < inLook.w; ++i) {
        uint first = device.firstLamp + (inLook.z + i) * kLampTexels;
        vec4 place = uintBitsToFloat(ringTexel(first)); // Lamp.position
        vec3 colour = uintBitsToFloat(ringTexel(first + 1u).rgb);
        light += colour * lampShare(place.xyz - eyeRelative, place.w, normal);
    }
    return light;
}
#endif

// Factors of a surface with this colour: the incident light, with a lower bound, then fog and highlight over it.
Look lookOf(vec3 eyeRelative, vec3 albedo, float luminosity, float diffuse, float withFog) {
    vec3 normal = normalize(turned(inNormal.xyz));
    vec3 light = inAmbient.rgb + inSun.rgb * max(0.0, dot(normal, frame.sunDirection.xyz));
    float fog = inOffsetRest.w * fogOutside(eyeRelative);
    vec4 over = unpackUnorm4x8(inLook.y);
#ifdef LAMPS
    light += lampsAt(eyeRelative, normal);
#endif
    vec3 times = albedo * max(light * diffuse, vec3(luminosity));
    return Look(times * ((1.0 - fog) * (1.0 - over.a)),
                frame.fogColour.rgb * (fog * withFog * (1.0 - over.a)) + over.rgb * over.a);
}

#if defined(CUTOUT) || defined(BLENDED)
void setAlpha(Material material, float opacity) {
    bool hasParts = (material.flags & kMaterialSplit) != 0u;
    bool areDrawn = (device.flags & kFrameSplits) != 0u;
#ifdef CUTOUT
    float least = !hasParts ? leastAlpha(material.flags) : areDrawn ? kSolidAlpha : kAnyAlpha; // else the blended part alone is drawn
    // w: the size of a cut-out's picture in texels, for farShare; 0: `least` counts at every distance
    bool isCutOut = !hasParts && material.texture != kNoTexture;
    float size = isCutOut ? largerSide(textureRefs[material.texture]) : 0.0;
    vAlpha = alphaOf(material, material.colour.a * (hasParts ? opacity : 1.0), false, vec2(least, size));
#else
    vAlpha = blendedAlpha(material, opacity, hasParts && areDrawn ? vec2(kLeastAlpha, kSolidAlpha + kSplitOverlap) : kAllAlpha);
#endif
}
#endif

void setSurface(vec3 eyeRelative) {
    Material material = materials[materialRefs[inLook.x + (inPolygonSurface >> 16)]];
    float withFog = 1.0;
#ifdef BLENDED
    vCover = (material.flags & kMaterialAdditive) != 0u ? 0.0 : 1.0;
    withFog = vCover; // an additive surface covers no fog
#endif
    setTexture(material, lookOf(eyeRelative, material.colour.rgb, material.luminosity, material.diffuse, withFog));
    vUv = inUv;
#if defined(CUTOUT) || defined(BLENDED)
    setAlpha(material, inAmbient.a);
#endif
#if defined(CUTOUT) && defined(IDS)
    vPicture = material.texture;
#endif
}

void main() {
    vec3 eyeRelative = eyeRelativePlace();
    gl_Position = clipFromEye(eyeRelative);
#ifdef TERRAIN
    Look look = lookOf(eyeRelative, vec3(1.0), 0.0, 1.0, 1.0);
    vTimes = look.times;
    vPlus = look.plus;
    vUv = vec2(inUv.x, 1.0 - inUv.y);
    vTexture = uvec2(inLook.x + (inPolygonSurface >> 16), 0u);
#ifdef PAGES_BY_INDEX
    for (uint i = 0u; i < kPackedVectors; ++i) {
        vLayers[i] = packedLayers[vTexture.x * kPackedVectors + i];
    }
#endif
#else
    setSurface(eyeRelative);
#endif
#ifdef GATED
    vMembers = inMembers.xyz;
#endif
#ifdef IDS
    vId = inMembers.z + (inPolygonSurface & 0xFFFFu);
#endif
}
