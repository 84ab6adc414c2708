#include "ComparedWorld.h"
#include "HeadlessDriver.h"
#include "card/CardTimes.h"

#include <gtest/gtest.h>

namespace limen::bench::test {
namespace {

TEST(CardTimesGl, everyWayAndSizeIsTimedAtEveryPlace) {
    const std::optional<HeadlessDriver> driver = openDriver();
    ASSERT_TRUE(driver);
    const ComparedWorld source;
    gpu::RendererOptions fast;
    fast.drawing = gpu::Drawing::Fast;
    const Result<std::vector<CardTimes>> times =
        timeOnCard(*driver->device, *source.archive, source.file, {source.inRoom, source.outside},
                   {{"fast", fast}, {"exact", {}}}, {{64, 36}, {640, 360}}, {1, 3});
    ASSERT_TRUE(times) << times.error().message();
    ASSERT_EQ(times->size(), 4u);
    EXPECT_EQ((*times)[0].hash, (*times)[2].hash); // both ways draw one plan
    for (const CardTimes& each : *times) {
        ASSERT_EQ(each.places.size(), 2u);
        for (const CardTime& time : each.places) {
            EXPECT_GT(time.frame, 0.0);
            EXPECT_GT(time.stages[static_cast<std::size_t>(frame::StageKind::Solid)], 0.0);
        }
    }
    // A hundred times as many pixels take longer.
    EXPECT_GT((*times)[3].places[1].frame, (*times)[2].places[1].frame);
}

} // namespace
} // namespace limen::bench::test
