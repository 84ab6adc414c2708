#include "frames/FrameRows.h"
#include "BenchTable.h"

#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

const std::vector<LimenRenderer> kRenderers{{"fast", {}, {Without::Visibility}},
                                            {"exact", {}, {Without::Visibility, Without::Ownership}}};
const std::vector<std::string> kWays{"fast",
                                     "fast without visibility",
                                     "exact",
                                     "exact without visibility",
                                     "exact without ownership",
                                     "plain",
                                     "peer"};

/// Two places in cells and one outside. Wall-clock times are twice the processor times.
FrameTimes someTimes(std::size_t ways = kWays.size()) {
    FrameTimes times;
    times.ways.assign(kWays.begin(), kWays.begin() + static_cast<std::ptrdiff_t>(ways));
    const std::vector<std::vector<double>> processor{
        {10, 20, 30, 40, 27, 5, 25}, {30, 30, 50, 60, 45, 15, 35}, {90, 95, 120, 130, 108, 70, 80}};
    for (std::size_t i = 0; i < processor.size(); ++i) {
        PlaceTimes place{"--eye=" + std::to_string(i), i < 2, {}};
        for (std::size_t way = 0; way < ways; ++way)
            place.ways.push_back({2.0 * processor[i][way], processor[i][way]});
        times.places.push_back(place);
    }
    return times;
}

const BenchRow& named(const std::vector<BenchRow>& rows, const std::string& name) {
    const auto found =
        std::find_if(rows.begin(), rows.end(), [&](const BenchRow& row) { return row.bench == name; });
    static const BenchRow kMissing{};
    EXPECT_NE(found, rows.end()) << name;
    return found == rows.end() ? kMissing : *found;
}

TEST(FrameRows, thereIsOneForEachRendererKindPlaceAndClock) {
    const std::vector<BenchRow> rows = rowsOf(someTimes(), kRenderers);
    EXPECT_EQ(rows.size(), 2u * (2u * 2u + 3u));
    const BenchRow& cells = named(rows, "frame/fast/cells/processor");
    EXPECT_DOUBLE_EQ(cells.value, 20.0);
    EXPECT_DOUBLE_EQ(cells.target, 0.5 * 30.0);
    EXPECT_FALSE(isMet(cells));
    EXPECT_DOUBLE_EQ(named(rows, "frame/fast/cells/wall").value, 40.0);
    EXPECT_DOUBLE_EQ(named(rows, "frame/fast/outside/processor").target, 0.8 * 80.0);
    EXPECT_DOUBLE_EQ(named(rows, "frame/exact/outside/wall").value, 240.0);
    EXPECT_FALSE(named(rows, "frame/exact/outside/wall").hasTarget);
}

TEST(FrameRows, compareWithEveryOtherWay) {
    const std::vector<BenchRow> rows = rowsOf(someTimes(), kRenderers);
    const std::vector<std::pair<std::string, double>> others{
        {"fast without visibility", 95}, {"exact", 120}, {"plain", 70}, {"peer", 80}};
    EXPECT_EQ(named(rows, "frame/places/2/processor").against, others);
}

TEST(FrameRows, showWherePlacesAreSlowerThanThePeer) {
    const std::vector<BenchRow> rows = rowsOf(someTimes(), kRenderers);
    EXPECT_TRUE(isMet(named(rows, "frame/places/0/wall")));
    EXPECT_TRUE(isMet(named(rows, "frame/places/1/processor")));
    EXPECT_FALSE(isMet(named(rows, "frame/places/2/processor")));
    EXPECT_EQ(named(rows, "frame/places/2/wall").scene, "--eye=2");
}

TEST(FrameRows, haveNoTargetsWithoutThePeer) {
    for (const BenchRow& row : rowsOf(someTimes(kWays.size() - 1), kRenderers)) {
        EXPECT_FALSE(row.hasTarget) << row.bench;
        EXPECT_GT(row.value, 0.0);
    }
}

TEST(FrameRows, ownershipIsAShareOfProcessorTime) {
    const BenchRow row = ownershipRow(someTimes(), "exact");
    EXPECT_DOUBLE_EQ(row.value, 10.0);
    EXPECT_TRUE(isMet(row));
    EXPECT_FALSE(isMet(ownershipRow(someTimes(), "fast"))) << "it was not measured";
}

} // namespace
} // namespace limen::bench::test
