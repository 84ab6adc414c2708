#include "motion/PartPoses.h"

#include "geometry/Angles.h"

#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>

namespace limen::motion {
namespace {

using world::Gait;
using world::kNone;

/// A world with one body of two parts and frames made by hand. In frame k of any animation the first part is
/// at (k, 0, 0), the second at (0, k, 0).
struct HandMade {
    world::World world;
    world::MovingBody body;

    HandMade() {
        body.partCount = 2;
        body.firstPosed = 0;
        world.movingParts.resize(2);
        world.movingParts[1].origin = Vec3f(0, 0, 7); // the resting pose
        world.posedParts = {{0, Vec3(1.0)}, {1, Vec3(1.0)}};
        for (int k = 0; k < 16; ++k) {
            world.partFrames.push_back({Quat(1, 0, 0, 0), Vec3(k, 0, 0)});
            world.partFrames.push_back({Quat(1, 0, 0, 0), Vec3(0, k, 0)});
        }
    }
    /// Frames low..high at a rate.
    static world::Stretch stretch(std::uint32_t low, std::uint32_t high, double rate) {
        return {2 * low, 2, high - low + 1, rate};
    }
    std::uint32_t add(const std::vector<world::Stretch>& stretches, const Vec3& velocity = Vec3(0.0)) {
        world.cycles.push_back({static_cast<std::uint32_t>(world.stretches.size()),
                                static_cast<std::uint32_t>(stretches.size()), velocity});
        world.stretches.insert(world.stretches.end(), stretches.begin(), stretches.end());
        return static_cast<std::uint32_t>(world.cycles.size() - 1);
    }
    BetweenFrames between = BetweenFrames::Interpolated;
    [[nodiscard]] PartPose pose(std::uint32_t cycle, double seconds, std::uint32_t part = 0) const {
        return PartPoses(world, body, {cycle, seconds}, between).of(part);
    }
    /// Where the first part is: the number of the frame, or between two.
    [[nodiscard]] double at(std::uint32_t cycle, double seconds) const {
        return pose(cycle, seconds).origin.x;
    }
};

TEST(PartPoses, standUntilTheNextFrameWhereFramesAreHeld) {
    HandMade p;
    p.between = BetweenFrames::Held;
    const std::uint32_t cycle = p.add({HandMade::stretch(2, 5, 10.0)});
    for (const auto& [seconds, frame] : {std::pair{0.0, 2.0},
                                         {0.05, 2.0},
                                         {0.0999, 2.0},
                                         {0.1001, 3.0},
                                         {0.325, 5.0},
                                         {0.3999, 5.0},
                                         {0.4001, 2.0}})
        EXPECT_EQ(p.at(cycle, seconds), frame) << seconds;
    const std::uint32_t back = p.add({HandMade::stretch(2, 5, -10.0)});
    EXPECT_EQ(p.at(back, 0.05), 5.0);
    EXPECT_EQ(p.at(back, 0.1001), 4.0);
}

TEST(PartPoses, playForwardsAndBeginAgainAfterTheLast) {
    HandMade p;
    const std::uint32_t cycle = p.add({HandMade::stretch(2, 5, 10.0)});
    EXPECT_EQ(p.at(cycle, 0.0), 2.0);
    EXPECT_NEAR(p.at(cycle, 0.1), 3.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.325), 5.0 - 0.25 * 3.0, 1e-12) << "on the way back to the first";
    EXPECT_NEAR(p.at(cycle, 0.4), 2.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 1000.2), 4.0, 1e-9);
    EXPECT_NEAR(p.at(cycle, -0.1), 5.0, 1e-12) << "before time 0 too";
}

/// docs/retail.md: the original program shows the last frame, without interpolation.
TEST(PartPoses, goEvenlyFromFrameToFrame) {
    HandMade p;
    const std::uint32_t cycle = p.add({HandMade::stretch(0, 3, 10.0)});
    EXPECT_NEAR(p.at(cycle, 0.025), 0.25, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.15), 1.5, 1e-12);
    EXPECT_NEAR(p.pose(cycle, 0.15, 1).origin.y, 1.5, 1e-12) << "all parts at once";
}

TEST(PartPoses, playBackwardsFromTheLast) {
    HandMade p;
    const std::uint32_t cycle = p.add({HandMade::stretch(2, 5, -10.0)});
    EXPECT_EQ(p.at(cycle, 0.0), 5.0);
    EXPECT_NEAR(p.at(cycle, 0.1), 4.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.25), 2.5, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.325), 2.0 + 0.25 * 3.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.4), 5.0, 1e-12);
}

