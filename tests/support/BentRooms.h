#pragma once

#include "support/TestWorld.h"

#include <algorithm>
#include <optional>

namespace limen::test {

/// Two rooms, closed, side by side in x. The wall between them is one opening, with a corner that is off the plane of the other
/// three. Block-local.
struct BentRooms {
    /// `middle`: x of the opening, metres. `off`: metres by which its corner at (y = 4, z = high) is moved in x.
    /// `origin`: of the cells' records; `low` if not given, so that their floats are of a few metres.
    BentRooms(TestWorld& source, double middle, double off, const Vec3& low = {0, 0, 0},
              const char* surfaceOfA = "grey", const char* surfaceOfB = "grey",
              const TestWorld::LinkOptions& options = {}, const std::optional<Vec3>& origin = {})
        : opening{{middle, low.y, low.z},
                  {middle, low.y + 4, low.z},
                  {middle + off, low.y + 4, low.z + 3},
                  {middle, low.y, low.z + 3}} {
        const Vec3 flat(middle, low.y + 4, low.z + 3);
        const auto room = [&](const Vec3& from, const Vec3& to, BoxWall open, const char* surface) {
            Walls walls = boxWalls(from, to, surface);
            for (Wall& wall : walls)
                std::replace(wall.points.begin(), wall.points.end(), flat, opening[2]);
            walls.erase(walls.begin() + open);
            TestWorld::CellOptions cell;
            cell.frame.origin = Vec3f(origin.value_or(low));
            return source.addCell(std::move(walls), cell);
        };
        a = room({middle - 4, low.y, low.z}, flat, kEast, surfaceOfA);
        b = room({middle, low.y, low.z}, {middle + 4, low.y + 4, low.z + 3}, kWest, surfaceOfB);
        source.link(a, opening, b, options);
    }

    std::vector<Vec3> opening;
    TestWorld::Cell a = 0, b = 0;
};

} // namespace limen::test
