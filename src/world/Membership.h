#pragma once

#include "world/World.h"

namespace limen::world {

/// Finds the spaces that a ball reaches through open portals (docs/ray-rule.md). Remembers the
/// portals' bounds, so the world's spaces and portals must not change while it lives.
class Membership {
public:
    explicit Membership(const World& world);

    /// The spaces reached from `start`, which comes first, in the order they are reached. `out` is
    /// overwritten. `closed`: by portal, nonzero stops the ball; empty: all are open.
    void reach(SpaceIndex start, const Sphere& sphere, std::span<const std::uint8_t> closed,
               std::vector<SpaceIndex>& out) const;
    /// Goes on from all that `out` holds.
    void extend(const Sphere& sphere, std::span<const std::uint8_t> closed,
                std::vector<SpaceIndex>& out) const;

private:
    [[nodiscard]] bool reaches(PortalIndex portal, const Sphere& sphere) const;

    const World& world_;
    std::vector<Sphere> bounds_; ///< by portal
};

} // namespace limen::world
