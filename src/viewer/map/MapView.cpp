#include "viewer/map/MapView.h"

#include <algorithm>
#include <cmath>

namespace limen::viewer {
namespace {

constexpr double kZoomPerNotch = 1.25;
constexpr double kLeastMetresPerUnit = 0.125;

double fittingMetresPerUnit(const engine::LandscapeMap& map, const ScreenBox& box) {
    const Vec2 extent = map.northEast() - map.southWest();
    return std::max(
        {extent.x / std::max(box.width, 1.0), extent.y / std::max(box.height, 1.0), kLeastMetresPerUnit});
}

Vec2 withinMap(const engine::LandscapeMap& map, const Vec2& point) {
    return glm::clamp(point, map.southWest(), map.northEast());
}

} // namespace

Vec2 MapView::pointAt(const ScreenBox& box, const Vec2& screen) const {
    const Vec2 by = screen - box.middle();
    return centre + Vec2(by.x, -by.y) * metresPerUnit;
}

Vec2 MapView::screenAt(const ScreenBox& box, const Vec2& point) const {
    const Vec2 by = (point - centre) / metresPerUnit;
    return box.middle() + Vec2(by.x, -by.y);
}

MapView wholeMap(const engine::LandscapeMap& map, const ScreenBox& box) {
    return {(map.southWest() + map.northEast()) * 0.5, fittingMetresPerUnit(map, box)};
}

MapView aroundPoint(const Vec2& point, const ScreenBox& box) {
    constexpr double kShown = 1500.0; // metres
    return {point, kShown / std::max(std::min(box.width, box.height), 1.0)};
}

MapView zoomed(const MapView& view, const engine::LandscapeMap& map, const ScreenBox& box, const Vec2& cursor,
               double notches) {
    const Vec2 kept = view.pointAt(box, cursor);
    MapView result = view;
    result.metresPerUnit = std::clamp(view.metresPerUnit * std::pow(kZoomPerNotch, -notches),
                                      kLeastMetresPerUnit, 2.0 * fittingMetresPerUnit(map, box));
    result.centre = withinMap(map, result.centre + kept - result.pointAt(box, cursor));
    return result;
}

MapView dragged(const MapView& view, const engine::LandscapeMap& map, const Vec2& by) {
    return {withinMap(map, view.centre + Vec2(-by.x, by.y) * view.metresPerUnit), view.metresPerUnit};
}

} // namespace limen::viewer
