#include "frame/PlanSky.h"

#include <gtest/gtest.h>
#include <numbers>
#include <rapidcheck/gtest.h>

namespace limen::frame {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// An eye that looks `pitch` degrees up.
struct Looking {
    Looking(double yaw, double pitch, double tanHalfX, double tanHalfY) : tanX(tanHalfX), tanY(tanHalfY) {
        const double y = yaw * kDegree, p = pitch * kDegree;
        forward = {std::sin(y) * std::cos(p), std::cos(y) * std::cos(p), std::sin(p)};
        right = {std::cos(y), -std::sin(y), 0.0};
        up = glm::cross(right, forward);
        const Vec3 x = right / tanX, v = up / tanY, w = forward;
        plan.constants.clipFromEye =
            glm::mat4(glm::dmat4(x.x, v.x, 0, w.x, x.y, v.y, 0, w.y, x.z, v.z, 0, w.z, 0, 0, 0.02, 0));
    }
    [[nodiscard]] double sineAt(double x, double y) const {
        return glm::normalize(forward + right * (x * tanX) + up * (y * tanY)).z;
    }
    Vec3 forward, right, up;
    double tanX, tanY;
    FramePlan plan;
};

TEST(PlainSky, isTheWholeWindowIfObjectsCoverNothingBelowTheHorizon) {
    Looking looking(10.0, 0.0, 1.0, 0.6);
    for (const double sine : {0.0, 0.5, 2.0})
        EXPECT_EQ(plainSkyBelow(sine, looking.plan), RectRun());
    EXPECT_TRUE(looking.plan.rects.empty());
}

TEST(PlainSky, isTheLowerEdgeOfALevelPicture) {
    Looking looking(10.0, 0.0, 1.0, 0.6);
    const RectRun run = plainSkyBelow(std::sin(-22.5 * kDegree), looking.plan);
    ASSERT_EQ(run, (RectRun{0, 1}));
    EXPECT_NEAR(looking.plan.rects[0].w, std::sin(-22.5 * kDegree) / 0.6, 0.02);
    EXPECT_EQ(looking.plan.rects[0].x, -1.0f);
    EXPECT_EQ(looking.plan.rects[0].z, 1.0f);
}

TEST(PlainSky, isEmptyInAPictureOfTheZenithsSide_andAllOfOneStraightDown) {
    Looking above(0.0, 50.0, 1.0, 0.6);
    ASSERT_EQ(plainSkyBelow(-0.38, above.plan).count, 1u);
    EXPECT_EQ(above.plan.rects[0].w, -1.0f);
    Looking below(0.0, -89.9, 1.0, 0.6);
    EXPECT_EQ(plainSkyBelow(-0.38, below.plan), RectRun());
}

RC_GTEST_PROP(PlainSky, containsEveryDirectionBelow, ()) {
    const auto number = [](int low, int high) { return *rc::gen::inRange(low * 100, high * 100) / 100.0; };
    Looking looking(number(0, 360), number(-90, 90), number(0, 3) + 0.01, number(0, 3) + 0.01);
    const double sine = number(-1, 0);
    const RectRun run = plainSkyBelow(sine, looking.plan);
    if (run.count == 0)
        return;
    const gpu::vec4& rect = looking.plan.rects[run.first];
    for (double x = -1.0; x <= 1.0; x += 0.125)
        for (double y = -1.0; y <= 1.0; y += 0.125)
            RC_ASSERT(looking.sineAt(x, y) > sine || (x >= rect.x && x <= rect.z && y <= rect.w));
}

} // namespace
} // namespace limen::frame
