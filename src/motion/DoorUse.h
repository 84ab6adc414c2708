#pragma once

#include "motion/DoorSwing.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limen::motion {

/// Doors that were opened and shut one by one, by their names in the world file, whatever part of the world is loaded; all others stand
/// as they rest. What it says depends on the calls alone.
class DoorUse {
public:
    /// Opens a door, or shuts it if it stands open or is opening.
    void use(const world::Door& door);
    /// One door, as far as `open`, 0..1, at once.
    void put(const world::Door& door, double open) { swings_[door.name] = {open, open > 0.0}; }
    /// Every door of a world, likewise.
    void putAll(const world::World& world, double open);
    /// They swing on, a second from shut to open.
    void pass(double seconds);
    /// The same beside a body, which gives way or holds them up (motion::swing).
    void pass(double seconds, const Collisions& around, BodyState& body, const BodyShape& shape = {});
    /// How far each door of a world stands open, for DynamicStateInput::doors.
    void write(const world::World& world, std::vector<double>& openness) const;
    /// Whether a door stands open, or is opening.
    [[nodiscard]] bool opens(const world::Door& door) const;

private:
    struct Swing {
        double open = 0.0;
        bool opens = false;
    };
    static void swingOn(Swing& swing, double seconds);
    std::map<std::string, Swing, std::less<>> swings_;
    std::vector<double> open_; ///< by World::doors, for scratch
};

/// The door that one uses whose eye is in a space and looks forward (a unit vector): of those that can swing, lie at that space and are
/// within reach the one nearest to where it looks, by its index; none: nullopt.
[[nodiscard]] std::optional<std::size_t> doorInReach(const world::World& world, world::SpaceIndex space,
                                                     const Vec3& eye, const Vec3& forward);

} // namespace limen::motion
