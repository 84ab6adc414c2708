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
// every byte string that decodes, encode(decode(bytes)) == bytes.
namespace limen::dat {

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

/// Decodes the payload of record `id`. Defined for all RecordTypes (RecordTypes.h). Errors name the id, the
/// offset in the payload and the expected value.
template <class Record>
[[nodiscard]] Result<Record> decode(RecordId id, ByteView payload);

/// The bytes of a record. Requires: flags and lists agree (README.md).
template <class Record>
[[nodiscard]] Bytes encode(const Record& record);

template <>
Result<GfxObj> decode<GfxObj>(RecordId, ByteView);
template <>
Result<Setup> decode<Setup>(RecordId, ByteView);
template <>
Result<Animation> decode<Animation>(RecordId, ByteView);
template <>
Result<Palette> decode<Palette>(RecordId, ByteView);
template <>
Result<SurfaceTexture> decode<SurfaceTexture>(RecordId, ByteView);
template <>
Result<RenderSurface> decode<RenderSurface>(RecordId, ByteView);
template <>
Result<Surface> decode<Surface>(RecordId, ByteView);
template <>
Result<MotionTable> decode<MotionTable>(RecordId, ByteView);
template <>
Result<Environment> decode<Environment>(RecordId, ByteView);
template <>
Result<PaletteSet> decode<PaletteSet>(RecordId, ByteView);
template <>
Result<ClothingTable> decode<ClothingTable>(RecordId, ByteView);
template <>
Result<DegradeInfo> decode<DegradeInfo>(RecordId, ByteView);
template <>
Result<Scene> decode<Scene>(RecordId, ByteView);
template <>
Result<Region> decode<Region>(RecordId, ByteView);
template <>
Result<ParticleEmitter> decode<ParticleEmitter>(RecordId, ByteView);
template <>
Result<PhysicsScript> decode<PhysicsScript>(RecordId, ByteView);
template <>
Result<PhysicsScriptTable> decode<PhysicsScriptTable>(RecordId, ByteView);
template <>
Result<LandBlock> decode<LandBlock>(RecordId, ByteView);
template <>
Result<LandBlockInfo> decode<LandBlockInfo>(RecordId, ByteView);
template <>
Result<EnvCell> decode<EnvCell>(RecordId, ByteView);

template <>
Bytes encode<GfxObj>(const GfxObj&);
template <>
Bytes encode<Setup>(const Setup&);
template <>
Bytes encode<Animation>(const Animation&);
template <>
Bytes encode<Palette>(const Palette&);
template <>
Bytes encode<SurfaceTexture>(const SurfaceTexture&);
template <>
Bytes encode<RenderSurface>(const RenderSurface&);
template <>
Bytes encode<Surface>(const Surface&);
template <>
Bytes encode<MotionTable>(const MotionTable&);
template <>
Bytes encode<Environment>(const Environment&);
template <>
Bytes encode<PaletteSet>(const PaletteSet&);
template <>
Bytes encode<ClothingTable>(const ClothingTable&);
template <>
Bytes encode<DegradeInfo>(const DegradeInfo&);
template <>
Bytes encode<Scene>(const Scene&);
template <>
Bytes encode<Region>(const Region&);
template <>
Bytes encode<ParticleEmitter>(const ParticleEmitter&);
template <>
Bytes encode<PhysicsScript>(const PhysicsScript&);
template <>
Bytes encode<PhysicsScriptTable>(const PhysicsScriptTable&);
template <>
Bytes encode<LandBlock>(const LandBlock&);
template <>
Bytes encode<LandBlockInfo>(const LandBlockInfo&);
template <>
Bytes encode<EnvCell>(const EnvCell&);

} // namespace limen::dat
