#pragma once

#include "world/World.h"

// The last steps of a World: which spaces instances are members of, and the numbers of their polygons.
namespace limen::world {

/// The instances of one static object: a run of World::instances.
struct ObjectGroup {
    InstanceIndex firstInstance = 0, instanceCount = 0;
    Sphere bounds;    ///< global, of all its parts
    Vec3 origin{0.0}; ///< global
};

/// Fills World::members and World::billboards. Objects get every space that their bounds reach through open portals; other
/// instances get the space they are placed in. An object that reaches fewer spaces with all opaque doors shut
/// is added to World::looseObjects.
void findMembers(std::span<const ObjectGroup> objects, World& world);

/// Sets `isAlone` of idle objects and of particle sources that nothing carries: they reach no second space
/// with all doors open.
void findAlone(World& world);

/// Fills World::spaceInstances: the members of each space, its shell first. Loose objects and billboards
/// are left out: DynamicState lists them.
void listInstances(World& world);

/// Numbers the polygons of instances, then of moving parts, without gaps. Sprites get the last kMostSprites
/// ids.
void numberPolygons(World& world);

} // namespace limen::world
