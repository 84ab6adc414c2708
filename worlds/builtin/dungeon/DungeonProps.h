#pragma once

#include "worlds/builtin/buildings/Furniture.h"

namespace limen::worlds {

/// What dungeons and the tower are furnished with. All stand on z = 0 around their origin unless said otherwise.
struct DungeonProps {
    dat::RecordId torch = 0;   ///< on a wall: origin where it is fixed, the wall to its north; with a light
    dat::RecordId brazier = 0; ///< waist-high basket of embers; with a light
    dat::RecordId stele = 0;   ///< a standing stone, 5 m tall
    dat::RecordId mast = 0;    ///< 13 m tall, with a banner to the east
    Furniture house;           ///< crates, barrels, chests
};
[[nodiscard]] DungeonProps addDungeonProps(ModelWriter& sink, const Furniture& house);

/// How far above a torch's origin its flame begins, and how far from the wall it burns, metres.
inline constexpr double kTorchFlameUp = 0.32, kTorchFlameOut = 0.25;

/// A round column on a square foot, with a square capital, `height` metres tall.
[[nodiscard]] dat::RecordId addColumn(ModelWriter& sink, double height, double radius);
/// A parapet's railing of iron along y from 0 to `length`, 0.9 m high.
[[nodiscard]] dat::RecordId addIronRailing(ModelWriter& sink, double length);

} // namespace limen::worlds
