#include "world/mesh/Weld.h"

#include "geometry/TwoFloats.h"

#include <gtest/gtest.h>

#include <random>

namespace limen::world {
namespace {

TEST(CanonicalPosition, isTheSumOfTwoFloatsAndExactAboutAnyBlocksOrigin) {
    std::mt19937 random(2);
    for (const double reach : {0.01, 1.0, 200.0, 30000.0, 500000.0}) {
        std::uniform_real_distribution<double> place(-reach, reach);
        for (int i = 0; i < 1000; ++i) {
            const Vec3 given(place(random), place(random), place(random)), p = canonicalPosition(given);
            EXPECT_LT(glm::length(p - given), reach > 32000.0 ? 1e-7 : 1e-10);
            EXPECT_EQ(inTwoFloats(p).sum(), p);
            EXPECT_EQ(canonicalPosition(p), p);
            const Vec3 origin(254.0 * 192.0, 192.0, 0.0);
            EXPECT_EQ((origin + p) - origin, p);
        }
    }
}

TEST(Welder, givesNearPositionsTheFirstOnesBits) {
    Welder welder;
    const Vec3 corner(191.123456789, -40.25, 7.0000001);
    const auto a = welder.add(corner), b = welder.add(corner + Vec3(0.0001, -0.0001, 0.00005)),
               c = welder.add(corner + 0.01);
    welder.weld();
    EXPECT_EQ(welder.vertexOf(a), welder.vertexOf(b));
    EXPECT_NE(welder.vertexOf(a), welder.vertexOf(c));
    EXPECT_EQ(welder.positions()[welder.vertexOf(a)], canonicalPosition(corner));
    EXPECT_EQ(welder.positions().size(), 2u);
}

TEST(Welder, weldsAcrossTheBordersOfItsGrid) {
    // Pairs across every kind of grid line: multiples of 0.004 m and the axes.
    for (const double at : {0.0, 0.004, -0.004, 12.0, -96.0, 0.00001}) {
        Welder welder;
        const auto a = welder.add({at - 0.00009, at - 0.00005, at}),
                   b = welder.add({at + 0.00009, at + 0.00005, at});
        welder.weld();
        EXPECT_EQ(welder.vertexOf(a), welder.vertexOf(b)) << at;
    }
}

TEST(Welder, weldsAllThatIsWithinTheToleranceAndNothingFarther) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0.0, 0.004);
    std::vector<Vec3> points;
    Welder welder;
    for (int i = 0; i < 200; ++i) {
        points.emplace_back(place(random), place(random), place(random));
        welder.add(points.back());
    }
    welder.weld();
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        for (std::uint32_t j = 0; j < i; ++j)
            EXPECT_TRUE(glm::length(points[i] - points[j]) > kWeldTolerance ||
                        welder.vertexOf(i) == welder.vertexOf(j))
                << i << " and " << j;
    }
    EXPECT_GT(welder.positions().size(), 10u);
}

TEST(Welder, copesWithNoPositionsAndWithManyInOnePlace) {
    Welder none;
    none.weld();
    EXPECT_TRUE(none.positions().empty());
    Welder many;
    for (int i = 0; i < 60000; ++i)
        many.add(Vec3(1e-9 * i, 0.0, 0.0));
    many.weld();
    EXPECT_EQ(many.positions().size(), 1u);
}

} // namespace
} // namespace limen::world
