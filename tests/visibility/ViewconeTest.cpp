#include "visibility/Viewcone.h"
#include "visibility/TestGraph.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <utility>
#include <vector>

namespace limen::visibility {
namespace {

constexpr double kPixel = 0.002;

/// Looking north from (0,0,0) through a 2 m door 10 m away.
struct DoorView : ::testing::Test {
    DoorView() {
        TestGraph world;
        world.addSpace();
        world.addSpace();
        world.link(0, 1, uprightRectangle({0, 10, 0}, {0, -1, 0}, 2, 2));
        view = viewFrom({0, 0, 0}, 0, 0, 0);
        set = floodOnce(world.build(), view);
        cones.prepare(view, set, kPixel);
    }
    [[nodiscard]] Containment classify(std::uint32_t visit, const Sphere& sphere) const {
        const SeenSphere seen = cones.sphereOf(sphere);
        return cones.classify(visit, seen);
    }
    View view;
    VisibleSet set;
    Viewcones cones;
};

TEST_F(DoorView, ABallBehindTheEyeIsOutsideEveryVisit) {
    EXPECT_EQ(classify(0, {{0, -5, 0}, 1.0}), Containment::Outside);
    EXPECT_EQ(classify(1, {{0, -5, 0}, 1.0}), Containment::Outside);
}

TEST_F(DoorView, ABallInTheRoomClearOfTheDoorIsInside) {
    EXPECT_EQ(classify(0, {{3, 5, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(1, {{3, 5, 0}, 0.5}), Containment::Outside);
}

TEST_F(DoorView, ABallBeforeTheDoorIsInsideUnlessItReachesTheDoorsPlane) {
    EXPECT_EQ(classify(0, {{0, 5, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(0, {{0, 9.7, 0}, 0.5}), Containment::Partial);
}

TEST_F(DoorView, ABallBehindTheDoorIsInsideTheSecondVisitOnlyIfWhollyFramed) {
    EXPECT_EQ(classify(1, {{0, 20, 0}, 0.5}), Containment::Inside);
    EXPECT_EQ(classify(1, {{2, 20, 0}, 0.5}), Containment::Partial);
    EXPECT_EQ(classify(1, {{4, 20, 0}, 0.5}), Containment::Outside);
    EXPECT_EQ(classify(1, {{0, 9, 0}, 0.5}), Containment::Outside) << "it is before the entry plane";
}

TEST_F(DoorView, ABallLiesToARectangleAsToARegion) {
    const FourEdges left = cones.edgesOf({-1, -1, 0, 1});
    const auto at = [&](const Vec3& centre) {
        return Viewcones::classify(left, cones.sphereOf({centre, 0.5}));
    };
    EXPECT_EQ(at({-4, 10, 0}), Containment::Inside);
    EXPECT_EQ(at({-0.4, 10, 0}), Containment::Partial);
    EXPECT_EQ(at({0.4, 10, 0}), Containment::Partial);
    EXPECT_EQ(at({2, 10, 0}), Containment::Outside);
    EXPECT_EQ(at({-4, -10, 0}), Containment::Outside);
}

/// A sphere batch relative to `origin`.
struct OwnBatch {
    explicit OwnBatch(const Vec3& from) : origin(from) {}
    void set(std::size_t i, const Sphere& sphere) {
        spheres[i] = sphere;
        const Vec3f offset(sphere.centre - origin);
        x[i] = offset.x;
        y[i] = offset.y;
        z[i] = offset.z;
        radius[i] = static_cast<float>(sphere.radius);
    }
    [[nodiscard]] SphereBatch view() const { return {x.data(), y.data(), z.data(), radius.data()}; }
    Vec3 origin;
    std::array<Sphere, SphereBatch::kCount> spheres; ///< global
    std::array<float, SphereBatch::kCount> x{}, y{}, z{}, radius{};
};

/// A view from an eye whose coordinates are not floats, and random spheres around it. Every fourth sphere
/// touches an edge of the rectangle, or misses it narrowly.
struct SphereBatchTest : ::testing::Test {
    SphereBatchTest() {
        TestGraph world;
        world.addSpace();
        view = viewFrom(eye, 40, -10, 0);
        set = floodOnce(world.build(), view);
        cones.prepare(view, set, kPixel);
        rect = cones.edgesOf({-0.4, -0.9, 0.3, 0.2});
    }
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(random); }
    Sphere sphere() { return {{between(-1, 1), between(-1, 1), between(-1, 1)}, between(0.0, 2.0)}; }
    /// Moves the sphere so that, but for rounding, it touches one of the rectangle's edges from outside.
    Sphere atAnEdge(Sphere sphere) {
        const Vec3 edge = rect.edge(std::uniform_int_distribution<std::size_t>(0, 3)(random));
        for (int i = 0; i < 20; ++i) {
            const SeenSphere seen = cones.sphereOf(sphere);
            sphere.centre -= edge * (glm::dot(edge, sphere.centre) + seen.radius + seen.edgeTolerance);
        }
        sphere.centre += edge * between(-1e-9, 1e-9);
        return sphere;
    }
    const Vec3 eye{19200.1, 7300.7, 84.3};
    std::mt19937 random{7};
    View view;
    VisibleSet set;
    Viewcones cones;
    FourEdges rect;
};

TEST_F(SphereBatchTest, givesTheResultsOfSingleTests) {
    const Vec3 origin = glm::floor(eye) + Vec3(1800.0, -900.0, 40.0);
    std::vector<Viewcones> widths;
    for (const Vectors vectors : {Vectors::Any, Vectors::Avx2, Vectors::Avx512})
        if (vectors <= widestVectors())
            widths.emplace_back(vectors).prepare(view, set, kPixel);
    std::size_t seen = 0, within = 0, decided = 0, undecided = 0;
    for (std::uint32_t round = 0; round < 5000; ++round) {
        OwnBatch block(origin);
        for (std::size_t i = 0; i < SphereBatch::kCount; ++i) {
            Sphere one = sphere();
            one.centre *= std::pow(10.0, between(0.0, 3.3));
            if (i % 4 == 0 && round % 2 == 0)
                one = atAnEdge(one);
            block.set(i, {eye + one.centre, one.radius});
        }
        const std::uint32_t count = 1 + round % SphereBatch::kCount, first = 100 * round;
        std::vector<std::uint32_t> expected, expectedWithin;
        for (std::uint32_t i = 0; i < count; ++i) {
            const SeenSphere one = cones.sphereOf({block.spheres[i].centre - eye, block.spheres[i].radius});
            if (cones.classify(0, one) != Containment::Outside) {
                expected.push_back(first + i);
                if (Viewcones::classify(rect, one) != Containment::Outside)
                    expectedWithin.push_back(first + i);
            }
        }
        seen += expected.size();
        within += expectedWithin.size();
        for (const Viewcones& wide : widths) {
            for (const FourEdges* edges : {static_cast<const FourEdges*>(nullptr), &std::as_const(rect)}) {
                std::array<std::uint32_t, SphereBatch::kCount> found{};
                const std::uint32_t foundCount =
                    wide.listWithin(block.view(), eye - origin, edges, first, count, found.data());
                if (foundCount == Viewcones::kUndecided) {
                    ++undecided;
                    continue;
                }
                ++decided;
                ASSERT_EQ(std::vector(found.begin(), found.begin() + foundCount),
                          edges == nullptr ? expected : expectedWithin)
                    << round;
            }
        }
    }
    EXPECT_GT(within, 1000u);
    EXPECT_GT(seen, within);
    EXPECT_GT(decided, 5000u * widths.size());
    EXPECT_GT(undecided, 1000u * widths.size()) << "spheres near an edge need doubles";
}

} // namespace
} // namespace limen::visibility
