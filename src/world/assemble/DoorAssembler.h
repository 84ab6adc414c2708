#pragma once

#include "world/MovingEntries.h"
#include "world/assemble/BodyAssembler.h"

namespace limen::world {

/// Adds the doors and panes of world.json to a World. Requires: all blocks are in it, and its portals are
/// final.
class DoorAssembler {
public:
    DoorAssembler(BodyAssembler& bodies, Models& models, MaterialRuns& materials, MeshArena& arena,
                  World& world)
        : bodies_(bodies), models_(models), materials_(materials), arena_(arena), world_(world) {}

    /// `index`: the entry's number in the file, which its identity is made from. Left out if its cell is not
    /// loaded, and, with a finding, if the cell has no such portal.
    void add(const DoorEntry& entry, std::size_t index);

    /// Adds a door whose leaves are in the World already, with its filling.
    void addPlaced(Door door, std::uint64_t object);

private:
    void addLeaf(const LeafEntry& leaf, const Door& door, std::uint64_t object);
    /// The parts of a pane in its shut position, block-local, with the corners of the opening.
    [[nodiscard]] MovingBody addShutBody(const Leaf& leaf, const Portal& portal);
    [[nodiscard]] std::uint32_t addFilling(const Door& door, std::uint64_t object);

    BodyAssembler& bodies_;
    Models& models_;
    MaterialRuns& materials_;
    MeshArena& arena_;
    World& world_;
};

} // namespace limen::world
