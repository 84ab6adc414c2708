#pragma once

#include "worlds/builtin/buildings/Furniture.h"

namespace limen::worlds {

/// Models for dungeons and the tower. They stand on z = 0 around their origin, unless the comment says
/// otherwise.
struct DungeonProps {
    dat::RecordId torch = 0;   ///< on a wall to its north, where its origin is; with a light
    dat::RecordId brazier = 0; ///< waist-high basket of embers; with a light
    dat::RecordId stele = 0;   ///< a standing stone, 5 m tall
    dat::RecordId mast = 0;    ///< 13 m tall, with a banner to the east
    Furniture house;           ///< crates, barrels, chests
};
[[nodiscard]] DungeonProps addDungeonProps(ModelWriter& writer, const Furniture& house);

/// The flame of a torch: metres above its origin, and metres from the wall.
inline constexpr double kTorchFlameUp = 0.32, kTorchFlameOut = 0.25;

/// A round column on a square foot, with a square capital, `height` metres tall.
[[nodiscard]] dat::RecordId addColumn(ModelWriter& writer, double height, double radius);
/// An iron railing along y from 0 to `length`, 0.9 m high.
[[nodiscard]] dat::RecordId addIronRailing(ModelWriter& writer, double length);

} // namespace limen::worlds
