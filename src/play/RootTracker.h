#pragma once

#include "world/World.h"

namespace limen::play {

/// Tracks the space of a flying eye by sweeping it through portals. An eye that flies through a wall is lost;
/// after a short grace time its position decides the space.
class RootTracker {
public:
    static constexpr double kGraceSeconds = 0.25; ///< time an eye may be lost

    explicit RootTracker(world::SpaceIndex root) : root_(root) {}
    /// Moves the eye in a straight line. Returns the space of its new position.
    world::SpaceIndex move(const world::World& world, const Vec3& from, const Vec3& to, double seconds);
    /// Sets the space of the eye.
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
