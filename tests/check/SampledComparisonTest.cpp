#include "check/SampledComparison.h"
#include "check/HandMade.h"

#include <gtest/gtest.h>

namespace limen::check {
namespace {

using test::answer;
using test::at;
using test::HandMadeRetracer;
using test::tracedOf;

constexpr std::uint32_t kSampledWall = 5, kFloor = 7, kHidden = 9;

std::array<std::uint8_t, 3> grey(std::uint32_t id) {
    const auto v = static_cast<std::uint8_t>(20 * id);
    return {v, v, v};
}

/// 6 × 4 pixels of four samples, all of a wall; tests change pixel (2, 1).
struct Sampled {
    DrawnImages drawn;
    std::vector<reference::Picture> traced{4, tracedOf(6, 4, kSampledWall)};
    HandMadeRetracer retracer;
    Comparison result;

    Sampled() {
        drawn.width = 6;
        drawn.height = 4;
        drawn.samples = {{-0.375f, -0.125f}, {0.125f, -0.375f}, {0.375f, 0.125f}, {-0.125f, 0.375f}};
        drawn.colour.assign(std::size_t{6} * 4 * 4, static_cast<std::uint8_t>(20 * kSampledWall));
    }
    void draw(std::uint32_t value, std::size_t x = 2, std::size_t y = 1) {
        for (std::size_t c = 0; c < 3; ++c)
            drawn.colour[(y * 6 + x) * 4 + c] = static_cast<std::uint8_t>(value);
    }
    Verdict verdict() {
        compareSampled(drawn, traced, grey, retracer, result);
        EXPECT_EQ(result.count(Verdict::Agrees) + (result.verdicts[8] == Verdict::Agrees ? 0 : 1), 24u)
            << "the others agree";
        return result.verdicts[1 * 6 + 2];
    }
};

TEST(SampledComparison, theMeanOfWhatItsSamplesMeetAgrees) {
    Sampled pixel;
    EXPECT_EQ(pixel.verdict(), Verdict::Agrees);
    at(pixel.traced[2], 2, 1) = answer(kFloor);
    EXPECT_NE(pixel.verdict(), Verdict::Agrees) << "one sample meets the floor, and none of it was drawn";
    pixel.draw((3 * 100 + 140) / 4);
    EXPECT_EQ(pixel.verdict(), Verdict::Agrees);
    pixel.draw((3 * 100 + 140) / 4 + 1);
    EXPECT_EQ(pixel.verdict(), Verdict::Agrees) << "means are rounded";
    pixel.draw((2 * 100 + 2 * 140) / 4);
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees);
}

TEST(SampledComparison, whereAllSamplesMeetTheSameTheColourIsExact) {
    Sampled pixel;
    pixel.draw(101);
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees);
    EXPECT_EQ(pixel.result.findings(), 1u);
}

TEST(SampledComparison, anEdgeThatPassesBesideASampleMakesASliver) {
    Sampled pixel;
    pixel.draw((3 * 100 + 140) / 4);
    pixel.retracer.exactId = [](double x, double) { return x > 2.37501 && x < 2.4 ? kFloor : kSampledWall; };
    EXPECT_EQ(pixel.verdict(), Verdict::Sliver);
    pixel.retracer.exactId = [](double x, double) { return x > 2.376 ? kFloor : kSampledWall; };
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees) << "farther off than corners are rounded";
}

/// A villager's arm, a hand's breadth before the eye.
TEST(SampledComparison, anOutlineNearTheEyeIsRoundedByMore) {
    Sampled pixel;
    pixel.draw((3 * 100 + 140) / 4);
    pixel.retracer.exactId = [](double x, double) { return x > 2.376 && x < 2.4 ? kFloor : kSampledWall; };
    pixel.retracer.near = {kFloor};
    pixel.retracer.rounding = [](std::uint32_t id) { return id == kFloor ? 5e-4 : 0.0; };
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees) << "it would have to be moved by 1e-3 of a pixel";
    pixel.retracer.rounding = [](std::uint32_t id) { return id == kFloor ? 2e-3 : 0.0; };
    EXPECT_EQ(pixel.verdict(), Verdict::Sliver);
    pixel.retracer.near = {};
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees) << "nothing that is rounded so passes there";
}

/// A trunk far away whose side is a thousandth of a pixel wide, seen by a sample of the tour.
TEST(SampledComparison, aStripNarrowerThanAnyGridMakesASliver) {
    Sampled pixel;
    pixel.draw((3 * 100 + 140) / 4);
    pixel.retracer.exactId = [](double x, double) {
        return x > 2.3750001 && x < 2.375002 ? kFloor : kSampledWall;
    };
    EXPECT_EQ(pixel.verdict(), Verdict::Sliver);
}

TEST(SampledComparison, whatIsSeenOnlyInPixelsAroundIsWrong) {
    Sampled pixel;
    pixel.draw((3 * 100 + 140) / 4);
    pixel.retracer.exactId = [](double, double) { return kSampledWall; };
    pixel.retracer.edgeOn = [](std::uint32_t id) { return id == kFloor; };
    at(pixel.traced[0], 3, 2) = answer(kFloor);
    pixel.draw((3 * 100 + 140) / 4, 3, 2);
    EXPECT_EQ(pixel.verdict(), Verdict::Disagrees);
    pixel.retracer.near = {kFloor};
    EXPECT_EQ(pixel.verdict(), Verdict::EdgeOn);
}

TEST(SampledComparison, aHiddenPolygonIsWrong) {
    Sampled pixel;
    pixel.draw((3 * 100 + 180) / 4);
    pixel.retracer.exactId = [](double, double) { return kSampledWall; };
    pixel.retracer.near = {kHidden};
    pixel.retracer.edgeOn = [](std::uint32_t id) { return id == kHidden; };
    EXPECT_EQ(pixel.verdict(), Verdict::EdgeOn);
    EXPECT_EQ(pixel.result.findings(), 1u);
}

TEST(SampledComparison, raysOutOfTheSpaceOfAnEyeOnAWallAreNotJudged) {
    Sampled pixel;
    pixel.draw(0);
    pixel.retracer.into = [](double x, double y) { return x != 3.0 || y != 2.0; };
    EXPECT_EQ(pixel.verdict(), Verdict::Unjudged);
}

TEST(SampledComparison, theOtherReadingOfZonesIsRight) {
    Sampled pixel;
    pixel.draw(140);
    pixel.retracer.byZoneId = [](double, double) { return kFloor; };
    EXPECT_EQ(pixel.verdict(), Verdict::ByZone);
}

} // namespace
} // namespace limen::check
