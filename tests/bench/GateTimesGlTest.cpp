#include "ComparedWorld.h"
#include "GatesBench.h"
#include "HeadlessDriver.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

TEST(GateTimesGl, everyGateIsCountedAtEveryPlace) {
    const std::optional<HeadlessDriver> driver = openDriver();
    ASSERT_TRUE(driver);
    const ComparedWorld source;
    const Result<GateFrames> frames = timeGates(*driver->device, *source.archive, source.file,
                                                {source.inRoom, source.outside}, {}, {64, 36, 2});
    ASSERT_TRUE(frames) << frames.error().message();
    ASSERT_EQ(frames->places.size(), 2u);
    for (const auto& place : frames->places) {
        for (const GateFrame& frame : place) {
            EXPECT_GT(frame.milliseconds, 0.0);
            EXPECT_GT(frame.calls, 10u);
            EXPECT_GT(frame.draws, 0u);
            EXPECT_TRUE(!frame.fragments || *frame.fragments > 0.0);
        }
    }
}

TEST(GateRows, nameEachFigureOfEachGateAndCompareIt) {
    GateFrames frames;
    frames.places.resize(2);
    frames.places[0][1].calls = 40;
    frames.places[1][1].calls = 44;
    frames.places[0][2].calls = 100;
    frames.places[0][1].fragments = 2000.0;
    frames.places[1][1].fragments = 4000.0;
    const std::vector<BenchRow> rows = gateRows(frames, "exact");
    const auto rowOf = [&](const std::string& name) {
        for (const BenchRow& row : rows)
            if (row.bench == name)
                return row;
        ADD_FAILURE() << name;
        return BenchRow();
    };
    const BenchRow calls = rowOf("gates/exact/planes/calls");
    EXPECT_EQ(calls.value, 42.0);
    ASSERT_EQ(calls.against.size(), 2u);
    EXPECT_EQ(calls.against[1], (std::pair<std::string, double>("depth", 50.0)));
    EXPECT_EQ(rowOf("gates/exact/planes/fragments").value, 3.0);
    EXPECT_TRUE(std::isnan(rowOf("gates/exact/depth/fragments").value)) << "not counted";
}

} // namespace
} // namespace limen::bench::test
