#include "check/HandMade.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace limen::check {
namespace {

using test::answer;
using test::at;
using test::drawnOf;
using test::HandMadeRetracer;
using test::tracedOf;

constexpr std::uint32_t kWall = 5, kOther = 7;

/// A wall drawn and traced, 6 × 4 pixels, with pixel (2, 1) drawn as another id.
struct OneOddPixel {
    DrawnImages drawn = drawnOf(6, 4, kWall);
    reference::Picture traced = tracedOf(6, 4, kWall);
    HandMadeRetracer retracer;
    Comparison result;

    explicit OneOddPixel(std::uint32_t id) { drawn.ids[1 * 6 + 2] = id; }
    Verdict verdict() {
        compare(drawn, traced, retracer, result);
        EXPECT_EQ(result.count(Verdict::Agrees) + 1, 24u) << "the others agree";
        return result.verdicts[1 * 6 + 2];
    }
};

TEST(Comparison, equalPicturesAgree) {
    HandMadeRetracer retracer;
    Comparison result;
    compare(drawnOf(6, 4, kWall), tracedOf(6, 4, kWall), retracer, result);
    EXPECT_EQ(result.count(Verdict::Agrees), 24u);
    EXPECT_EQ(result.findings(), 0u);
}

TEST(Comparison, anIdThatNoRayMeetsDisagrees) {
    OneOddPixel odd(kOther);
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees);
    EXPECT_EQ(odd.result.findings(), 1u);
}

TEST(Comparison, anIdOfANeighbourAgrees) {
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            OneOddPixel odd(kOther);
            at(odd.traced, 2 + dx, 1 + dy) = answer(kOther);
            compare(odd.drawn, odd.traced, odd.retracer, odd.result);
            EXPECT_EQ(odd.result.findings(), 0u) << dx << ' ' << dy;
        }
    }
}

TEST(Comparison, anIdTwoPixelsAwayDisagrees) {
    OneOddPixel odd(kOther);
    at(odd.traced, 4, 1) = answer(kOther);
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees);
}

TEST(Comparison, theBorderBeyondThePictureCounts) {
    DrawnImages drawn = drawnOf(6, 4, kWall);
    drawn.ids[0] = kOther;
    reference::Picture traced = tracedOf(6, 4, kWall);
    at(traced, -1, -1) = answer(kOther);
    HandMadeRetracer retracer;
    Comparison result;
    compare(drawn, traced, retracer, result);
    EXPECT_EQ(result.findings(), 0u);
}

TEST(Comparison, finerRaysMakeASliver) {
    OneOddPixel odd(kOther);
    odd.retracer.exactId = [](double x, double) { return x > 2.2 && x < 2.3 ? kOther : kWall; };
    EXPECT_EQ(odd.verdict(), Verdict::Sliver);
    EXPECT_EQ(odd.result.findings(), 0u);
}

TEST(Comparison, aStripNarrowerThanAnyGridMakesASliver) {
    OneOddPixel odd(kOther); // a millionth of a pixel, between two walls
    odd.retracer.exactId = [](double x, double) {
        return x < 2.0003 ? kWall : x < 2.000301 ? kOther : kWall + 1;
    };
    EXPECT_EQ(odd.verdict(), Verdict::Sliver);
    odd.retracer.exactId = [](double x, double) { return x < 2.0003 ? kWall : kWall + 1; };
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees) << "where two walls meet nothing shows between them";
}

TEST(Comparison, finerRaysBeyondTheNeighboursMakeNone) {
    OneOddPixel odd(kOther);
    odd.retracer.exactId = [](double x, double) { return x > 3.51 ? kOther : kWall; };
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees);
}

TEST(Comparison, theOtherReadingOfZonesIsRight) {
    OneOddPixel odd(kOther);
    odd.retracer.byZoneId = [](double, double) { return kOther; };
    EXPECT_EQ(odd.verdict(), Verdict::ByZone);
    EXPECT_EQ(odd.result.findings(), 0u);
}

TEST(Comparison, theOtherReadingExcusesOnlyWhatItShows) {
    OneOddPixel odd(kOther);
    odd.retracer.byZoneId = [](double, double) { return kOther + 1; };
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees);
}

