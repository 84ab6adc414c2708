// Landscape: a base texture, up to three terrain overlays and up to two roads per landcell, blended in that order
// (formats: landscape.md section 7). In: vUv is the position within the landcell, (0,0) at its south-west corner.
// Out: colour; the landcell triangle's id.
#include "surface.glsl"

layout(location = kOutputColour) out vec4 outColour;
layout(location = kOutputId) out uint outId;

// Position in a landcell (v downwards, north-west corner at the origin) and its derivatives.
struct CellUv {
    vec2 at;
    vec2 dx;
    vec2 dy;
};

vec2 turned(vec2 v, uint rotation) {
    switch (rotation & 3u) {
    case 1u: return vec2(-v.y, v.x);
    case 2u: return -v;
    case 3u: return vec2(v.y, -v.x);
    }
    return v;
}

// Quarter turns about the middle of the cell.
CellUv turnedUv(CellUv uv, uint rotation) {
    return CellUv(turned(uv.at - 0.5, rotation) + 0.5, turned(uv.dx, rotation), turned(uv.dy, rotation));
}

vec3 layerColour(TerrainLayer layer, CellUv uv) {
    return sampleTexture(layer.texture, uv.at * layer.tiling, uv.dx * layer.tiling, uv.dy * layer.tiling).rgb;
}

// How much of what lies underneath a layer stays: 1 keeps it.
float keptUnder(TerrainLayer layer, CellUv uv) {
    if (layer.alpha == kNoTexture) {
        return 0.0;
    }
    CellUv map = turnedUv(uv, layer.rotation);
    return sampleTexture(layer.alpha, map.at, map.dx, map.dy).a;
}

vec3 blendedTerrain(TerrainCell cell, CellUv uv) {
    vec3 colour = cell.base.texture == kNoTexture ? vec3(1.0) : layerColour(cell.base, uv);
    for (int i = 0; i < 3; ++i) {
        if (cell.overlays[i].texture != kNoTexture) {
            colour = mix(layerColour(cell.overlays[i], uv), colour, keptUnder(cell.overlays[i], uv));
        }
    }
    // Two road maps are one road: what both keep stays.
    if (cell.roads[0].texture != kNoTexture) {
        float keep = keptUnder(cell.roads[0], uv);
        if (cell.roads[1].texture != kNoTexture) {
            keep *= keptUnder(cell.roads[1], uv);
        }
        colour = mix(layerColour(cell.roads[0], uv), colour, keep);
    }
    return colour;
}

void main() {
    vec2 dx = dFdx(vUv);
    vec2 dy = dFdy(vUv);
    Instance instance = instances[vInstance];
    Keep keep = keepOf(instance, vEyeRelative);
    if (!keep.kept) {
        discard;
    }
    CellUv uv = CellUv(vec2(vUv.x, 1.0 - vUv.y), vec2(dx.x, -dx.y), vec2(dy.x, -dy.y));
    vec3 albedo = blendedTerrain(terrainCells[vSurface], uv);
    outColour = opaqueColour(albedo, 0.0, 1.0, instance, keep);
    outId = vId;
}
