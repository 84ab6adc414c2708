#pragma once

#include "dat/Ids.h"
#include "geometry/Bounds.h"
#include "world/Cycle.h"
#include "world/Index.h"

#include <cstdint>
#include <string>

// What can move, as a World describes it (docs/world-file.md); where it is at a moment is in world/DynamicState.h.
// Lengths in metres, angles in degrees, compass directions (0 north, 90 east).
namespace limen::world {

/// The parts of one moving thing: a run of World::movingParts, posed in the thing's own frame as they rest.
struct MovingBody {
    std::uint32_t firstPart = 0, partCount = 0;
    Sphere bounds; ///< of all parts, in the thing's own frame, as they rest and at every moment of its cycles
    /// By Gait: index into World::cycles. kNone: it has none.
    std::array<std::uint32_t, kGaits> cycles{kNone, kNone, kNone};
    std::uint32_t firstPosed = kNone; ///< run of World::posedParts, one a part; kNone: it has no cycles
    friend bool operator==(const MovingBody&, const MovingBody&) = default;
};

/// One leaf of a door, or a pane: it turns about the vertical through its hinge.
struct Leaf {
    dat::RecordId model = 0; ///< a GfxObj or Setup
    MovingBody body;
    Vec3 hinge{0.0};    ///< global
    double yaw = 0.0;   ///< when closed
    double swing = 0.0; ///< added when open
    /// Its parts where they stand while it is shut, block-local, edge to edge with the walls; none for leaves of opaque doors,
    /// which a filling stands beside.
    MovingBody shut;
    friend bool operator==(const Leaf&, const Leaf&) = default;
};

/// The filling of one opening. An opaque one shuts it while all its leaves are exactly closed.
struct Door {
    std::string name;
    PortalIndex portal = kNone;     ///< from the cell that world.json names
    PortalIndex reciprocal = kNone; ///< kNone: one-way
    bool opaque = true;
    double open = 0.0;                          ///< at rest: 0 closed .. 1 open
    std::uint32_t firstLeaf = 0, leafCount = 0; ///< run of World::leaves
    /// World::movingParts: the portal's polygon, facing both ways; shown while shut. kNone for glass.
    std::uint32_t filling = kNone;
    friend bool operator==(const Door&, const Door&) = default;
};

struct RoutePoint {
    Vec3 position{0.0}; ///< global, on the ground
    SpaceIndex space = kOutside;
    friend bool operator==(const RoutePoint&, const RoutePoint&) = default;
};

/// A way walked in straight lines.
struct Route {
    std::uint32_t firstPoint = 0, pointCount = 0; ///< run of World::routePoints; at least two
    bool loop = false;                            ///< goes on from the last to the first; else it leads back
    double length = 0.0;                          ///< once around, or there and back
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

/// The body of whoever walks through the world. Its parts are there twice: as they are, and as glass, to fade when the eye comes
/// near. None: no parts.
struct Player {
    MovingBody solid, ghost;
    friend bool operator==(const Player&, const Player&) = default;
};

/// What sends out sprites that face the eye.
struct Emitter {
    std::string name;
    Vec3 position{0.0}; ///< global, or in the frame of the villager it is attached to
    SpaceIndex space = kOutside;
    std::uint32_t villager = kNone;
    std::uint32_t sprite = kNone; ///< World::movingParts: a unit square
    double rate = 1.0;            ///< sprites a second
    double life = 1.0;            ///< seconds
    Vec3 velocity{0.0}, acceleration{0.0};
    double spread = 0.0, radius = 0.0;
    double size[2] = {0.1, 0.1};  ///< side length at birth and death
    double alpha[2] = {1.0, 1.0}; ///< opacity, likewise
    std::uint32_t seed = 0;
    double reach = 0.0; ///< no sprite comes further from the position than this
    friend bool operator==(const Emitter&, const Emitter&) = default;
};

/// A static object that moves where it stands: its parts by the cycle of standing still, or all of it by turning.
struct IdleObject {
    MovingBody body;  ///< the bounds hold all turns, too
    Vec3 origin{0.0}; ///< global
    Quat orientation{1.0, 0.0, 0.0, 0.0};
    double scale = 1.0;
    Vec3 spin{0.0}; ///< radians a second, about an axis in its own frame
    SpaceIndex space = kOutside;
    bool isAlone = false; ///< it reaches no other space, whichever doors are open
};

/// A static object whose membership depends on which doors are shut.
struct LooseObject {
    InstanceIndex firstInstance = 0, instanceCount = 0;
    Sphere bounds; ///< global, of all its instances
    friend bool operator==(const LooseObject&, const LooseObject&) = default;
};

} // namespace limen::world
