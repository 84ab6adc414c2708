#include "worlds/generate/House.h"

namespace limen::worlds {

HouseLeaves addHouseLeaves(ModelWriter& writer, bool furnished) {
    return {addLeaf(writer, {kDoorWidth, kDoorHeight, true, furnished}),
            addLeaf(writer, {kWindowWidth, kWindowHeight, false, furnished})};
}

void noteDoors(const std::vector<HouseOpening>& openings, const HouseLeaves& leaves, dat::BlockCoord block,
               const Placement& at, dat::RecordId firstCell, Random& random, WorldNotes& notes) {
    for (const HouseOpening& opening : openings) {
        if (!random.chance(opening.door ? 0.5 : 0.4))
            continue;
        WorldNotes::Door door;
        door.cell = firstCell + opening.cell;
        door.portal = opening.portal;
        door.opaque = opening.door;
        door.open = !opening.door || random.chance(0.4) ? 0.0 : random.chance(0.5) ? 1.0 : 0.625;
        const WorldNotes::Leaf leaf{opening.door ? leaves.door : leaves.pane,
                                    blockToGlobal(block, place(at, opening.corner)),
                                    (opening.alongY ? -90.0 : 0.0) - at.turn, opening.door ? -95.0 : 0.0};
        notes.addDoor(door, {&leaf, 1});
    }
}

} // namespace limen::worlds
