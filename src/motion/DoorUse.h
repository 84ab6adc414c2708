#pragma once

#include "motion/DoorSwing.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace limen::motion {

/// The state of doors that were opened and shut one by one. Doors are known by their names in the world file,
/// so the state survives a change of the loaded part of the world. Every other door has the world file's
/// openness. The result depends on the calls alone.
class DoorUse {
public:
    /// Opens a door, or shuts it if it is open or opening. False, with nothing changed, for a locked door that is shut.
    bool use(const world::Door& door);
    /// Sets the openness of one door, 0..1, at once.
    void put(const world::Door& door, double open);
    /// Sets the openness of every door of a world, 0..1, at once.
    void putAll(const world::World& world, double open);
    /// Swings all doors further; a full swing takes Door::seconds.
    void pass(double seconds);
    /// The same beside a body, which gives way or stops them (motion::swing).
    void pass(double seconds, const Collisions& around, BodyState& body, const BodyShape& shape = {});
    /// Writes the openness of each of a world's doors, for DynamicStateInput::doors.
    void write(const world::World& world, std::vector<double>& openness) const;
    /// Whether a door is open or opening.
    [[nodiscard]] bool opens(const world::Door& door) const;
    /// Whether a door is shut and stays so.
    [[nodiscard]] bool isShut(const world::Door& door) const;

private:
    struct Swing {
        double open = 0.0;
        bool opens = false;
        double length = 1.0; ///< seconds of a full swing
    };
    static void swingFurther(Swing& swing, double seconds);
    std::map<std::string, Swing, std::less<>> swings_; ///< by name
    std::vector<double> open_;                         ///< by World::doors; scratch
};

/// The door that a player in a space would use: an index into World::doors. Among the doors and the things that open in that
/// space that can swing and are within 2.5 m of the eye, the one nearest to the gaze; at most 60 degrees from it.
/// `forward`: unit vector.
[[nodiscard]] std::optional<std::size_t> doorInReach(const world::World& world, world::SpaceIndex space,
                                                     const Vec3& eye, const Vec3& forward);

} // namespace limen::motion
