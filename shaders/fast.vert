// Vertices of every mesh for the fast way of drawing, terrain included: light, fog, highlight and material at the
// vertex, so that a fragment reads one texel and little else (fastlook.glsl).
// In: one vertex of the arena, model space; the DrawRecord of its draw. Out: clip position; factors of the texel; the
// texture.
// TERRAIN: the surface is the landcell's index in its block, else the surface's slot in its mesh. CUTOUT, BLENDED: the
// limits of alpha. GATED: the members that the ownership test needs. LAMPS: with the lamps of the record. PIXEL_LAMPS:
// fragments add those of walls. DETAILS: the detail picture. IDS: the polygon's id.
#include "incident.glsl"

layout(location = kAttributePosition) in vec3 inPosition;
layout(location = kAttributeNormal) in vec4 inNormal;
layout(location = kAttributeUv) in vec2 inUv;
layout(location = kAttributePolygonSurface) in uint inPolygonSurface;
#ifdef BLENDED
layout(location = kAttributeFacet) in vec3 inFacet; // of the first triangle of those that share the vertex
#endif
layout(location = kAttributeRest) in vec3 inRest;
layout(location = kAttributeRow0) in vec4 inRow0; // DrawRecord
layout(location = kAttributeRow1) in vec4 inRow1;
layout(location = kAttributeRow2) in vec4 inRow2;
layout(location = kAttributeOffsetRest) in vec4 inOffsetRest;
layout(location = kAttributeAmbient) in vec4 inAmbient;
layout(location = kAttributeSun) in vec4 inSun;
layout(location = kAttributeLook) in uvec4 inLook;
layout(location = kAttributeMembers) in uvec4 inMembers;

invariant gl_Position;
#include "clip.glsl"
#include "wide.glsl"
#define LOOK out
#include "fastlook.glsl"
#include "fastmaterial.glsl"

vec3 turned(vec3 v) {
    precise vec3 result = vec3(inRow0.x * v.x + inRow0.y * v.y + inRow0.z * v.z, inRow1.x * v.x + inRow1.y * v.y + inRow1.z * v.z,
                               inRow2.x * v.x + inRow2.y * v.y + inRow2.z * v.z);
    return result;
}

// Near the eye, the first sum is exact: the offset is the eye's position, rounded. Shells and exteriors are block-local, so their rests are up
// to 8 micrometres; without them an eye nearer than that to a wall saw its back (decision 222).
vec3 eyeRelativePlace() {
    precise vec3 result = (turned(inPosition) + vec3(inRow0.w, inRow1.w, inRow2.w)) + (turned(inRest) + inOffsetRest.xyz);
    return result;
}

// Of depth: so much that another program's rounding does not bring the same surface to the front.
const float kBehindRoot = 1.0 - 1.0 / 1048576.0;

const uint kLightKind = kRecordFilling - 1u;

#ifdef DETAILS
// After vTexture.
void setDetail() {
    uint detail = inMembers.w >> kRecordDetail;
    float tiling = frame.detailTiling[detail];
#ifdef WALL_GRAIN
    uint row = tiling > 0.0 ? 1u + (detail - kDetailOfExteriors) * kGrainRows : kNoGrainRow;
    vDetail = uvec3(row, 0u, floatBitsToUint(tiling * float(kGrainSide)));
#else
    vDetail = uvec3(tiling > 0.0 ? textureRefAt(frame.detailTextures[detail]).place.xy : uvec2(0u), floatBitsToUint(tiling));
#endif
}
#endif

#ifdef SURFACE_DIFFUSE
float diffuse = 1.0; // of the surface
#else
const float diffuse = 1.0;
#endif

// Factors of a surface with this colour: the light, then fog and highlight over it. PIXEL_LAMPS: without the light.
Look lookOf(vec3 eyeRelative, vec3 albedo, float emission, float fogged) {
    Incident incident = Incident(inAmbient.rgb, inSun.rgb * diffuse, inMembers.w & kLightKind, inLook.z, inLook.w);
    vec3 origin = vec3(inRow0.w, inRow1.w, inRow2.w);
    vec3 normal = litNormal(turned(inNormal.xyz));
    vec3 light = lightAt(incident, emission, eyeRelative, normal, origin);
#ifdef PIXEL_LAMPS
    vLight = light;
    vNormal = normal;
    vWallLamps = incident.kind == kLitWalls ? uvec2(incident.firstLamp, incident.lampCount + 1u) : uvec2(0u);
    light = vec3(1.0);
#endif
    float fog = fogged * fogOn(incident.kind, eyeRelative);
    vec4 over = unpackUnorm4x8(inLook.y);
#ifdef UNLIT_SHARE
    vUnlit = (1.0 - fog) * (1.0 - over.a);
#endif
#ifdef BLENDED
    vec2 shares = vec2((1.0 - over.a) * (1.0 - fog), over.a * (1.0 - fog)); // of the light, of the highlight
    return Look(albedo * light * shares.x, over.rgb * shares.y + frame.fogColour.rgb * fog);
#else
    return Look(albedo * light * ((1.0 - fog) * (1.0 - over.a)),
                frame.fogColour.rgb * (fog * (1.0 - over.a)) + over.rgb * over.a);
#endif
}

