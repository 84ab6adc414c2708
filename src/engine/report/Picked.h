#pragma once

#include "engine/report/IdTable.h"
#include "visibility/VisibleSet.h"

namespace limen::engine {

/// The surface that a pixel's ray ends on, and the chain of visits that leads to it. Holds copies only, so it
/// may outlive the world.
struct Picked {
    IdMeaning meaning;
    std::uint64_t object = 0;       ///< world::Instance::object; 0 for sky and void
    bool isLandscape = false;       ///< terrain, where a whole block is one object
    double distance = 0.0;          ///< metres along the ray; infinite for sky and void
    std::string placed;             ///< of an object of a world.db: its name and its template's number
    std::vector<std::string> chain; ///< labels of the visits, the eye's first
};

/// Describes a pixel of a frame that was drawn with ids. `visit` is the pixel's leaf visit, `distance` is in
/// metres along the ray.
[[nodiscard]] Picked pickedPixel(const world::World& world, const IdTable& table,
                                 const world::DynamicState& dynamics, const visibility::VisibleSet& visible,
                                 std::uint32_t id, std::uint32_t visit, double distance);

/// As lines of text: the name of a placed object, kind, record and polygon, object and space, distance, then the chain.
[[nodiscard]] std::vector<std::string> pickedLines(const Picked& picked);

} // namespace limen::engine
