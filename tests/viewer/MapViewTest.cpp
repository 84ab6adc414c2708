#include "viewer/map/MapView.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

const ScreenBox kBox{100, 50, 600, 400};

engine::LandscapeMap someMap() {
    engine::LandscapeMap map;
    map.left = 10;
    map.bottom = 20;
    map.columns = map.rows = 50;
    return map;
}

void expectAt(const Vec2& a, const Vec2& b) {
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
}

TEST(MapView, northIsUpAndEastIsRight) {
    const MapView view{{5000, 7000}, 2.0};
    expectAt(view.screenAt(kBox, {5000, 7000}), kBox.middle());
    expectAt(view.screenAt(kBox, {5200, 7000}), kBox.middle() + Vec2(100, 0));
    expectAt(view.screenAt(kBox, {5000, 7200}), kBox.middle() - Vec2(0, 100));
    expectAt(view.pointAt(kBox, view.screenAt(kBox, {4321, 8765})), {4321, 8765});
}

TEST(MapView, theWholeMapFits) {
    const engine::LandscapeMap map = someMap();
    const MapView view = wholeMap(map, kBox);
    const Vec2 corner = view.screenAt(kBox, map.northEast());
    EXPECT_NEAR(corner.y, kBox.y, 1e-6) << "the height is the tighter side";
    EXPECT_LT(corner.x, kBox.x + kBox.width);
}

TEST(MapView, thePointUnderTheCursorStaysWhenZooming) {
    const engine::LandscapeMap map = someMap();
    const MapView view = wholeMap(map, kBox);
    const Vec2 cursor(450, 300);
    const MapView nearer = zoomed(view, map, kBox, cursor, 3.0);
    EXPECT_LT(nearer.metresPerUnit, view.metresPerUnit / 1.9);
    expectAt(nearer.pointAt(kBox, cursor), view.pointAt(kBox, cursor));
    EXPECT_EQ(zoomed(view, map, kBox, cursor, -100).metresPerUnit, 2.0 * view.metresPerUnit);
    EXPECT_EQ(zoomed(view, map, kBox, cursor, 500).metresPerUnit, 0.125);
}

TEST(MapView, theMapMovesWithTheCursorAndStaysInView) {
    const engine::LandscapeMap map = someMap();
    const MapView view{{6000, 8000}, 4.0};
    expectAt(dragged(view, map, {10, 5}).screenAt(kBox, {6000, 8000}), kBox.middle() + Vec2(10, 5));
    expectAt(dragged(view, map, {1e7, 0}).centre, {map.southWest().x, 8000});
}

} // namespace
} // namespace limen::viewer
