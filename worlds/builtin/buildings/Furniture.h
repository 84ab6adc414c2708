#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Models of furniture. They stand on z = 0 around their origin with their front to the south, unless the
/// comment says otherwise.
struct Furniture {
    dat::RecordId table = 0, chair = 0, stool = 0, bench = 0, bed = 0, chest = 0;
    dat::RecordId shelf = 0;     ///< back to the north
    dat::RecordId fireplace = 0; ///< back to the north, chimney breast up to 2.5 m; with a light
    dat::RecordId rug = 0, barrel = 0, crate = 0, sacks = 0;
    dat::RecordId candle = 0;  ///< with a light
    dat::RecordId lantern = 0; ///< hangs: origin at its hook; with a light
    dat::RecordId jug = 0, bowl = 0;
};
[[nodiscard]] Furniture addFurniture(ModelWriter& writer);

/// Joists under a ceiling: `across` metres long in x, spread over `along` metres in y, top at z = 0, middle
/// at the origin.
[[nodiscard]] dat::RecordId addJoists(ModelWriter& writer, double across, double along, double spacing);

/// Wooden stairs down to the north from (0,0,0): `count` steps, each `rise` down and `tread` forward, `width`
/// wide in x. The last riser ends on the lower floor.
struct StairSpec {
    int risers = 13;
    double rise = 0.2, tread = 0.22, width = 1.2;
};
[[nodiscard]] dat::RecordId addStairs(ModelWriter& writer, const StairSpec& stairs);

/// A railing along y from 0 to `length`, 0.95 m high.
[[nodiscard]] dat::RecordId addRailing(ModelWriter& writer, double length);

} // namespace limen::worlds
