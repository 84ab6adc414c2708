#include "viewer/inspect/FrozenFlood.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

/// An eye at the origin that looks north, 90 degrees wide and high: the root, and an opening in the plane y =
/// 4 through which it sees a visit of a quarter of the picture.
FrozenFlood someFlood() {
    FrozenFlood flood;
    flood.visible.regionVertices = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1},
                                    {0, 0, 1},   {2, 0, 2},  {1, 1, 1}, {0, 1, 1}};
    flood.visible.visits.resize(2);
    flood.visible.visits[0].vertexCount = 4;
    flood.visible.visits[1].firstVertex = flood.visible.visits[1].vertexCount = 4;
    flood.visible.visits[1].entryPlane = {Vec3(0, 1, 0), -4.0};
    return flood;
}

/// An eye in the west that looks east, level.
visibility::View fromTheWest() {
    visibility::View eye;
    eye.eye = {-10, 4, 0};
    eye.right = {0, -1, 0};
    eye.forward = {1, 0, 0};
    return eye;
}

bool has(const std::vector<PyramidLine>& lines, std::uint32_t visit, const Vec2& a, const Vec2& b) {
    const auto near = [](const Vec2& p, const Vec2& q) { return glm::length(p - q) < 1e-9; };
    for (const PyramidLine& line : lines)
        if (line.visit == visit &&
            ((near(line.from, a) && near(line.to, b)) || (near(line.from, b) && near(line.to, a))))
            return true;
    return false;
}

TEST(FrozenFlood, aVisitBeginsWhereItsRaysComeIn) {
    const std::vector<PyramidLine> lines = pyramidLines(someFlood(), fromTheWest(), 1e-6);
    // Corners in the opening: (0, 4, 0), (4, 4, 0), (4, 4, 4), (0, 4, 4); seen from 10 and 14 metres away.
    EXPECT_TRUE(has(lines, 1, {0, 0}, {0, 0}) || has(lines, 1, {0, 0}, {0, 4.0 / 14}))
        << "the lower edge projects to a point";
    EXPECT_TRUE(has(lines, 1, {0, 4.0 / 14}, {0, 4.0 / 10}));
    EXPECT_TRUE(has(lines, 1, {0, 0}, {0, 4.0 / 10}));
}

TEST(FrozenFlood, itsEdgesGoOnAlongTheRays) {
    const std::vector<PyramidLine> lines = pyramidLines(someFlood(), fromTheWest(), 6.0);
    EXPECT_TRUE(has(lines, 1, {0, 0}, {-0.6, 0})) << "the ray straight ahead: from (0, 4, 0) to (0, 10, 0)";
    // The root's rays enter at the eye.
    const double along = 6.0 / std::sqrt(3.0);
    EXPECT_TRUE(has(lines, 0, {0.4, 0}, Vec2(4.0 - along, along) / (10.0 - along)));
}

TEST(FrozenFlood, whatIsBehindTheOtherEyeIsCutOff) {
    visibility::View eye = fromTheWest();
    eye.eye.x = 2.0; // between the left and the right edge of the opening
    for (const PyramidLine& line : pyramidLines(someFlood(), eye, 6.0)) {
        EXPECT_TRUE(std::isfinite(line.from.x) && std::isfinite(line.to.y));
        EXPECT_LT(glm::length(line.from), 1e4);
    }
    eye.forward = {-1, 0, 0};
    eye.right = {0, 1, 0};
    eye.eye.x = -10.0; // looks away from the flood
    EXPECT_TRUE(pyramidLines(someFlood(), eye, 6.0).empty());
}

} // namespace
} // namespace limen::viewer
