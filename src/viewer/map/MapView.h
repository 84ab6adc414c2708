#pragma once

#include "engine/map/LandscapeMap.h"

namespace limen::viewer {

/// A box on the screen, in units of the window: x to the right, y downwards.
struct ScreenBox {
    double x = 0.0, y = 0.0, width = 1.0, height = 1.0;
    [[nodiscard]] Vec2 middle() const { return {x + width / 2, y + height / 2}; }
};

/// The part of the map in a box of the screen. North is up.
struct MapView {
    Vec2 centre{0.0};           ///< global metres, in the middle of the box
    double metresPerUnit = 1.0; ///< of the screen

    [[nodiscard]] Vec2 pointAt(const ScreenBox& box, const Vec2& screen) const;
    [[nodiscard]] Vec2 screenAt(const ScreenBox& box, const Vec2& point) const;
};

/// The whole map.
[[nodiscard]] MapView wholeMap(const engine::LandscapeMap& map, const ScreenBox& box);
/// A view of about 1.5 km around a point: large enough to recognise a town and its roads.
[[nodiscard]] MapView aroundPoint(const Vec2& point, const ScreenBox& box);
/// Zooms in by `notches` of the wheel (below 0: out). The point under the cursor stays there. The view never
/// shows more than twice the map, and never less than 1/8 m a unit.
[[nodiscard]] MapView zoomed(const MapView& view, const engine::LandscapeMap& map, const ScreenBox& box,
                             const Vec2& cursor, double notches);
/// Moves the map with the cursor. The middle of the box stays on the map.
[[nodiscard]] MapView dragged(const MapView& view, const engine::LandscapeMap& map, const Vec2& by);

} // namespace limen::viewer
