// Storage buffers and buffer textures, by the names that the shaders use. Layout: SharedLayout.h.
#include "SharedLayout.h"
#include "varyings.glsl"

// EXACT: the ray through a pixel or sample decides its colour, not the rasteriser's coverage (outline.glsl).
#ifdef EXACT_OUTLINES
#define EXACT
#endif

// Read by every stage. FrameConstants as a uniform block: software drivers read storage buffers lane by lane in
// fragments, even at an address that all lanes share.
layout(std140, binding = kBindFrame) uniform FrameBlock {
    ViewConstants frame;
    DeviceConstants device;
};

// Drivers count declared blocks. Some allow 16 per stage, and 8 in compute.
#ifdef COMPUTE_STAGE
layout(std430, binding = kBindCommands) writeonly buffer CommandBuffer { uint commands[]; };
layout(std430, binding = kBindLevels) readonly buffer LevelBuffer { Level levels[]; };
layout(std430, binding = kBindIndices) readonly buffer IndexBuffer { uint indices[]; };
layout(std430, binding = kBindKeptIndices) writeonly buffer KeptIndexBuffer { uint keptIndices[]; };
layout(std430, binding = kBindTiles) buffer TileBuffer { float tileDepths[]; };
#else
layout(std430, binding = kBindLightSets) readonly buffer LightSetBuffer { LightSet lightSets[]; };
layout(std430, binding = kBindLampRefs) readonly buffer LampRefBuffer { uint lampRefs[]; };
layout(std430, binding = kBindOwnership) readonly buffer OwnershipBuffer { OwnershipVertex ownershipVertices[]; };
layout(std430, binding = kBindClipSets) readonly buffer ClipSetBuffer { ClipSet clipSets[]; };
layout(std430, binding = kBindSky) readonly buffer SkyBuffer { SkyInstance skyInstances[]; };
#endif
layout(binding = kUnitRing) uniform usamplerBuffer ringTexels;
layout(binding = kUnitVertices) uniform usamplerBuffer vertexTexels;
layout(binding = kUnitInstances) uniform usamplerBuffer instanceTexels;
layout(binding = kUnitMembers) uniform usamplerBuffer memberTexels;
#ifdef COMPUTE_STAGE
layout(binding = kUnitPieces) uniform usamplerBuffer pieceTexels;
#else
layout(binding = kUnitMaterials) uniform usamplerBuffer materialTexels;
layout(binding = kUnitMaterialRefs) uniform usamplerBuffer materialRefTexels;
layout(binding = kUnitTextures) uniform usamplerBuffer textureRefTexels;
layout(binding = kUnitTerrain) uniform usamplerBuffer terrainTexels;
#endif

const float kSkyDepth = uintBitsToFloat((127u - kSkyExponent) << 23); // 2^-kSkyExponent
const float kVoidDepth = uintBitsToFloat((127u - kVoidExponent) << 23); // 2^-kVoidExponent

uvec4 ringTexel(uint texel) {
    return texelFetch(ringTexels, int(texel));
}

uint memberCountOf(Instance instance) {
    return instance.membersAndKind & kMostMembers;
}

uint kindOf(Instance instance) {
    return instance.membersAndKind >> 16;
}

// Rows of the linear part of the pose.
mat3 rowsOf(Instance instance) {
    return mat3(instance.pose0.x, instance.pose0.w, instance.pose1.z, instance.pose0.y, instance.pose1.x, instance.pose1.w,
                instance.pose0.z, instance.pose1.y, instance.pose2.x);
}

vec3 originOf(Instance instance) {
    return instance.pose2.yzw;
}

Instance instanceOf(uvec4 pose0, uvec4 pose1, uvec4 pose2, uvec4 first, uvec4 second) {
    return Instance(uintBitsToFloat(pose0), uintBitsToFloat(pose1), uintBitsToFloat(pose2), first.x & kBlockMask, first.y, first.z, first.w,
                    second.x, second.y, second.z, uintBitsToFloat(second.w));
}

// Static and dynamic instances have consecutive numbers, across two arrays.
Instance instanceAt(uint index) {
    if (index < frame.staticInstances) {
        int at = int(index * kInstanceTexels);
        return instanceOf(texelFetch(instanceTexels, at), texelFetch(instanceTexels, at + 1),
                          texelFetch(instanceTexels, at + 2), texelFetch(instanceTexels, at + 3),
                          texelFetch(instanceTexels, at + 4));
    }
    uint at = device.firstInstance + (index - frame.staticInstances) * kInstanceTexels;
    return instanceOf(ringTexel(at), ringTexel(at + 1u), ringTexel(at + 2u), ringTexel(at + 3u), ringTexel(at + 4u));
}

