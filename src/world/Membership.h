#pragma once

#include "world/World.h"

namespace limen::world {

/// Finds the spaces that a sphere reaches through open portals (docs/ray-rule.md). It stores the portals'
/// bounds, so the world's spaces and portals must not change during its life.
class Membership {
public:
    explicit Membership(const World& world);

    /// The spaces reached from `start`, which comes first, in the order of the search. `out` is overwritten.
    /// `closed`: by portal, nonzero for a shut one; empty: all are open.
    void reach(SpaceIndex start, const Sphere& sphere, std::span<const std::uint8_t> closed,
               std::vector<SpaceIndex>& out) const;
    /// Continues the search from all spaces in `out` and appends those it reaches.
    void extend(const Sphere& sphere, std::span<const std::uint8_t> closed,
                std::vector<SpaceIndex>& out) const;

private:
    [[nodiscard]] bool reaches(PortalIndex portal, const Sphere& sphere) const;

    const World& world_;
    std::vector<Sphere> bounds_; ///< by portal
};

} // namespace limen::world