TEST(Comparison, aVoidOutOfTheSpaceOfAnEyeOnAWallIsNoHole) {
    OneOddPixel odd(0);
    at(odd.traced, 2, 1) = answer(0);
    odd.retracer.into = [](double, double) { return false; };
    EXPECT_EQ(odd.verdict(), Verdict::Unjudged);
}

TEST(Comparison, aWholePictureOutOfTheSpaceOfAnEyeOnAWallIsNotJudged) {
    HandMadeRetracer retracer;
    retracer.into = [](double, double) { return false; };
    Comparison result;
    compare(drawnOf(64, 64, kOther), tracedOf(64, 64, kWall), retracer, result);
    EXPECT_EQ(result.count(Verdict::Unjudged), 64u * 64u);
}

TEST(Comparison, raysOutOfTheSpaceOfAnEyeOnAWallAreNotJudged) {
    OneOddPixel odd(kOther);
    odd.retracer.into = [](double x, double) { return x < 2.5; };
    EXPECT_EQ(odd.verdict(), Verdict::Unjudged);
    odd.retracer.into = [](double x, double) { return x < 3.5; };
    EXPECT_EQ(odd.verdict(), Verdict::Disagrees);
}

TEST(Comparison, anEdgeOnPolygonStaysAFindingOfItsOwn) {
    OneOddPixel odd(kOther);
    odd.retracer.edgeOn = [](std::uint32_t id) { return id == kOther; };
    EXPECT_EQ(odd.verdict(), Verdict::EdgeOn);
    EXPECT_EQ(odd.result.findings(), 1u);
}

TEST(Comparison, aDrawnVoidWhereThereIsNoneIsAFinding) {
    OneOddPixel odd(0);
    EXPECT_EQ(odd.verdict(), Verdict::Void);
    EXPECT_EQ(odd.result.findings(), 1u);
}

TEST(Comparison, aVoidThatTheRuleFindsTooIsAHole) {
    OneOddPixel odd(0);
    at(odd.traced, 2, 1) = answer(0);
    EXPECT_EQ(odd.verdict(), Verdict::Hole);
    OneOddPixel crack(0);
    crack.retracer.exactId = [](double x, double) { return x == 2.0 ? 0u : kWall; };
    EXPECT_EQ(crack.verdict(), Verdict::Hole) << "narrower than a pixel";
    EXPECT_EQ(crack.result.findings(), 0u);
}

TEST(Comparison, aWallDrawnOverAHoleDisagrees) {
    DrawnImages drawn = drawnOf(6, 4, kWall);
    HandMadeRetracer retracer;
    Comparison result;
    compare(drawn, tracedOf(6, 4, 0), retracer, result);
    EXPECT_EQ(result.count(Verdict::Disagrees), 24u);
}

TEST(Comparison, aWrongDepthOfTheRightIdIsAFinding) {
    OneOddPixel odd(kWall);
    odd.drawn.depth[8] = static_cast<float>(0.02 / 4.01);
    EXPECT_EQ(odd.verdict(), Verdict::Depth);
    EXPECT_EQ(odd.result.findings(), 1u);
    odd.retracer.depth = [](std::uint32_t id) { return id == kWall; };
    compare(odd.drawn, odd.traced, odd.retracer, odd.result);
    EXPECT_EQ(odd.result.findings(), 0u) << "the polygon's slope may explain it";
}

TEST(Comparison, depthsWithinATenThousandthAreTheSame) {
    OneOddPixel odd(kWall);
    odd.drawn.depth[8] = static_cast<float>(0.02 / 4.0003);
    compare(odd.drawn, odd.traced, odd.retracer, odd.result);
    EXPECT_EQ(odd.result.findings(), 0u);
}

TEST(Comparison, depthIsJudgedOnlyWhereThePixelsOwnIdAgrees) {
    OneOddPixel odd(kOther);
    odd.drawn.depth[8] = static_cast<float>(0.02 / 9.0);
    at(odd.traced, 3, 1) = answer(kOther, 9.0);
    compare(odd.drawn, odd.traced, odd.retracer, odd.result);
    EXPECT_EQ(odd.result.findings(), 0u);
}

