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

// GROUND_COLOURS, GROUND_MAPS: the pages of all textures and of all blend maps of the ground. Without them a page is chosen by
// index, which costs llvmpipe a branch for each page.
vec4 packedTexels(uint place, vec2 uv) {
    return texture(pages[place & 0xFFu], vec3(uv, float((place & kPackedPlace) >> 8)));
}

vec3 packedColour(uvec2 layer, vec2 uv) {
    vec2 at = uv * float(layer.x >> kPackedTiling);
#ifdef GROUND_COLOURS
    return texture(pages[GROUND_COLOURS], vec3(at, float((layer.x & kPackedPlace) >> 8))).rgb;
#else
    return packedTexels(layer.x, at).rgb;
#endif
}

// Share of the layers below that remains visible.
float packedKeeps(uvec2 layer, vec2 uv) {
    vec2 at = turned(uv - 0.5, layer.y >> kPackedTurns) + 0.5;
#ifdef GROUND_MAPS
    float keeps = texture(pages[GROUND_MAPS], vec3(at, float((layer.y & kPackedPlace) >> 8))).a;
#else
    float keeps = packedTexels(layer.y, at).a;
#endif
    return (layer.y & kPackedMap) != 0u ? keeps : 0.0;
}

// Bit i: layer i + 1 shows in this part of the cell. `word`, `bit`: of the part.
uint shownBit(uvec2 words, uint word, uint bit, uint i) {
    return ((word == 0u ? words.x : words.y) >> bit & 1u) << i;
}

uint shownAt(vec2 uv) {
    uvec2 part = uvec2(clamp(uv * float(kShownParts), vec2(0.0), vec2(kShownParts) - 0.5));
    uint number = part.y * kShownParts + part.x;
    uint word = number >> 5;
    uint bit = number & 31u;
    return shownBit(vShown[0].xy, word, bit, 0u) | shownBit(vShown[0].zw, word, bit, 1u) | shownBit(vShown[1].xy, word, bit, 2u) |
           shownBit(vShown[1].zw, word, bit, 3u) | shownBit(vShown[2].xy, word, bit, 4u);
}

// The bits of the four pixels that are differentiated together, so that they sample one layer at a time.
uint ofAllFour(uint bits) {
    vec2 towards = vec2(1.0) - 2.0 * vec2(uvec2(gl_FragCoord.xy) & 1u);
    float own = float(bits);
    bits |= uint(own + towards.x * dFdxFine(own) + 0.5);
    own = float(bits);
    return bits | uint(own + towards.y * dFdyFine(own) + 0.5);
}

// 0: the first after the base.
uvec2 layerAt(uint i) {
    uvec2 layer = i == 1u ? vLayers[1].xy : vLayers[0].zw;
    layer = i == 2u ? vLayers[1].zw : layer;
    layer = i == 3u ? vLayers[2].xy : layer;
    return i == 4u ? vLayers[2].zw : layer;
}

// Blends only the layers that show in the pixel's part of the cell. Other pixels of the same triangle may sample another
// layer in the same turn, so these layers have one page for their textures and one for their maps (PackedTerrain.h).
// `uv`: v downwards.
vec3 blendedPacked(vec2 uv) {
    vec3 colour = packedColour(vLayers[0].xy, uv);
    uint rest = ofAllFour(shownAt(uv));
    do { // once at least, because llvmpipe takes as long for no turn
        bool shows = rest != 0u;
        uvec2 layer = layerAt(uint(findLSB(rest)));
        rest &= rest - 1u;
        float keeps = packedKeeps(layer, uv);
        colour = mix(packedColour(layer, uv), colour, shows ? keeps : 1.0);
    } while (rest != 0u); // at the end: see walkChain in gate.glsl
    return colour;
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
    uint i = 0u;
    do {
        TerrainLayer layer = terrainLayerAt(first + i);
        if (layer.texture != kNoTexture) {
            vec3 painted = layerColour(layer, uv);
            float keeps = i == 0u ? 0.0 : keptUnder(layer, uv);
            if (i < kFirstRoad) {
                colour = mix(painted, colour, keeps);
            } else {
                road = i == kFirstRoad ? painted : road;
                roadKeeps *= keeps;
            }
        }
        ++i;
    } while (i < count); // at the end: see walkChain in gate.glsl
    return mix(road, colour, roadKeeps);
}

#endif
