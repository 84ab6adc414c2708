#pragma once

#include "world/MovingEntries.h"
#include "world/assemble/ParticleAssembler.h"

namespace limen::world {

class BodyAssembler;

/// Adds the villagers of world.json to a World, with their routes. Requires: all blocks are in it.
class VillagerAssembler {
public:
    VillagerAssembler(Records& records, BodyAssembler& bodies, ParticleAssembler& particles, World& world)
        : records_(records), bodies_(bodies), particles_(particles), world_(world) {}

    /// Left out if a point of its route is not loaded, and, with a finding, if `routes` has no such route.
    /// `index`: the entry's number in the file, which its identity is made from.
    void add(const VillagerEntry& entry, std::size_t index, std::span<const RouteEntry> routes);

private:
    /// kNone for a route with a point in a cell or block that is not loaded, or without length.
    [[nodiscard]] std::uint32_t addRoute(const RouteEntry& entry);

    Records& records_;
    BodyAssembler& bodies_;
    ParticleAssembler& particles_;
    World& world_;
};

} // namespace limen::world