TEST(Comparison, skyHasNoDepth) {
    DrawnImages drawn = drawnOf(6, 4, 1);
    HandMadeRetracer retracer;
    Comparison result;
    compare(drawn, tracedOf(6, 4, 1), retracer, result);
    EXPECT_EQ(result.findings(), 0u);
    drawn.depth[3] = 0.001f;
    compare(drawn, tracedOf(6, 4, 1), retracer, result);
    EXPECT_EQ(result.count(Verdict::Depth), 1u);
}

TEST(Comparison, layersMustBeThoseOfTheNeighbourhood) {
    OneOddPixel odd(kWall);
    odd.drawn.layers.assign(24, reference::Layers{});
    odd.drawn.layers[8] = {1, 1234};
    EXPECT_EQ(odd.verdict(), Verdict::Layers);
    at(odd.traced, 3, 2).layers = {1, 1234};
    compare(odd.drawn, odd.traced, odd.retracer, odd.result);
    EXPECT_EQ(odd.result.verdicts[8], Verdict::Agrees) << "as a neighbour has them";
}

TEST(Comparison, aBrokenPictureIsNotLookedAtForEver) {
    DrawnImages drawn = drawnOf(64, 64, kOther);
    HandMadeRetracer retracer;
    Comparison result;
    compare(drawn, tracedOf(64, 64, kWall), retracer, result);
    EXPECT_EQ(result.count(Verdict::Disagrees), 64u * 64u);
    EXPECT_LT(retracer.finerRays, kMostSecondLooks * 4000);
}

TEST(Comparison, fewerSecondLooksJudgeMoreStrictly) {
    const DrawnImages drawn = drawnOf(64, 64, kOther);
    HandMadeRetracer retracer; // finer rays explain the lower half
    retracer.byZoneId = [](double, double y) { return y > 32.0 ? kOther : kWall; };
    Comparison all, few;
    compare(drawn, tracedOf(64, 64, kWall), retracer, all);
    compare(drawn, tracedOf(64, 64, kWall), retracer, few, 8);
    EXPECT_EQ(few.findings(), 64u * 64u);
    EXPECT_EQ(few.count(Verdict::ByZone), 0u);
    EXPECT_GE(few.findings(), all.findings());
}

TEST(Comparison, pixelsThatAreExplainedDoNotUseUpTheSecondLooks) {
    const DrawnImages drawn = drawnOf(64, 64, kOther);
    HandMadeRetracer retracer;
    retracer.byZoneId = [](double, double) { return kOther; };
    Comparison result;
    compare(drawn, tracedOf(64, 64, kWall), retracer, result);
    EXPECT_EQ(result.count(Verdict::ByZone), 64u * 64u);
}

TEST(Stillness, countsPixelsThatDifferInAnyBit) {
    DrawnImages first = drawnOf(4, 2, kWall);
    first.colour.assign(4 * 2 * 4, 100);
    DrawnImages second = first;
    EXPECT_EQ(pixelsThatMoved(first, second), 0u);
    second.ids[0] = kOther;
    second.depth[1] = std::nextafter(second.depth[1], 1.0f);
    second.colour[4 * 2 + 3] = 101;
    EXPECT_EQ(pixelsThatMoved(first, second), 3u);
}

TEST(Comparison, aPicturesHashIsOfAllThatWasDrawn) {
    DrawnImages drawn = drawnOf(4, 2, kWall);
    drawn.colour.assign(4 * 2 * 4, 100);
    drawn.layers.resize(4 * 2);
    const std::uint64_t hash = hashOf(drawn);
    EXPECT_EQ(hashOf(drawn), hash);
    std::set<std::uint64_t> hashes{hash};
    for (const std::size_t pixel : {0u, 3u, 7u}) {
        DrawnImages other = drawn;
        other.ids[pixel] = kOther;
        hashes.insert(hashOf(other));
        other = drawn;
        other.depth[pixel] = std::nextafter(other.depth[pixel], 1.0f);
        hashes.insert(hashOf(other));
        other = drawn;
        ++other.layers[pixel].count;
        hashes.insert(hashOf(other));
        other = drawn;
        ++other.colour[4 * pixel + 3];
        hashes.insert(hashOf(other));
    }
    EXPECT_EQ(hashes.size(), 13u);
}

} // namespace
} // namespace limen::check
