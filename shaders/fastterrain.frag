// Landscape of the fast way of drawing, blended as by terrain.frag. Out: colour; IDS: the landcell triangle's id, and
// FLAT its colour.
#include "textures.glsl"
#include "fastgate.glsl"
#include "idcolour.glsl"
#define LOOK in
#include "fastlook.glsl"
#include "terrainblend.glsl"
#ifdef DETAILS
#include "details.glsl"
#endif

layout(location = kOutputColour) out vec4 outColour;
#ifdef IDS
layout(location = kOutputId) out uint outId;
#endif

void main() {
#ifndef FLAT
#ifdef PAGES_BY_INDEX
    vec3 albedo = blendedPacked(vUv);
#else
    CellUv uv = CellUv(vUv, dFdx(vUv), dFdy(vUv));
    vec3 albedo = blendedTerrain(vTexture.x, uv);
#endif
#endif
#if defined(DETAILS) && !defined(FLAT)
    vec4 grain = texelsAt(vDetail.xy, vUv * uintBitsToFloat(vDetail.z));
#ifdef UNLIT_SHARE
    vec3 lit = grainedGround(albedo * vTimes, grain * vec4(vec3(vUnlit), 1.0), frame.nearPlane / gl_FragCoord.z);
#else
    albedo = grainedGround(albedo, grain, frame.nearPlane / gl_FragCoord.z);
#endif
#endif
#ifdef GATED
    if (!isSeen(vMembers)) {
        discard;
    }
#endif
#ifdef FLAT
    outColour = colourOfId(vId);
#else
#ifdef UNLIT_SHARE
    outColour = vec4(lit + vPlus, 1.0);
#else
    outColour = vec4(albedo * vTimes + vPlus, 1.0);
#endif
#endif
#ifdef IDS
    outId = vId;
#endif
}