TEST(PartPoses, playASequenceOnceAndItsLastForEver) {
    HandMade p;
    const std::uint32_t cycle =
        p.add({HandMade::stretch(0, 1, 10.0), HandMade::stretch(3, 5, -20.0), HandMade::stretch(7, 8, 10.0)});
    EXPECT_EQ(p.at(cycle, 0.0), 0.0);
    EXPECT_NEAR(p.at(cycle, 0.15), 3.0, 1e-12) << "from frame 1 to the first of the next stretch, frame 5";
    EXPECT_NEAR(p.at(cycle, 0.2), 5.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.3), 3.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.35), 7.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.45), 8.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 0.5), 7.5, 1e-12) << "back to its own first frame, not the sequence's";
    EXPECT_NEAR(p.at(cycle, 0.55), 7.0, 1e-12);
    EXPECT_NEAR(p.at(cycle, 100.65), 8.0, 1e-9);
}

TEST(PartPoses, stayWhereTheRateIsNone) {
    HandMade p;
    const std::uint32_t still = p.add({HandMade::stretch(3, 5, 0.0)});
    const std::uint32_t stuck = p.add({HandMade::stretch(3, 5, 0.0), HandMade::stretch(8, 9, 10.0)});
    for (const double seconds : {0.0, 1.0, 1e9}) {
        EXPECT_EQ(p.at(still, seconds), 3.0);
        EXPECT_EQ(p.at(stuck, seconds), 3.0) << "the next stretch is never reached";
    }
}

