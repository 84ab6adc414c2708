#include "gpu/device/NullDevice.h"
#include "play/Play.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Demo.h"

#include <algorithm>
#include <gtest/gtest.h>

// Where a walk begins, the feet come to rest at one height, whatever the frame times are.
namespace limen::play {
namespace {

/// The feet of a body that begins to walk at a place and stands for `frames` frames, global metres.
Vec3 feetAfter(engine::Session& session, const engine::FrameRequest& start, double seconds, int frames) {
    Play play(session, start);
    PlayInput input;
    input.size = {64, 36};
    input.seconds = seconds;
    input.acts = {{PlayActKind::Walk, 0.0, 0.0}};
    for (int i = 0; i < frames; ++i) {
        EXPECT_TRUE(play.step(input));
        EXPECT_TRUE(session.draw(play.request(), {}));
        input.acts.clear();
    }
    EXPECT_TRUE(play.walk().body().isOnGround);
    return play.walk().body().standing.feet;
}

TEST(WalkStart, restsAtOneHeightForAnyFrameTime) {
    const test::TemporaryDirectory directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
    ASSERT_TRUE(source) << source.error().message();
    gpu::NullDevice device;
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), {}, device);
    for (const char* name : {"cottage.front", "cottage.room", "lane", "hill", "inn.hall"}) {
        SCOPED_TRACE(name);
        const std::vector<world::Place>& places = session.source().file.places;
        const auto place =
            std::find_if(places.begin(), places.end(), [&](const world::Place& p) { return p.name == name; });
        ASSERT_NE(place, places.end());
        const engine::ViewRequest view = engine::requestAt(*place);
        ASSERT_TRUE(session.load(engine::centreOf(view)));
        const Result<engine::FrameRequest> start =
            engine::frameRequest(session.part().world, session.source().file, view);
        ASSERT_TRUE(start);
        const Vec3 feet = feetAfter(session, *start, 1.0 / 60.0, 60);
        for (const double seconds : {0.004, 0.0071, 0.0123, 0.0197, 0.0333, 0.281})
            EXPECT_EQ(feetAfter(session, *start, seconds, 60), feet) << seconds << " seconds a frame";
    }
}

} // namespace
} // namespace limen::play
