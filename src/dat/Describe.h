#pragma once

#include "dat/Codec.h"

#include <string>

// Records as JSON for people: ids in hexadecimal, floats in their shortest form (NaN and infinity as
// strings), short lists on one line. Pixels are replaced by their number.
namespace limen::dat {

[[nodiscard]] LIMEN_API std::string describe(const GfxObj& record);
[[nodiscard]] LIMEN_API std::string describe(const Setup& record);
[[nodiscard]] LIMEN_API std::string describe(const Animation& record);
[[nodiscard]] LIMEN_API std::string describe(const Palette& record);
[[nodiscard]] LIMEN_API std::string describe(const SurfaceTexture& record);
[[nodiscard]] LIMEN_API std::string describe(const RenderSurface& record);
[[nodiscard]] LIMEN_API std::string describe(const Surface& record);
[[nodiscard]] LIMEN_API std::string describe(const MotionTable& record);
[[nodiscard]] LIMEN_API std::string describe(const Environment& record);
[[nodiscard]] LIMEN_API std::string describe(const PaletteSet& record);
[[nodiscard]] LIMEN_API std::string describe(const ClothingTable& record);
[[nodiscard]] LIMEN_API std::string describe(const DegradeInfo& record);
[[nodiscard]] LIMEN_API std::string describe(const Scene& record);
[[nodiscard]] LIMEN_API std::string describe(const Region& record);
[[nodiscard]] LIMEN_API std::string describe(const ParticleEmitter& record);
[[nodiscard]] LIMEN_API std::string describe(const PhysicsScript& record);
[[nodiscard]] LIMEN_API std::string describe(const PhysicsScriptTable& record);
[[nodiscard]] LIMEN_API std::string describe(const LandBlock& record);
[[nodiscard]] LIMEN_API std::string describe(const LandBlockInfo& record);
[[nodiscard]] LIMEN_API std::string describe(const EnvCell& record);

/// Decodes and describes a payload as the kind of record that `id` is in a file of that role. For a kind that
/// Limen does not decode, gives size and first bytes. Errors: those of decode.
[[nodiscard]] LIMEN_API Result<std::string> describe(FileRole role, RecordId id, ByteView payload);

} // namespace limen::dat
