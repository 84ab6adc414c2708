#pragma once

#include "worlds/Generated.h"
#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// The world of each kind as records. Requires: `spec.size` is within the kind's limit.
[[nodiscard]] WorldRecords buildDungeon(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildTown(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildComplex(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildSkewed(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildThin(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildNested(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildTerrainWorld(const GeneratedSpec& spec);
[[nodiscard]] WorldRecords buildMap(const GeneratedSpec& spec);

/// The random seed of a spec. Specs that differ in kind, size or seed have different ones.
[[nodiscard]] inline std::uint64_t seedOf(const GeneratedSpec& spec) {
    return static_cast<std::uint64_t>(spec.seed) << 32 ^ static_cast<std::uint64_t>(spec.size) << 4 ^
           static_cast<std::uint64_t>(spec.kind);
}

} // namespace limen::worlds
