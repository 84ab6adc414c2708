#pragma once

#include "world/assemble/BodyAssembler.h"
#include "world/assemble/JoiningBlock.h"

namespace limen::world {

/// Adds the idle objects of blocks to a World: objects that move in place, by a standing cycle or a spin.
class IdleAssembler {
public:
    IdleAssembler(BodyAssembler& bodies, Cycles& cycles, World& world)
        : bodies_(bodies), cycles_(cycles), world_(world) {}

    /// Yields its index in World::idleObjects. kNone, with no instance added, for an object that does not
    /// move.
    [[nodiscard]] std::uint32_t add(const PlacedModel& object, const ObjectSite& site);

private:
    BodyAssembler& bodies_;
    Cycles& cycles_;
    World& world_;
};

} // namespace limen::world
