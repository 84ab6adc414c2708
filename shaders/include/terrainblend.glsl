// Blending of a landcell's layers: a base texture, up to three terrain overlays and up to two roads, in that order.
#include "textures.glsl"

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

#if defined(FAST) && defined(PAGES_BY_INDEX)

vec4 packedTexels(uint place, vec2 uv) {
    return texture(pages[place & 0xFFu], vec3(uv, float((place & kPackedPlace) >> 8)));
}

vec3 packedColour(uvec2 layer, vec2 uv) {
    return packedTexels(layer.x, uv * float(layer.x >> kPackedTiling)).rgb;
}

// The layers of a landcell are constant over a triangle, so all fragments that are differentiated together take the
// same turns of the loop. `uv`: v downwards.
vec3 blendedPacked(uvec4 first, uvec4 second, uvec4 third, vec2 uv) {
    vec3 colour = packedColour(first.xy, uv);
    vec3 road = vec3(0.0);
    float roadKeeps = 1.0;
    for (uvec2 layer = first.zw; layer.y != 0u; layer = first.zw) {
        vec3 painted = packedColour(layer, uv);
        float keeps = packedTexels(layer.y, turned(uv - 0.5, layer.y >> kPackedTurns) + 0.5).a;
        keeps = (layer.y & kPackedMap) != 0u ? keeps : 0.0;
        bool isRoad = (layer.y & kPackedRoad) != 0u;
        colour = isRoad ? colour : mix(painted, colour, keeps);
        road = isRoad ? painted : road;
        roadKeeps *= isRoad ? keeps : 1.0;
        first.zw = second.xy;
        second = uvec4(second.zw, third.xy);
        third = uvec4(third.zw, 0u, 0u);
    }
    return mix(road, colour, roadKeeps);
}

#else

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
        count = terrainLayerAt(first + i).texture != kNoTexture ? i + 1u : count;
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
        TerrainLayer layer = terrainLayerAt(first + i);
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

#endif
