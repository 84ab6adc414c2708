#pragma once

#include "support/LoadTestWorld.h"

namespace limen::test {

/// Two rooms with a door between them, a front door, and a cellar under the ground with a trapdoor; a meadow
/// around.
///
///            y
///   14 +---------+---------+
///      | front   d  rear   |      d, f: doors; the trapdoor is at (12..13, 12..13)
///   10 f---------+---------+
///      10        14        18   x
struct Hut {
    TestWorld source;
    TestWorld::Cell front = source.addBox({10, 10, 2}, {14, 14, 5}),
                    rear = source.addBox({14, 10, 2}, {18, 14, 5}),
                    cellar = source.addBox({6, 10, -1}, {14, 14, 2});
    TestWorld::Portal door;
    Hut() {
        source.link(front, rectangle({14, 11, 2}, {14, 12, 4}), rear);
        source.link(front, rectangle({12, 12, 2}, {13, 13, 2}), cellar);
        door = source.openOutside(front, rectangle({10, 11, 2}, {10, 12, 4}));
        source.addBuilding(boxExterior({10, 10, 2}, {18, 14, 5}), {door});
        source.setFlatTerrain(source.home(), 1);
    }
};

} // namespace limen::test
