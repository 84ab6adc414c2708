#include "gpu/device/NullDevice.h"
#include "play/FrameSource.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Demo.h"

#include <gtest/gtest.h>

namespace limen::play {
namespace {

TEST(ReplayedFrames, haveTheReadingsAndZonesOfTheirSession_andTheRecordsRadius) {
    const test::TemporaryDirectory directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
    ASSERT_TRUE(source) << source.error().message();
    const engine::ViewRequest start = engine::requestAt(*engine::firstPlace(source->file));
    engine::SessionOptions options;
    options.load.readings.cellFog = world::CellFog::None;
    options.load.mergeZones = false;
    gpu::NullDevice device;
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), options, device);
    WalkRecord record;
    record.streamed = world::LoadOptions{.radius = 1};
    record.frames.emplace_back().input.size = {64, 36};
    ASSERT_TRUE(ReplayedFrames::open(session, record, start));
    EXPECT_EQ(session.part().world.readings, options.load.readings);
    EXPECT_FALSE(session.part().target.options.mergeZones);
    EXPECT_EQ(session.part().target.options.radius, 1);
}

} // namespace
} // namespace limen::play
