#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "dat/records/Appearance.h"
#include "dat/records/Cells.h"
#include "dat/records/Effects.h"
#include "dat/records/Landscape.h"
#include "dat/records/Models.h"
#include "dat/records/Motion.h"
#include "dat/records/Textures.h"

#include <cstddef>
#include <span>

// Bytes to typed records and back. `decode` accepts the formats of docs/formats, checks every count against
// the remaining bytes before it allocates, and requires that the record ends at the end of its bytes. For
// every byte string that decodes, encode(decode(bytes)) gives the same bytes.
namespace limen::dat {

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

/// Decodes the payload of record `id`. Defined for all RecordTypes (RecordTypes.h). Errors name the id, the
/// offset in the payload and the expected value.
template <class Record>
[[nodiscard]] Result<Record> decode(RecordId id, ByteView payload);

/// The bytes of a record. Errors: BadArgument, with the id and the rule, for a record that the format cannot hold: a list
/// whose flag is not set, a list that is longer than its count can say, a polygon with two vertices.
template <class Record>
[[nodiscard]] Result<Bytes> encode(const Record& record);

template <>
LIMEN_API Result<GfxObj> decode<GfxObj>(RecordId, ByteView);
template <>
LIMEN_API Result<Setup> decode<Setup>(RecordId, ByteView);
template <>
LIMEN_API Result<Animation> decode<Animation>(RecordId, ByteView);
template <>
LIMEN_API Result<Palette> decode<Palette>(RecordId, ByteView);
template <>
LIMEN_API Result<SurfaceTexture> decode<SurfaceTexture>(RecordId, ByteView);
template <>
LIMEN_API Result<RenderSurface> decode<RenderSurface>(RecordId, ByteView);
template <>
LIMEN_API Result<Surface> decode<Surface>(RecordId, ByteView);
template <>
LIMEN_API Result<MotionTable> decode<MotionTable>(RecordId, ByteView);
template <>
LIMEN_API Result<Environment> decode<Environment>(RecordId, ByteView);
template <>
LIMEN_API Result<PaletteSet> decode<PaletteSet>(RecordId, ByteView);
template <>
LIMEN_API Result<ClothingTable> decode<ClothingTable>(RecordId, ByteView);
template <>
LIMEN_API Result<DegradeInfo> decode<DegradeInfo>(RecordId, ByteView);
template <>
LIMEN_API Result<Scene> decode<Scene>(RecordId, ByteView);
template <>
LIMEN_API Result<Region> decode<Region>(RecordId, ByteView);
template <>
LIMEN_API Result<ParticleEmitter> decode<ParticleEmitter>(RecordId, ByteView);
template <>
LIMEN_API Result<PhysicsScript> decode<PhysicsScript>(RecordId, ByteView);
template <>
LIMEN_API Result<PhysicsScriptTable> decode<PhysicsScriptTable>(RecordId, ByteView);
template <>
LIMEN_API Result<LandBlock> decode<LandBlock>(RecordId, ByteView);
template <>
LIMEN_API Result<LandBlockInfo> decode<LandBlockInfo>(RecordId, ByteView);
template <>
LIMEN_API Result<EnvCell> decode<EnvCell>(RecordId, ByteView);

template <>
LIMEN_API Result<Bytes> encode<GfxObj>(const GfxObj&);
template <>
LIMEN_API Result<Bytes> encode<Setup>(const Setup&);
template <>
LIMEN_API Result<Bytes> encode<Animation>(const Animation&);
template <>
LIMEN_API Result<Bytes> encode<Palette>(const Palette&);
template <>
LIMEN_API Result<Bytes> encode<SurfaceTexture>(const SurfaceTexture&);
template <>
LIMEN_API Result<Bytes> encode<RenderSurface>(const RenderSurface&);
template <>
LIMEN_API Result<Bytes> encode<Surface>(const Surface&);
template <>
LIMEN_API Result<Bytes> encode<MotionTable>(const MotionTable&);
template <>
LIMEN_API Result<Bytes> encode<Environment>(const Environment&);
template <>
LIMEN_API Result<Bytes> encode<PaletteSet>(const PaletteSet&);
template <>
LIMEN_API Result<Bytes> encode<ClothingTable>(const ClothingTable&);
template <>
LIMEN_API Result<Bytes> encode<DegradeInfo>(const DegradeInfo&);
template <>
LIMEN_API Result<Bytes> encode<Scene>(const Scene&);
template <>
LIMEN_API Result<Bytes> encode<Region>(const Region&);
template <>
LIMEN_API Result<Bytes> encode<ParticleEmitter>(const ParticleEmitter&);
template <>
LIMEN_API Result<Bytes> encode<PhysicsScript>(const PhysicsScript&);
template <>
LIMEN_API Result<Bytes> encode<PhysicsScriptTable>(const PhysicsScriptTable&);
template <>
LIMEN_API Result<Bytes> encode<LandBlock>(const LandBlock&);
template <>
LIMEN_API Result<Bytes> encode<LandBlockInfo>(const LandBlockInfo&);
template <>
LIMEN_API Result<Bytes> encode<EnvCell>(const EnvCell&);

} // namespace limen::dat
