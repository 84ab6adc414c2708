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

/// The position of a body: its lowest point, and the space that its middle is in.
struct Standing {
    Vec3 feet{0.0}; ///< global
    world::SpaceIndex space = world::kOutside;
};

/// The contact that ends a sweep.
struct Bump {
    double share = 1.0; ///< of the way up to the contact, 0..1
    Vec3 normal{0.0};   ///< unit, towards the body
    Vec3 at{0.0};       ///< point of contact, global
};

/// The solids of a world, prepared for collision queries. A body collides with a point of a solid only if a
/// straight line from the body's middle leads to the point through open openings, into a space that the solid
/// is a member of. So terrain above a cellar does not block the cellar, nor a house's exterior its rooms,
/// while a doorway is blocked from both sides by anything that stands in it. Door leaves are posed anew in
/// every call, by the openness of the doors.
class Collisions {
public:
    /// The world must outlive it.
    Collisions(const world::World& world, world::Solids solids);
    ~Collisions();
    Collisions(Collisions&&) noexcept;
    Collisions& operator=(Collisions&&) noexcept;

    /// The first contact of a capsule that moves in a straight line; none if the way is free. `doors`:
    /// openness of each of World::doors, 0..1; doors beyond the end have the world file's openness.
    [[nodiscard]] std::optional<Bump> sweep(const Capsule& capsule, const Standing& from, const Vec3& to,
                                            std::span<const double> doors) const;

    /// The unit normal, turned upwards, of the first surface within `depth` metres below `above`. Only
    /// surfaces count that a body at `standing` collides with.
    [[nodiscard]] std::optional<Vec3> surfaceBelow(const Capsule& capsule, const Standing& standing,
                                                   const Vec3& above, double depth,
                                                   std::span<const double> doors) const;

    /// The sum of the shortest ways out of all solids that a capsule overlaps; zero without overlap.
    [[nodiscard]] Vec3 wayOut(const Capsule& capsule, const Standing& standing,
                              std::span<const double> doors) const;
    /// The same for one door alone: its leaves, and while it is shut its filling.
    [[nodiscard]] Vec3 wayOutOf(std::uint32_t door, const Capsule& capsule, const Standing& standing,
                                std::span<const double> doors) const;

    [[nodiscard]] const world::World& world() const;
    /// The square of blocks whose solids are known: its middle, and its radius in blocks.
    [[nodiscard]] dat::BlockCoord centre() const;
    [[nodiscard]] int radius() const;

private:
    struct Bodies;
    std::unique_ptr<Bodies> bodies_;
};

} // namespace limen::motion
