// Landscape: a base texture, up to three terrain overlays and up to two roads per landcell, blended in that order. In:
// uv is the position within the landcell, (0,0) at its south-west corner. Out: colour; the landcell triangle's id.
// FLAT: colour of the id.
#include "surface.glsl"
#include "idcolour.glsl"

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

// Share of the layers below that remains visible: 1 keeps them.
float keptUnder(TerrainLayer layer, CellUv uv) {
    if (layer.alpha == kNoTexture) {
        return 0.0;
    }
    CellUv map = turnedUv(uv, layer.rotation);
    return sampleTexture(layer.alpha, map.at, map.dx, map.dy).a;
}

// Base, three overlays, two roads: see TerrainCell.
const uint kFirstRoad = 4u;

uint layersPresent(uint first) {
    uint count = 1u;
    for (uint i = 1u; i < kLayersPerCell; ++i) {
        count = terrainLayers[first + i].texture != kNoTexture ? i + 1u : count;
    }
    return count;
}

// One loop over the present layers, with one sampling site. Drivers that execute every branch of an `if` for all
// fragments still leave a loop early.
vec3 blendedTerrain(uint cell, CellUv uv) {
    uint first = cell * kLayersPerCell;
    uint count = layersPresent(first);
    vec3 colour = vec3(1.0);
    vec3 road = vec3(0.0);
    float roadKeeps = 1.0; // two road maps form one road: texels that both keep remain
    for (uint i = 0u; i < count; ++i) {
        TerrainLayer layer = terrainLayers[first + i];
        if (layer.texture == kNoTexture) {
            continue;
        }
        vec3 painted = layerColour(layer, uv);
        float keeps = i == 0u ? 0.0 : keptUnder(layer, uv);
        if (i < kFirstRoad) {
            colour = mix(painted, colour, keeps);
        } else {
            road = i == kFirstRoad ? painted : road;
            roadKeeps *= keeps;
        }
    }
    return mix(road, colour, roadKeeps);
}

void main() {
    Painted painted = paintedHere();
    vec2 dx = dFdx(painted.uv);
    vec2 dy = dFdy(painted.uv);
    Instance instance = drawnInstance();
    GateResult keep = keepOf(instance);
    if (!keep.kept) {
        discard;
    }
#ifdef FLAT
    outColour = colourOfId(vId);
#else
    CellUv uv = CellUv(vec2(painted.uv.x, 1.0 - painted.uv.y), vec2(dx.x, -dx.y), vec2(dy.x, -dy.y));
    vec3 albedo = blendedTerrain(vSurface, uv);
    outColour = opaqueColour(albedo, 0.0, 1.0, painted, instance, keep);
#endif
    outId = vId;
}
