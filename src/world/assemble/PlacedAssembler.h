#pragma once

#include "world/PlacedEntry.h"
#include "world/assemble/ObjectAssembler.h"
#include "world/assemble/PlacedDoorAssembler.h"
#include "world/assemble/UsableAssembler.h"

namespace limen::world {

/// Adds the objects of a world database to a World: things with the block that they belong to, doors after all blocks.
class PlacedAssembler {
public:
    PlacedAssembler(std::span<const PlacedEntry> entries, Records& records, ObjectAssembler& objects,
                    UsableAssembler& usables, World& world);

    /// Adds the things of a block, and keeps its doors for addDoors(). An object in a cell that the block lacks is left out,
    /// with a finding.
    void add(const JoiningBlock& block);
    /// Hangs the doors of all blocks. Those without an opening are left standing where they are.
    void addDoors(PlacedDoorAssembler& doors);

private:
    /// A door, and the way to add it as a thing.
    struct WaitingDoor {
        const PlacedEntry* entry = nullptr;
        ObjectSite site;
        std::uint32_t placed = kNone; ///< index into World::placed
    };
    /// The index of a cell in its block, or kOutdoorSpace; none if the block lacks the cell.
    [[nodiscard]] static std::optional<std::uint32_t> localCell(const PlacedEntry& entry,
                                                                const BlockContent& block);
    void addThing(const PlacedEntry& entry, const ObjectSite& site);
    /// The entry's position in the frame of a block.
    [[nodiscard]] Vec3 localPosition(const PlacedEntry& entry, const Vec3& blockOrigin) const;
    /// Yields its index in World::placed.
    std::uint32_t note(const PlacedEntry& entry, const ObjectSite& site);

    std::vector<const PlacedEntry*> entries_; ///< by block
    Records& records_;
    ObjectAssembler& objects_;
    UsableAssembler& usables_;
    World& world_;
    std::vector<WaitingDoor> waiting_;
};

} // namespace limen::world
