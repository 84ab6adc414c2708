#pragma once

#include "worlds/generate/Props.h"
#include "worlds/generate/WorldNotes.h"
#include "worlds/records/CellPlan.h"

namespace limen::worlds {

/// A house of one to four rooms. In its coordinates the floor is z = 0; the front wall's outer face is y = 0
/// and looks south.
struct HouseSpec {
    double halfWidth = 4.5, depth = 8.0, height = 2.75; ///< outer size of the ground floor, metres
    double foot = -1.0;                                 ///< the walls' lower end, below the ground
    bool divided = true; ///< a back room, its window in line with the front door
    bool cellar = false; ///< below the rearmost room, through a hatch
    bool attic = false;  ///< a second storey, through a hatch
};

/// A random house whose walls extend down to `foot`.
[[nodiscard]] HouseSpec randomHouse(Random& random, double foot);

/// An opening for a door or a pane.
struct HouseOpening {
    std::uint32_t cell = 0;
    std::uint16_t portal = 0;
    Vec3 corner{0.0};    ///< its lower corner, from which the leaf extends
    bool alongY = false; ///< the leaf extends along +y, else +x
    bool door = false;   ///< kDoorWidth × kDoorHeight; else a window
};
inline constexpr double kDoorWidth = 1.125, kDoorHeight = 2.0, kWindowWidth = 1.0, kWindowHeight = 1.125;

struct House {
    BuildingPlan plan;
    std::vector<HouseOpening> openings;
};
[[nodiscard]] House planHouse(const HouseSpec& spec, const Props& props, Random& random);

/// Models of doors and panes.
struct HouseLeaves {
    dat::RecordId door = 0, pane = 0;
};
[[nodiscard]] HouseLeaves addHouseLeaves(ModelWriter& writer, bool furnished);

/// Adds doors to a random share of a house's openings.
void noteDoors(const std::vector<HouseOpening>& openings, const HouseLeaves& leaves, dat::BlockCoord block,
               const Placement& at, dat::RecordId firstCell, Random& random, WorldNotes& notes);

} // namespace limen::worlds
