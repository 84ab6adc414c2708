#pragma once

#include "engine/IdTable.h"
#include "visibility/VisibleSet.h"

namespace limen::engine {

/// What a pixel's ray ends on, and by which openings it came there. Outlives the world it is about.
struct Picked {
    IdMeaning meaning;
    std::uint64_t object = 0;       ///< world::Instance::object; 0 for sky and void
    bool isLandscape = false;       ///< terrain: a whole block of it is one object
    double distance = 0.0;          ///< metres along the ray; infinite for sky and void
    std::vector<std::string> chain; ///< labels of the visits, from the eye's on
};

/// A pixel, as a frame with ids was drawn: the id, the number of the visit that owns it, and the distance.
[[nodiscard]] Picked pickedPixel(const world::World& world, const IdTable& table,
                                 const world::DynamicState& dynamics, const visibility::VisibleSet& visible,
                                 std::uint32_t id, std::uint32_t visit, double distance);

/// In lines: what it is, of which record, where, how far away, and then the chain.
[[nodiscard]] std::vector<std::string> pickedLines(const Picked& picked);

} // namespace limen::engine
