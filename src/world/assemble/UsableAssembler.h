#pragma once

#include "world/assemble/DoorParts.h"
#include "world/assemble/JoiningBlock.h"

namespace limen::world {

/// Adds the things of a world database that open when they are used, such as chests and levers, as doors without an opening.
class UsableAssembler {
public:
    UsableAssembler(Records& records, Models& models, BodyAssembler& bodies, World& world)
        : records_(records), models_(models), bodies_(bodies), world_(world) {}

    /// `origin`: the thing's position, global. False, with nothing added, for a thing that its motion table does not show both
    /// shut and open, for one that moves all the time, and for a faded one.
    [[nodiscard]] bool add(const PlacedEntry& entry, const Vec3& origin, const Dress& dress,
                           const ObjectSite& site);

private:
    Records& records_;
    Models& models_;
    BodyAssembler& bodies_;
    World& world_;
};

} // namespace limen::world