#ifdef COMPUTE_STAGE
// Offsets and rectangles of a slot's run.
RunOffsets offsetsOf(uint slot, out uint rects) {
    uvec4 group = ringTexel(device.firstSlotGroup + slot / kSlotsPerGroup);
    RunOffsets offsets = RunOffsets(group.x, group.y);
    uint low = group.z;
    uint high = group.w;
    while (low < high) { // `offsets` belongs to `low`
        uint middle = (low + high + 1u) / 2u;
        uvec4 run = ringTexel(device.firstRun + middle);
        if (run.z <= slot) {
            low = middle;
            offsets = RunOffsets(run.x, run.y);
        } else {
            high = middle - 1u;
        }
    }
    rects = ringTexel(device.firstRun + low).w;
    return offsets;
}

// The record that draws an instance in this frame.
uint recordOf(uint instance) {
    for (uint i = 0u; i < frame.replacementCount; ++i) {
        uvec4 pair = ringTexel(device.firstReplacement + i / 2u);
        uvec2 replaced = i % 2u == 1u ? pair.zw : pair.xy;
        if (replaced.x == instance) {
            return replaced.y;
        }
    }
    return instance;
}

// Static pieces and the frame's own have consecutive numbers.
DrawPiece pieceAt(uint index) {
    uvec4 piece = index < frame.staticPieces ? texelFetch(pieceTexels, int(index))
                                             : ringTexel(device.firstPiece + (index - frame.staticPieces));
    return DrawPiece(piece.x, piece.y, piece.z, piece.w);
}
#endif

vec3 blockOrigin(uint block) {
    return uintBitsToFloat(ringTexel(device.firstBlock + block).xyz);
}

#ifndef COMPUTE_STAGE
uint materialRefAt(uint index) {
    return texelFetch(materialRefTexels, int(index / kMaterialRefsPerTexel))[index % kMaterialRefsPerTexel];
}

Material materialAt(uint index) {
    int at = int(index * kMaterialTexels);
    uvec4 rest = texelFetch(materialTexels, at + 1);
    return Material(uintBitsToFloat(texelFetch(materialTexels, at)), rest.x, rest.y, uintBitsToFloat(rest.z), uintBitsToFloat(rest.w));
}

TextureRef textureRefAt(uint index) {
    return TextureRef(texelFetch(textureRefTexels, int(index)));
}

// One layer of a landcell (`index` counts the layers of all), or one vector of a packed landcell.
TerrainLayer terrainLayerAt(uint index) {
    uvec4 layer = texelFetch(terrainTexels, int(index));
    return TerrainLayer(layer.x, layer.y, layer.z, uintBitsToFloat(layer.w));
}

uvec4 packedLayersAt(uint index) {
    return texelFetch(terrainTexels, int(index));
}
#endif

#if !defined(COMPUTE_STAGE) && !defined(OWNERSHIP)
Member memberAt(uint index) {
    uvec4 pair = index < frame.staticMembers ? texelFetch(memberTexels, int(index / 2u))
                                             : ringTexel(device.firstMember + (index - frame.staticMembers) / 2u);
    bool isSecond = (index < frame.staticMembers ? index : index - frame.staticMembers) % 2u == 1u;
    return isSecond ? Member(pair.z, pair.w) : Member(pair.x, pair.y);
}
#endif

// The first texel of a visit.
vec4 entryPlaneAt(uint visit) {
    return uintBitsToFloat(ringTexel(device.firstVisit + visit * kVisitTexels));
}

#if defined(FRAGMENT_STAGE) && !defined(OWNERSHIP)
Visit visitAt(uint index) {
    uvec4 rest = ringTexel(device.firstVisit + index * kVisitTexels + 1u);
    return Visit(entryPlaneAt(index), rest.x, rest.y, rest.z, rest.w);
}
#endif

uvec4 vertexTexel(uint vertex, uint texel) {
    return texelFetch(vertexTexels, int(vertex * kVertexTexels + texel));
}

vec3 cornerAt(uint vertex) {
    return uintBitsToFloat(vertexTexel(vertex, 0u).xyz);
}

vec3 cornerRestAt(uint vertex) {
    return uintBitsToFloat(vertexTexel(vertex, 3u).yzw);
}

vec2 uvAt(uint vertex) {
    return uintBitsToFloat(vertexTexel(vertex, 1u).xy);
}

// Signed normalised 10-10-10-2, decoded as the vertex fetch does.
vec3 normalAt(uint vertex) {
    int bits = int(vertexTexel(vertex, 0u).w);
    return max(vec3(ivec3(bits << 22, bits << 12, bits << 2) >> 22) / 511.0, -1.0);
}

vec3 facetAt(uint vertex) {
    return uintBitsToFloat(uvec3(vertexTexel(vertex, 1u).w, vertexTexel(vertex, 2u).xy));
}

vec3 neighbourAt(uint vertex) {
    return uintBitsToFloat(uvec3(vertexTexel(vertex, 2u).zw, vertexTexel(vertex, 3u).x));
}
