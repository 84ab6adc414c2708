#pragma once

#include "world/PlacedEntry.h"
#include "world/assemble/DoorAssembler.h"
#include "world/assemble/DoorOpening.h"
#include "world/assemble/DoorParts.h"

namespace limen::world {

/// Hangs the doors of a world database in the openings that they stand before. Requires: all blocks are in the World, and
/// its portals are final.
class PlacedDoorAssembler {
public:
    PlacedDoorAssembler(Records& records, Models& models, DoorAssembler& doors, BodyAssembler& bodies,
                        World& world)
        : records_(records), models_(models), doors_(doors), bodies_(bodies), world_(world) {}

    /// Adds a door; a second one in the same opening adds its leaves to the first. An opaque door shuts its opening if its
    /// opaque surfaces cover at least nine tenths of it, and if it is at least 4 mm thick. False, with nothing added, for a
    /// door without an opening or without a mesh.
    [[nodiscard]] bool add(const PlacedEntry& entry);
    /// Adds the doors that were collected. Call it once, after the last add().
    void finish();

private:
    /// The doors of one opening.
    struct Hung {
        PortalIndex portal = kNone;
        std::vector<const PlacedEntry*> entries;
        std::vector<DoorPart> parts;
        double seconds = 0.0;
    };
    [[nodiscard]] DoorBox boxOf(const PlacedEntry& entry, const std::vector<DoorPart>& parts);
    /// Calls visit(point) with each vertex of the shut door, global.
    template <class Visit>
    void eachVertex(const DoorPart& part, Visit&& visit);
    [[nodiscard]] bool isOpaque(const Hung& hung);
    void addDoor(const Hung& hung);

    Records& records_;
    Models& models_;
    DoorAssembler& doors_;
    BodyAssembler& bodies_;
    World& world_;
    std::vector<Hung> hung_;
};

} // namespace limen::world
