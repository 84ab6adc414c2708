#pragma once

#include "worlds/records/CellPlan.h"
#include "worlds/shapes/Panel.h"

namespace limen::worlds {

/// An opening in one side of a box-shaped room.
struct Opening {
    Side side = Side::South;
    Rect rect;
};

/// A box-shaped room and the materials of its sides.
struct RoomSpec {
    std::string name{};
    Vec3 min{0.0}, max{0.0};
    Material floor = Material::Planks, walls = Material::InnerPlaster, ceiling = Material::Planks;
};

/// The closed shell of a room: its sides without the openings, and a portal face for each opening, in their
/// order.
[[nodiscard]] CellPlan roomWithOpenings(const RoomSpec& room, const std::vector<Opening>& openings);

} // namespace limen::worlds
