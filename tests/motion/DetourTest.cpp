#include "motion/Detour.h"

#include "motion/Hut.h"
#include "motion/Walker.h"

namespace limen::motion {
namespace {

using test::boxExterior;
using test::frameAt;
using test::Hut;
using test::kYawEast;
using test::TestWorld;
using test::Walker;
using world::kOutside;

constexpr double kFine = 0.25; // metres, side of a square

/// Walks straight to each corner.
void follow(Walker& walker, const Detour& detour) {
    for (const Vec3& corner : detour.corners) {
        for (int i = 0; i < 200; ++i) {
            const Vec3 way = corner - walker.body.standing.feet;
            if (std::hypot(way.x, way.y) < 0.08)
                break;
            walker.go(glm::degrees(std::atan2(way.x, way.y)), 0.03);
        }
    }
}

double levelFrom(const Walker& walker, double x, double y) {
    return std::hypot(walker.feet().x - x, walker.feet().y - y);
}

TEST(Detour, leadsAroundACounterThatStopsTheStraightWay) {
    Hut hut;
    const std::uint32_t counter = hut.source.addModel(boxExterior({-0.2, -2.5, 0}, {0.2, 2.5, 1.2}));
    hut.source.addObject(counter, frameAt({43, 40, 2}));
    Walker walker(hut.source);
    walker.put({41, 40, 2.01}, kOutside);
    walker.stand(0.3);
    walker.go(kYawEast, 2.0);
    ASSERT_GT(levelFrom(walker, 45, 40), 2.0) << "the straight way ends at the counter";
    const Detour detour =
        wayAround(walker.body, walker.at(45, 40, 2), kFine, walker.collisions(), walker.doors);
    ASSERT_TRUE(detour.reaches);
    follow(walker, detour);
    EXPECT_LT(levelFrom(walker, 45, 40), 0.15);
}

TEST(Detour, findsTheDoorOfARoom) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({11, 13.5, 2.01}, walker.space(hut.front));
    walker.stand(0.3);
    const Detour detour =
        wayAround(walker.body, walker.at(16, 13, 2), kFine, walker.collisions(), walker.doors);
    ASSERT_TRUE(detour.reaches);
    follow(walker, detour);
    EXPECT_LT(levelFrom(walker, 16, 13), 0.15);
    EXPECT_EQ(walker.body.standing.space, walker.space(hut.rear));
}

TEST(Detour, endsAtTheNearestPointOfAClosedRoom) {
    TestWorld source;
    const TestWorld::Cell room = source.addBox({10, 10, 2}, {14, 14, 5});
    source.setFlatTerrain(source.home(), 1);
    Walker walker(source);
    walker.put({11, 12, 2.01}, walker.space(room));
    walker.stand(0.3);
    const Detour detour =
        wayAround(walker.body, walker.at(16, 12, 2), kFine, walker.collisions(), walker.doors);
    EXPECT_FALSE(detour.reaches);
    ASSERT_FALSE(detour.corners.empty());
    EXPECT_NEAR(detour.corners.back().x - walker.at(0, 0, 0).x, 13.7, kFine);
}

TEST(Detour, isEmptyBeyondEightMetres) {
    Hut hut;
    Walker walker(hut.source);
    walker.put({40, 40, 2.01}, kOutside);
    walker.stand(0.3);
    EXPECT_TRUE(wayAround(walker.body, walker.at(49, 40, 2), kFine, walker.collisions(), walker.doors)
                    .corners.empty());
    EXPECT_TRUE(
        wayAround(walker.body, walker.at(47, 40, 2), kFine, walker.collisions(), walker.doors).reaches);
}

} // namespace
} // namespace limen::motion
