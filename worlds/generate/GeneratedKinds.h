#pragma once

#include "worlds/Generated.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The worlds of each kind as records. `spec.size` must be within the kind's limit.
[[nodiscard]] WorldRecords buildDungeon(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildTown(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildComplex(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildTerrainWorld(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildMap(const GeneratedSpec& spec);

/// A random stream of a spec's own.
[[nodiscard]] inline std::uint64_t seedOf(const GeneratedSpec& spec) {
    return static_cast<std::uint64_t>(spec.seed) << 32 ^ static_cast<std::uint64_t>(spec.size) << 4 ^
           static_cast<std::uint64_t>(spec.kind);
}

} // namespace limen::worlds
