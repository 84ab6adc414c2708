#pragma once

#include "dat/Ids.h"
#include "geometry/Bounds.h"
#include "world/Cycle.h"
#include "world/Index.h"
#include "world/PlacedEntry.h"

#include <cstdint>
#include <string>

// The dynamic objects of a World (docs/world-file.md). Their positions at one time are in
// world/DynamicState.h. Lengths in metres, angles in degrees, compass directions (0 north, 90 east).
namespace limen::world {

/// The parts of one dynamic object: a run of World::movingParts in their resting poses, in the object's own
/// frame.
struct MovingBody {
    std::uint32_t firstPart = 0, partCount = 0;
    Sphere
        bounds; ///< in the object's own frame; of all parts in the resting pose and in every pose of its cycles
    /// By Gait: index into World::cycles; kNone: no cycle.
    std::array<std::uint32_t, kGaits> cycles{kNone, kNone, kNone};
    std::uint32_t firstPosed = kNone; ///< run of World::posedParts, one a part; kNone: it has no cycles
    friend bool operator==(const MovingBody&, const MovingBody&) = default;
};

/// A pose of a door leaf: global space from the leaf's own, without its scale.
struct LeafKey {
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    Vec3 origin{0.0};
    friend bool operator==(const LeafKey&, const LeafKey&) = default;
};

/// One leaf of a door, or a pane. It rotates about the vertical axis through its hinge, or follows keys
/// (LeafPose.h).
struct Leaf {
    dat::RecordId model = 0; ///< a GfxObj or Setup
    MovingBody body;
    Vec3 hinge{0.0};    ///< global
    double yaw = 0.0;   ///< when closed
    double swing = 0.0; ///< added to `yaw` when fully open
    /// Its parts in the shut position, block-local, with the corners of the walls around. None for leaves of
    /// opaque doors, whose openings have a filling.
    MovingBody shut;
    /// Run of World::leafKeys, from shut to open at equal intervals; none: it rotates about its hinge. Then `body.bounds`
    /// is scaled, and `yaw` and `swing` are not used.
    std::uint32_t firstKey = kNone, keyCount = 0;
    Vec3 scale{1.0}; ///< of its mesh; 1 without keys
    friend bool operator==(const Leaf&, const Leaf&) = default;
};

/// A door or pane in one opening. An opaque one shuts the opening while all its leaves are exactly closed. One without an
/// opening is a thing that opens, such as a chest or a lever: it shuts nothing and stops no body.
struct Door {
    std::string name;
    PortalIndex portal = kNone;     ///< from the cell that world.json names; kNone: it has no opening
    PortalIndex reciprocal = kNone; ///< kNone: one-way
    SpaceIndex space = kOutside;    ///< the place of one without an opening
    bool opaque = true;
    bool locked = false;                        ///< while it is shut, nobody opens it by hand
    double open = 0.0;                          ///< initially: 0 closed .. 1 open
    double seconds = 1.0;                       ///< from closed to open
    std::uint32_t firstLeaf = 0, leafCount = 0; ///< run of World::leaves
    /// World::movingParts: the portal's polygon, facing both ways, drawn while the door is shut. kNone for
    /// glass.
    std::uint32_t filling = kNone;
    friend bool operator==(const Door&, const Door&) = default;
};

struct RoutePoint {
    Vec3 position{0.0}; ///< global, on the ground
    SpaceIndex space = kOutside;
    friend bool operator==(const RoutePoint&, const RoutePoint&) = default;
};

/// A path of straight lines.
struct Route {
    std::uint32_t firstPoint = 0, pointCount = 0; ///< run of World::routePoints; at least two
    bool loop = false;   ///< true: the last point joins the first; false: there and back
    double length = 0.0; ///< of one round, or of the way there and back
    friend bool operator==(const Route&, const Route&) = default;
};

struct Villager {
    std::string name;
    MovingBody body;
    std::uint32_t route = kNone;
    double speed = 1.0; ///< metres a second
    double start = 0.0; ///< metres along the route at time 0
    friend bool operator==(const Villager&, const Villager&) = default;
};

/// The player's body: once as it is, and once with blended surfaces, to fade it when the eye comes near. No
/// parts: the player is not drawn.
struct Player {
    MovingBody solid, ghost;
    friend bool operator==(const Player&, const Player&) = default;
};

/// A source of sprites that face the eye.
struct Emitter {
    std::string name;
    Vec3 position{0.0}; ///< global, or in the frame of the villager it is attached to
    SpaceIndex space = kOutside;
    std::uint32_t villager = kNone;
    std::uint32_t sprite = kNone; ///< World::movingParts: a unit square
    double rate = 1.0;            ///< sprites a second
    double life = 1.0;            ///< seconds
    Vec3 velocity{0.0}, acceleration{0.0};
    double spread = 0.0;          ///< greatest random addition to each component of `velocity`
    double radius = 0.0;          ///< of the sphere in which sprites are born
    double size[2] = {0.1, 0.1};  ///< side length at birth and at death
    double alpha[2] = {1.0, 1.0}; ///< opacity at birth and at death
    std::uint32_t seed = 0;
    double reach = 0.0; ///< greatest distance of a sprite's points from the position
    friend bool operator==(const Emitter&, const Emitter&) = default;
};

/// An object of the records that moves in place: its parts by a standing cycle, or the whole object by
/// rotating.
struct IdleObject {
    MovingBody body;  ///< its bounds contain every rotation, too
    Vec3 origin{0.0}; ///< global
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    Vec3 spin{0.0}; ///< radians a second, about an axis in its own frame
    SpaceIndex space = kOutside;
    bool isAlone = false; ///< it reaches no other space, even with all doors open
    double opacity = 1.0; ///< multiplies that of its blended surfaces
};

/// An object of a world database that is in the world: drawn by its instances, its idle object or its door.
struct PlacedObject {
    std::uint64_t object = 0; ///< the identity of its instances
    std::uint32_t templateId = 0;
    std::string name;
    dat::RecordId model = 0;
    Vec3 origin{0.0}; ///< global
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    SpaceIndex space = kOutside;
    bool stopsBodies = true;
    bool isHung = false;               ///< a door in its opening; its leaves stop bodies
    std::optional<TravelEntry> travel; ///< of a travel portal
    friend bool operator==(const PlacedObject&, const PlacedObject&) = default;
};

/// A static object whose membership depends on the state of doors.
struct LooseObject {
    InstanceIndex firstInstance = 0, instanceCount = 0;
    Sphere bounds;    ///< global, of all its instances
    Vec3 origin{0.0}; ///< global, of the object
    friend bool operator==(const LooseObject&, const LooseObject&) = default;
};

/// A static instance that turns to the eye. No space lists it: DynamicState has it turned for one eye. Those of
/// loose objects are not listed here.
struct Billboard {
    InstanceIndex instance = kNone;
    Vec3 object{0.0}; ///< global: the origin of its object
    friend bool operator==(const Billboard&, const Billboard&) = default;
};

} // namespace limen::world
