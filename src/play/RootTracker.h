#pragma once

#include "world/World.h"

namespace limen::play {

/// Follows a free eye from space to space: swept through the portals it passes. An eye that flies through a
/// wall is lost; after a short grace it is found again by its position.
class RootTracker {
public:
    static constexpr double kGraceSeconds = 0.25;

    explicit RootTracker(world::SpaceIndex root) : root_(root) {}
    /// Moves the eye in a straight line; yields the space it is in.
    world::SpaceIndex move(const world::World& world, const Vec3& from, const Vec3& to, double seconds);
    /// Puts the eye into a space.
    void place(world::SpaceIndex root) {
        root_ = root;
        lostSeconds_ = 0.0;
    }
    [[nodiscard]] world::SpaceIndex root() const { return root_; }

private:
    [[nodiscard]] bool isLost(const world::World& world, const Vec3& eye) const;
    world::SpaceIndex root_;
    double lostSeconds_ = 0.0;
};

} // namespace limen::play
