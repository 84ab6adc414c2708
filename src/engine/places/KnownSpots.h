#pragma once

#include "dat/Ids.h"
#include "geometry/Vec.h"

#include <span>

namespace limen::engine {

/// A well-known place of the original world. Positions are facts about its map.
struct KnownSpot {
    const char* name;
    dat::RecordId cell; ///< a cell, or a landcell (low word 1..0x40) for a place outdoors
    Vec3 feet;          ///< block-local, metres
    double yaw;         ///< degrees
    [[nodiscard]] bool isOutdoors() const { return (cell & 0xFFFFu) < dat::kFirstCell; }
};
/// Ascending by name.
[[nodiscard]] std::span<const KnownSpot> knownSpots();

/// The spot at which a world of the original's files begins.
inline constexpr const char* kKnownStart = "Holtburg";

} // namespace limen::engine
