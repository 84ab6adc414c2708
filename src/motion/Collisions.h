#pragma once

#include "world/Solids.h"

#include <memory>
#include <optional>

namespace limen::motion {

/// An upright capsule; metres.
struct Capsule {
    double radius = 0.3;
    double height = 1.75; ///< of the whole, more than twice the radius
    [[nodiscard]] Vec3 middle(const Vec3& feet) const { return feet + Vec3(0.0, 0.0, height * 0.5); }
};

/// A body that moves: where its lowest point is, and the space that its middle is in.
struct Standing {
    Vec3 feet{0.0}; ///< global
    world::SpaceIndex space = world::kOutside;
};

/// What stops a sweep.
struct Bump {
    double share = 1.0; ///< of the way until there, 0..1
    Vec3 normal{0.0};   ///< unit, towards the body
    Vec3 at{0.0};       ///< where it is touched, global
};

/// A world's solids, ready to be bumped into. A body meets a place of a solid if a straight line from the body's middle leads, through
/// open openings, into a space where the solid is: so a cellar is not blocked by the ground that it lies under, nor a room by the wall
/// of the house around it, and a doorway is blocked by what stands in it on either side. Leaves of doors are where the doors' state puts
/// them, which every call says anew.
class Collisions {
public:
    /// The world must outlive it.
    Collisions(const world::World& world, world::Solids solids);
    ~Collisions();
    Collisions(Collisions&&) noexcept;
    Collisions& operator=(Collisions&&) noexcept;

    /// The first thing met by a capsule that moves from where it stands in a straight line. `doors`: how far each of World::doors
    /// stands open, 0..1; those beyond its end stand as they rest.
    [[nodiscard]] std::optional<Bump> sweep(const Capsule& capsule, const Standing& from, const Vec3& to,
                                            std::span<const double> doors) const;

    /// The normal, upwards, of the surface that a line down from `above` meets first within `depth` metres; of those that a body meets
    /// which stands there.
    [[nodiscard]] std::optional<Vec3> surfaceBelow(const Capsule& capsule, const Standing& standing,
                                                   const Vec3& above, double depth,
                                                   std::span<const double> doors) const;

    /// The shortest steps out of what a capsule overlaps, added; zero if that is nothing.
    [[nodiscard]] Vec3 wayOut(const Capsule& capsule, const Standing& standing,
                              std::span<const double> doors) const;
    /// The same of what one door consists of: its leaves, and while it is shut what fills the opening.
    [[nodiscard]] Vec3 wayOutOf(std::uint32_t door, const Capsule& capsule, const Standing& standing,
                                std::span<const double> doors) const;

    [[nodiscard]] const world::World& world() const;
    /// The blocks that are known.
    [[nodiscard]] dat::BlockCoord centre() const;
    [[nodiscard]] int radius() const;

private:
    struct Bodies;
    std::unique_ptr<Bodies> bodies_;
};

} // namespace limen::motion
