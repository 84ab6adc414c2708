// Every storage buffer of a frame, by the names the shaders use. Layout: SharedLayout.h.
#include "SharedLayout.h"

// EXACT: what a pixel shows, or a sample of it, is decided by the ray through its centre (outline.glsl).
#ifdef EXACT_OUTLINES
#define EXACT
#endif

// Read by both stages.
layout(std430, binding = kBindFrame) readonly buffer FrameBuffer { FrameConstants frame; };
layout(std430, binding = kBindBlocks) readonly buffer BlockBuffer { vec4 blocks[]; };
layout(std430, binding = kBindInstances) readonly buffer InstanceBuffer { Instance instances[]; };
layout(std430, binding = kBindMaterialRefs) readonly buffer MaterialRefBuffer { uint materialRefs[]; };
layout(std430, binding = kBindSky) readonly buffer SkyBuffer { SkyInstance skyInstances[]; };
layout(std430, binding = kBindMovers) readonly buffer MoverBuffer { Instance movers[]; };

// Drivers count what is declared, and some allow a stage no more than 16.
#if defined(VERTEX_STAGE) || defined(OWNERSHIP)
layout(std430, binding = kBindOwnership) readonly buffer OwnershipBuffer { OwnershipVertex ownershipVertices[]; };
layout(std430, binding = kBindClipSets) readonly buffer ClipSetBuffer { ClipSet clipSets[]; };
#else
layout(std430, binding = kBindVisits) readonly buffer VisitBuffer { Visit visits[]; };
layout(std430, binding = kBindMembers) readonly buffer MemberBuffer { Member members[]; };
layout(std430, binding = kBindMaterials) readonly buffer MaterialBuffer { Material materials[]; };
layout(std430, binding = kBindTerrain) readonly buffer TerrainBuffer { TerrainLayer terrainLayers[]; };
layout(std430, binding = kBindLightSets) readonly buffer LightSetBuffer { LightSet lightSets[]; };
layout(std430, binding = kBindLights) readonly buffer LightBuffer { Light lights[]; };
layout(std430, binding = kBindTextures) readonly buffer TextureBuffer { TextureRef textureRefs[]; };
layout(std430, binding = kBindMoverMembers) readonly buffer MoverMemberBuffer { Member moverMembers[]; };
#endif
// The vertex fetch's own arena (frame::gpu::Vertex), word by word.
const uint kVertexWords = 16u;
layout(std430, binding = kBindVertices) readonly buffer VertexBuffer { float arena[]; };

// What stands still and what moves are numbered on, from one array into the other.
Instance instanceAt(uint index) {
    if (index < frame.staticInstances) {
        return instances[index];
    }
    return movers[index - frame.staticInstances];
}

#if defined(FRAGMENT_STAGE) && !defined(OWNERSHIP)
Member memberAt(uint index) {
    if (index < frame.staticMembers) {
        return members[index];
    }
    return moverMembers[index - frame.staticMembers];
}
#endif

vec3 cornerAt(uint vertex) {
    uint at = vertex * kVertexWords;
    return vec3(arena[at], arena[at + 1u], arena[at + 2u]);
}

vec3 cornerRestAt(uint vertex) {
    uint at = vertex * kVertexWords + 13u;
    return vec3(arena[at], arena[at + 1u], arena[at + 2u]);
}

vec2 uvAt(uint vertex) {
    uint at = vertex * kVertexWords + 4u;
    return vec2(arena[at], arena[at + 1u]);
}

vec3 neighbourAt(uint vertex) {
    uint at = vertex * kVertexWords + 10u;
    return vec3(arena[at], arena[at + 1u], arena[at + 2u]);
}
