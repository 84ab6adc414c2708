#include "engine/map/PlacesOnMap.h"

#include "engine/map/MapCoordinates.h"

#include <algorithm>

namespace limen::engine {
namespace {

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

} // namespace

std::vector<PlaceOnMap> placesOnMap(std::span<const world::Place> places, const LandscapeMap& map) {
    std::vector<PlaceOnMap> shown;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vec2 point(places[i].eye);
        const LandscapeMap::Block* block =
            map.find(places[i].cell != 0 ? dat::blockOf(places[i].cell) : blockAtPoint(point));
        const bool isDungeon = places[i].cell != 0 && (block == nullptr || block->isDungeon());
        shown.push_back({i, point, isDungeon});
    }
    return shown;
}

std::vector<std::size_t> labelsWithoutOverlap(std::span<const LabelBox> boxes) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (std::none_of(chosen.begin(), chosen.end(),
                         [&](std::size_t before) { return boxes[before].overlaps(boxes[i]); }))
            chosen.push_back(i);
    return chosen;
}

bool matchesName(const std::string& name, const std::string& text) {
    return std::search(name.begin(), name.end(), text.begin(), text.end(),
                       [](char a, char b) { return lowerCase(a) == lowerCase(b); }) != name.end();
}

} // namespace limen::engine
