#pragma once

#include "engine/map/LandscapeMap.h"
#include "world/Places.h"

#include <span>
#include <string>
#include <vector>

namespace limen::engine {

/// A place as the map shows it.
struct PlaceOnMap {
    std::size_t place = 0; ///< index of the world's places
    Vec2 point{0.0};       ///< global metres
    bool isDungeon =
        false; ///< in a block without buildings and without a way to the landscape: not on the map
};
[[nodiscard]] std::vector<PlaceOnMap> placesOnMap(std::span<const world::Place> places,
                                                  const LandscapeMap& map);

/// A box in pixels.
struct LabelBox {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    [[nodiscard]] bool overlaps(const LabelBox& other) const {
        return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
               other.y < y + height;
    }
};
/// The boxes, in order, that overlap no chosen box before them: indices.
[[nodiscard]] std::vector<std::size_t> labelsWithoutOverlap(std::span<const LabelBox> boxes);

/// Whether a name contains the text, without regard to upper and lower case of ASCII letters.
[[nodiscard]] bool matchesName(const std::string& name, const std::string& text);

} // namespace limen::engine
