// Lit colour of a fast mesh fragment, before its alpha: texel times the vertices' factors, with PIXEL_LAMPS the lamps of
// walls, and with DETAILS the grain. After fastlook.glsl and place.glsl.
#ifdef PIXEL_LAMPS
#include "incident.glsl"
#endif
#ifdef DETAILS
#include "details.glsl"
#endif

vec3 litColour(vec3 texel) {
#ifdef WALL_GRAIN
    texel = grained(texel, wallGrain(int(vDetail.x), uintBitsToFloat(vDetail.z), vUv));
#elif defined(DETAILS)
    float tiling = uintBitsToFloat(vDetail.z);
    for (uint i = 0u; i < (tiling > 0.0 ? 1u : 0u); ++i) { // a loop: see terrainblend.glsl
        texel = grained(texel, texelsAt(vDetail.xy, vUv * tiling));
    }
#endif
#ifdef PIXEL_LAMPS
    vec3 light = vLight;
    for (uint i = 0u; i < (vWallLamps.y > 0u ? 1u : 0u); ++i) {
        light = clamp(light + lampsOnWall(vWallLamps.x, vWallLamps.y - 1u, placeHere(), unitOrZero(vNormal)), 0.0, 1.0);
    }
    texel *= light;
#endif
    return texel * vTimes + vPlus;
}
