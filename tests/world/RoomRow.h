#pragma once

#include "support/LoadTestWorld.h"

#include <vector>

namespace limen::test {

/// Rooms in a row along x, 4 × 4 × 3 m, floors at z = 2. The first three have doors between them and a door to the
/// outside in the first; others have none.
struct RoomRow {
    TestWorld source;
    std::vector<TestWorld::Cell> rooms;
    std::uint32_t sphere = 0; ///< a model: 0.2 m wide
    explicit RoomRow(int count = 3) {
        for (int i = 0; i < count; ++i)
            rooms.push_back(source.addBox({10.0 + 4 * i, 10, 2}, {14.0 + 4 * i, 14, 5}));
        for (std::size_t i = 1; i < 3; ++i) {
            const double x = 10.0 + 4.0 * static_cast<double>(i);
            source.link(rooms[i - 1], rectangle({x, 11.5, 2}, {x, 12.5, 4}), rooms[i]);
        }
        const auto door = source.openOutside(rooms[0], rectangle({10, 11.5, 2}, {10, 12.5, 4}));
        source.addBuilding(boxExterior({10, 10, 2}, {22, 14, 5}), {door});
        source.setFlatTerrain(source.home(), 1);
        sphere = source.addModel(boxExterior({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
    }
};

} // namespace limen::test