TEST(PartPoses, areSomeFrameForAnyNumber) {
    HandMade p;
    const std::uint32_t cycle = p.add({HandMade::stretch(0, 1, 10.0), HandMade::stretch(2, 5, -1e30)});
    for (const double seconds : {1e300, -1e300, 1e-300, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_GE(p.at(cycle, seconds), 0.0);
        EXPECT_LE(p.at(cycle, seconds), 5.0);
    }
}

TEST(PartPoses, jumpWherePartsMoveFarOrTurnFar) {
    HandMade p;
    const std::uint32_t cycle = p.add({HandMade::stretch(0, 1, 1.0)});
    const auto middleOf = [&](double metres, double degrees) {
        p.world.partFrames[2] = {glm::angleAxis(degrees * kDegree, Vec3(0, 0, 1)), Vec3(metres, 0, 0)};
        return p.pose(cycle, 0.5);
    };
    EXPECT_NEAR(middleOf(4.0, 0.0).origin.x, 2.0, 1e-12);
    EXPECT_EQ(middleOf(4.001, 0.0).origin.x, 0.0) << "the frame stands until the next";
    EXPECT_NEAR(middleOf(0.0, 119.9).linear[0].y, std::sin(59.95 * kDegree), 1e-9);
    EXPECT_EQ(middleOf(0.0, 120.1).linear[0].y, 0.0);
}

TEST(PartPoses, turnTheShorterWay) {
    HandMade p;
    const auto about = [](double degrees) { return glm::angleAxis(glm::radians(degrees), Vec3(1, 0, 0)); };
    p.world.partFrames[0].orientation = about(10.0);
    p.world.partFrames[2].orientation = -about(70.0); // the same rotation with the opposite sign
    const std::uint32_t cycle = p.add({HandMade::stretch(0, 1, 1.0)});
    const Mat3 quarter = p.pose(cycle, 0.25).linear, expected = glm::mat3_cast(about(25.0));
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(glm::length(quarter[axis] - expected[axis]), 0.0, 1e-12);
}

TEST(PartPoses, restWhereFramesHaveFewerParts) {
    HandMade p;
    // Frames of one part only: the list no longer alternates between two parts.
    const std::uint32_t one = p.add({{0, 1, 4, 10.0}});
    EXPECT_EQ(p.pose(one, 0.1, 1).origin, Vec3(0, 0, 7));
    EXPECT_NEAR(p.pose(one, 0.2, 0).origin.x, 1.0, 1e-12);
    // The part keeps its last frame until the next one.
    const std::uint32_t both = p.add({HandMade::stretch(3, 3, 10.0), {0, 1, 1, 10.0}});
    EXPECT_EQ(p.pose(both, 0.05, 1).origin, Vec3(0, 3, 0));
    EXPECT_EQ(p.pose(both, 0.15, 1).origin, Vec3(0, 0, 7));
    EXPECT_EQ(p.pose(kNone, 3.0, 1).origin, Vec3(0, 0, 7)) << "no cycle at all";
}

TEST(PartPoses, haveTheSizeOfTheirPart) {
    HandMade p;
    p.world.posedParts[0] = {1, Vec3(2, 3, 4)}; // such as a level of detail of the second part
    p.world.partFrames[3].orientation = glm::angleAxis(glm::radians(90.0), Vec3(0, 0, 1));
    const PartPose pose = p.pose(p.add({HandMade::stretch(1, 1, 1.0)}), 0.5);
    EXPECT_EQ(pose.origin, Vec3(0, 1, 0)) << "places are not scaled";
    EXPECT_NEAR(glm::length(pose.linear * Vec3(1, 0, 0) - Vec3(0, 2, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(pose.linear * Vec3(0, 1, 0) - Vec3(-3, 0, 0)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(pose.linear * Vec3(0, 0, 1) - Vec3(0, 0, 4)), 0.0, 1e-12);
}

/// The rule of the format page, tick by tick: frame += fps·dt, past high+1 from low again, backwards from
/// high+1-0.0002 down to low, and the pose is floor(frame).
int framesOfTheOriginal(int low, int high, double fps, int ticks, double ticksPerFrame) {
    double frame = fps > 0.0 ? low : high + 1 - 0.0002;
    for (int i = 0; i < ticks; ++i) {
        frame += (fps > 0.0 ? 1.0 : -1.0) / ticksPerFrame;
        if (fps > 0.0 && frame >= high + 1)
            frame -= high + 1 - low;
        if (fps < 0.0 && frame < low)
            frame += high + 1 - low;
    }
    return static_cast<int>(std::floor(frame));
}

RC_GTEST_PROP(PartPoses, areTheOriginalsAtEveryWholeFrame, ()) {
    HandMade p;
    const int low = *rc::gen::inRange(0, 15), high = *rc::gen::inRange(low, 15);
    const double fps = *rc::gen::element(1.0, 7.5, 30.0, 60.0) * (*rc::gen::arbitrary<bool>() ? 1.0 : -1.0);
    const int steps = *rc::gen::inRange(0, 60);
    const std::uint32_t cycle =
        p.add({HandMade::stretch(static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high), fps)});
    // Half a frame later, so that neither rounds to the frame before.
    const int frame = framesOfTheOriginal(low, high, fps, 4 * steps + 2, 4.0);
    RC_ASSERT(std::abs(p.at(cycle, steps / std::abs(fps) + 1e-10) - frame) < 1e-6);
}

TEST(Gaits, areChosenByWhichVelocityIsNearer) {
    HandMade p;
    p.body.cycles = {kNone, p.add({HandMade::stretch(0, 1, 1.0)}, {0, 1.5, 0}),
                     p.add({HandMade::stretch(0, 1, 1.0)}, {0, 4.5, 0})};
    EXPECT_EQ(gaitAt(p.world, p.body, 0.0), Gait::Stand);
    EXPECT_EQ(gaitAt(p.world, p.body, 0.1), Gait::Walk);
    EXPECT_EQ(gaitAt(p.world, p.body, 2.9), Gait::Walk);
    EXPECT_EQ(gaitAt(p.world, p.body, 3.1), Gait::Run);
    EXPECT_EQ(gaitAt(p.world, p.body, -3.1), Gait::Run) << "backwards";
    p.world.cycles[p.body.cycles[2]].velocity = Vec3(0.0);
    EXPECT_EQ(gaitAt(p.world, p.body, 9.0), Gait::Walk);
    p.body.cycles = {kNone, kNone, kNone};
    EXPECT_EQ(gaitAt(p.world, p.body, 9.0), Gait::Walk);
}

TEST(CyclePoints, followTheWayThatIsGoneWhereTheCycleSaysHowFast) {
    HandMade p;
    const std::uint32_t stand = p.add({HandMade::stretch(0, 1, 1.0)}, {0, 9, 0}),
                        walk = p.add({HandMade::stretch(0, 1, 1.0)}, {0, 1.5, 0}),
                        run = p.add({HandMade::stretch(0, 1, 1.0)});
    p.body.cycles = {stand, walk, run};
    const auto at = [&](Gait gait) { return cyclePoint(p.world, p.body, gait, -3.0, 20.0); };
    EXPECT_EQ(at(Gait::Walk).cycle, walk);
    EXPECT_EQ(at(Gait::Walk).seconds, -2.0);
    EXPECT_EQ(at(Gait::Run).cycle, run);
    EXPECT_EQ(at(Gait::Run).seconds, 20.0) << "it does not say how fast it goes";
    EXPECT_EQ(at(Gait::Stand).cycle, stand);
    EXPECT_EQ(at(Gait::Stand).seconds, 20.0) << "speed 0 stands, for every cycle";
}

TEST(CyclePoints, makeDoWithTheCyclesThereAre) {
    HandMade p;
    const std::uint32_t one = p.add({HandMade::stretch(0, 1, 1.0)}, {0, 2, 0});
    const auto at = [&](Gait gait) { return cyclePoint(p.world, p.body, gait, 3.0, 20.0); };
    p.body.cycles = {kNone, one, kNone};
    EXPECT_EQ(at(Gait::Run).cycle, one);
    EXPECT_EQ(at(Gait::Run).seconds, 1.5);
    EXPECT_EQ(at(Gait::Stand).cycle, kNone) << "a standing body does not play the walk cycle";
    p.body.cycles = {kNone, kNone, one};
    EXPECT_EQ(at(Gait::Walk).cycle, one);
    p.body.cycles = {one, kNone, kNone};
    EXPECT_EQ(at(Gait::Walk).cycle, one);
    EXPECT_EQ(at(Gait::Walk).seconds, 20.0);
}

} // namespace
} // namespace limen::motion
