#pragma once

#include "world/PlacedEntry.h"
#include "world/assemble/BodyAssembler.h"
#include "world/records/DoorMotion.h"

namespace limen::world {

/// One part of a door of a world database, in its poses from shut to open.
struct DoorPart {
    dat::RecordId gfxObj = 0;
    Vec3 scale{1.0};
    Dress dress;               ///< of its mesh, as part 0
    std::vector<LeafKey> keys; ///< global
};

/// The parts with a mesh, at their nearest level of detail. `origin`: the door's position, global.
[[nodiscard]] std::vector<DoorPart> doorPartsOf(const PlacedEntry& entry, const Vec3& origin,
                                                const DoorMotion& motion, const Dress& dress, Models& models);

/// The motion of a door: that of its Setup, or none.
[[nodiscard]] DoorMotion motionOf(const PlacedEntry& entry, Records& records);

/// Adds the parts to a World as the leaves of `door`, whose run they become.
void addLeaves(std::span<const DoorPart> parts, InstanceKind kind, std::uint64_t object,
               BodyAssembler& bodies, World& world, Door& door);

} // namespace limen::world
