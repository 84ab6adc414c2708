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
    const auto part = [](double metres, char plus, char minus) {
        const double units = std::round((metres - kMapOriginMetres) / kMapUnitMetres * 10.0) / 10.0;
        return fmt::format("{:.1f}{}", std::abs(units), units < 0.0 ? minus : plus);
    };
    return part(point.y, 'N', 'S') + " " + part(point.x, 'E', 'W');
}

std::string blockText(dat::BlockCoord block) {
    return fmt::format("{:02X}{:02X}", block.x, block.y);
}

} // namespace limen::engine
