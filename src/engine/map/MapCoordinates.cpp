#include "engine/map/MapCoordinates.h"

#include "world/World.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace limen::engine {

dat::BlockCoord blockAtPoint(const Vec2& point) {
    const auto index = [](double metres) {
        return static_cast<int>(
            std::clamp(std::floor(metres / world::kBlockSize), 0.0, world::kMapSize - 1.0));
    };
    return {index(point.x), index(point.y)};
}

std::string mapText(const Vec2& point) {
    const double east = (point.x - kMapOriginMetres) / kMapUnitMetres;
    const double north = (point.y - kMapOriginMetres) / kMapUnitMetres;
    return fmt::format("{:.1f}{} {:.1f}{}", std::abs(north), north < 0.0 ? 'S' : 'N', std::abs(east),
                       east < 0.0 ? 'W' : 'E');
}

std::string blockText(dat::BlockCoord block) {
    return fmt::format("{:02X}{:02X}", block.x, block.y);
}

} // namespace limen::engine
