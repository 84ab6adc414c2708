// Values that fast.vert passes to the fragment stage. LOOK: out or in.
// Colour = texel * vTimes + vPlus; alpha = texel.a * vAlpha.x + vAlpha.y, kept from vAlpha.z to below vAlpha.w. Light,
// fog, highlights and materials without a texture all have this form.
#include "AtlasLayout.h"
#include "varyings.glsl"

layout(location = kVaryingTimes) LOOK vec3 vTimes;
layout(location = kVaryingPlus) LOOK vec3 vPlus;
layout(location = kVaryingFastUv) LOOK vec2 vUv;
layout(location = kVaryingTexture) flat LOOK uvec2 vTexture; // TextureRef.place.xy; TERRAIN: x: the landcell
#if defined(TERRAIN) && defined(PAGES_BY_INDEX)
layout(location = kVaryingLayers) flat LOOK uvec4 vLayers[kPackedVectors]; // PackedCell; three locations
layout(location = kVaryingShown) flat LOOK uvec4 vShown[kShownVectors];
#endif
#ifdef DETAILS
#if defined(ATLAS) && !defined(TERRAIN)
#define WALL_GRAIN // vDetail.x, z: arguments of wallGrain, the second as float bits
#endif
layout(location = kVaryingDetail) flat LOOK uvec3 vDetail; // TextureRef.place.xy; repeats, as float bits, 0: no grain
#endif
#if defined(DETAILS) && defined(TERRAIN) && defined(GRAIN_UNLIT)
#define UNLIT_SHARE
layout(location = kVaryingUnlit) LOOK float vUnlit; // share of an unlit colour: without fog and highlight
#endif
#ifdef PIXEL_LAMPS
// Then vTimes leaves out the light. Lamps of walls are added to vLight in each fragment.
layout(location = kVaryingFastLight) LOOK vec3 vLight;
layout(location = kVaryingFastNormal) LOOK vec3 vNormal;
layout(location = kVaryingWallLamps) flat LOOK uvec2 vWallLamps; // LightSet.firstLamp, lampCount; 0 for other objects
#endif
#if defined(CUTOUT) || defined(BLENDED)
layout(location = kVaryingAlpha) flat LOOK vec4 vAlpha;
#endif
#ifdef BLENDED
layout(location = kVaryingCover) flat LOOK float vCover; // 0: additive
layout(location = kVaryingBeforePlane) flat LOOK float vBeforePlane; // factor of the stored depth, >= 1
#endif
#if defined(GATED) && !defined(SKY)
layout(location = kVaryingMembers) flat LOOK uvec3 vMembers; // DrawRecord.members
#endif
#ifdef IDS
layout(location = kVaryingFastId) flat LOOK uint vId;
#ifdef CUTOUT
layout(location = kVaryingPicture) flat LOOK uint vPicture; // index into textures, or kNoTexture
#endif
#endif