#if defined(CUTOUT) || defined(BLENDED)
void setAlpha(Material material, float opacity) {
    bool hasParts = (material.flags & kMaterialSplit) != 0u;
    bool areDrawn = (device.flags & kFrameSplits) != 0u;
#ifdef CUTOUT
    float least = !hasParts ? leastAlpha(material.flags) : areDrawn ? kSolidAlpha : kAnyAlpha; // else the blended part alone is drawn
    // w: the size of a cut-out's picture in texels, for farShare; 0: `least` counts at every distance
    bool isCutOut = !hasParts && material.texture != kNoTexture;
    float size = isCutOut ? largerSide(textureRefAt(material.texture)) : 0.0;
    vAlpha = alphaOf(material, material.colour.a * (hasParts ? opacity : 1.0), false, vec2(least, size));
#else
    vAlpha = blendedAlpha(material, opacity, hasParts && areDrawn ? vec2(kLeastAlpha, kSolidAlpha + kSplitOverlap) : kAllAlpha);
#endif
}
#endif

void setSurface(vec3 eyeRelative) {
    Material material = materialAt(materialRefAt(inLook.x + (inPolygonSurface >> 16)));
#ifdef SURFACE_DIFFUSE
    diffuse = material.diffuse;
#endif
    float fogged = 1.0;
#ifdef BLENDED
    vCover = (material.flags & kMaterialAdditive) != 0u ? 0.0 : 1.0;
    fogged = vCover; // fog passes additive surfaces by
#endif
    Look look = lookOf(eyeRelative, material.colour.rgb, material.luminosity, fogged);
    setTexture(material, look);
#ifdef PIXEL_LAMPS
    if (material.texture == kNoTexture) { // lit at its vertices
        vec3 lamps = vWallLamps.y > 0u ? lampsOnWall(vWallLamps.x, vWallLamps.y - 1u, eyeRelative, vNormal) : vec3(0.0);
        vPlus = look.plus + look.times * clamp(vLight + lamps, 0.0, 1.0);
    }
#endif
    vUv = inUv;
#if defined(CUTOUT) || defined(BLENDED)
    setAlpha(material, inAmbient.a);
#endif
#if defined(CUTOUT) && defined(IDS)
    vPicture = material.texture;
#endif
}

#ifdef BLENDED
// Of the surfaces in an opening's plane, a pane comes first (onpolygon.glsl, beforePlane): its depth is that of a plane kInPlaneTolerance
// nearer to the eye. Yields the factor of the stored depth, near plane / view depth, which is one for all of a plane. The
// parts of the pane that a near plane moved by the factor cuts off are nearer than any ray meets it.
float timesBeforePlane(vec3 eyeRelative) {
    vec3 normal = turned(inFacet);
    float height = abs(dot(normal, eyeRelative)) / max(length(normal), 1.0e-6);
    float most = max(height / (4.0 * frame.nearPlane), 1.0);
    float nearer = height - kInPlaneTolerance;
    return nearer * most > height ? height / nearer : most;
}
#endif

void main() {
    vec3 eyeRelative = eyeRelativePlace();
    gl_Position = clipFromEye(eyeRelative);
#if defined(GATED) && !defined(BLENDED)
    gl_Position.z *= (frame.flags & kFrameRootFirst) != 0u ? kBehindRoot : 1.0;
#endif
#ifdef BLENDED
    vBeforePlane = (inMembers.w & kRecordFilling) != 0u ? timesBeforePlane(eyeRelative) : 1.0;
    gl_Position.z *= vBeforePlane;
#endif
    clipBy(uint(inOffsetRest.w));
    gl_Position = widened(gl_Position);
#ifdef TERRAIN
    Look look = lookOf(eyeRelative, vec3(1.0), 0.0, 1.0);
    vTimes = look.times;
    vPlus = look.plus;
    vUv = vec2(inUv.x, 1.0 - inUv.y);
    vTexture = uvec2(inLook.x + (inPolygonSurface >> 16), 0u);
#ifdef PAGES_BY_INDEX
    uint cell = vTexture.x * (kPackedVectors + kShownVectors);
    for (uint i = 0u; i < kPackedVectors; ++i) {
        vLayers[i] = packedLayersAt(cell + i);
        vShown[i] = packedLayersAt(cell + kPackedVectors + i);
    }
#endif
#else
    setSurface(eyeRelative);
#endif
#ifdef DETAILS
    setDetail();
#endif
#ifdef GATED
    vMembers = inMembers.xyz;
#endif
#ifdef IDS
    vId = inMembers.z + (inPolygonSurface & 0xFFFFu);
#endif
}
