#include "engine/stream/Streamer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace limen::engine {
namespace {

constexpr dat::BlockCoord kHome{100, 100};
const world::LoadOptions kLoad{.radius = 4, .farRadius = 12};

/// Carries commands out at a pace that the test sets. Counts parts: each part that is read is shown, dropped
/// or failed once.
class FakeWork {
public:
    StreamProgress progress() {
        StreamProgress progress;
        ++slices;
        if (isUploading) {
            progress.isUploaded = framesToUpload == 0 && !uploadFails;
            if (framesToUpload == 0 && uploadFails)
                progress.error = Error{ErrorCode::Driver, "", "out of memory"};
            framesToUpload = std::max(framesToUpload - 1, 0);
        } else if (isReading) {
            progress.isRead = framesToRead == 0;
            framesToRead = std::max(framesToRead - 1, 0);
            if (progress.isRead && fails)
                progress.error = Error{ErrorCode::NotFound, "dat", "nothing there"};
            isReading = !progress.isRead;
            isRead = progress.isRead && !fails;
        }
        return progress;
    }
    void carryOut(StreamCommand command, const Streamer& streamer) {
        switch (command) {
        case StreamCommand::None:
            return;
        case StreamCommand::Read:
            EXPECT_FALSE(isReading || isRead || isUploading) << "one thing at a time";
            isReading = true;
            framesToRead = std::max(framesToRead, eachRead);
            read.push_back(streamer.coming());
            return;
        case StreamCommand::Upload:
            EXPECT_TRUE(isRead);
            isRead = false;
            isUploading = true;
            return;
        case StreamCommand::Drop:
            EXPECT_TRUE(isRead || isUploading);
            isRead = isUploading = false;
            ++dropped;
            return;
        case StreamCommand::Offer:
            EXPECT_TRUE(isUploading);
            return;
        }
    }
    void show() {
        isUploading = false;
        shown.push_back(read.back());
    }

    bool isReading = false, isRead = false, isUploading = false, fails = false, uploadFails = false;
    int framesToRead = 0, framesToUpload = 0, slices = 0;
    int eachRead = 0; ///< frames that each read takes
    std::size_t dropped = 0;
    std::vector<PartTarget> read, shown;
};

StreamEye eyeAt(double x, double y) {
    const Vec3 position{x, y, 0.0};
    return {position, world::blockAt(position)};
}

/// Metres from the south-west corner of kHome.
StreamEye eyeFromHome(double x, double y) {
    return eyeAt(kHome.x * world::kBlockSize + x, kHome.y * world::kBlockSize + y);
}

/// A streamer, the work that it commands, and the part that is shown.
struct Streamed {
    FakeWork tasks;
    Streamer streamer;
    PartTarget shown{kHome, kLoad};
    bool userIsReady = true; ///< an offered part is shown at once
    bool step(const StreamEye& eye, const world::LoadOptions& wanted = kLoad) {
        const StreamCommand command = streamer.step(shown, eye, wanted, tasks.progress());
        tasks.carryOut(command, streamer);
        if (command != StreamCommand::Offer || !userIsReady)
            return false;
        tasks.show();
        shown = streamer.coming();
        streamer.shown();
        return true;
    }
    /// Frames until something is shown, at most `most`.
    int framesUntilShown(const StreamEye& eye, int most = 100) {
        for (int i = 1; i <= most; ++i)
            if (step(eye))
                return i;
        return 0;
    }
};

TEST(Streamer, doesNothingWhileTheEyeIsAtHome) {
    Streamed s;
    for (const StreamEye& eye :
         {eyeFromHome(96, 96), eyeFromHome(0, 191), eyeFromHome(-23, 50), eyeFromHome(215, 215)})
        EXPECT_FALSE(s.step(eye));
    EXPECT_TRUE(s.tasks.read.empty());
    EXPECT_EQ(s.tasks.slices, 4) << "scenes that are no longer drawn are freed in each frame";
}

TEST(Streamer, readsUploadsAndShowsWhatIsAroundAnEyeThatHasLeft) {
    Streamed s;
    s.tasks.framesToRead = 5;
    s.tasks.framesToUpload = 7;
    const StreamEye eye = eyeFromHome(220, 96);
    const int frames = s.framesUntilShown(eye);
    EXPECT_GE(frames, 12);
    EXPECT_LE(frames, 16);
    ASSERT_EQ(s.tasks.read.size(), 1u);
    EXPECT_EQ(s.tasks.read[0], (PartTarget{{kHome.x + 1, kHome.y}, kLoad}));
    EXPECT_EQ(s.tasks.dropped, 0u);
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(s.step(eye));
    EXPECT_EQ(s.tasks.read.size(), 1u);
}

TEST(Streamer, readsNothingForWhoWalksToAndFroAlongABorder) {
    Streamed s;
    for (int i = 0; i < 200; ++i)
        s.step(eyeFromHome(192.0 + 20.0 * std::sin(i * 0.3), 96));
    EXPECT_TRUE(s.tasks.read.empty());
    EXPECT_GT(s.framesUntilShown(eyeFromHome(217, 96)), 0);
    for (int i = 0; i < 200; ++i)
        s.step(eyeFromHome(192.0 + 20.0 * std::sin(i * 0.3), 96));
    EXPECT_EQ(s.tasks.read.size(), 1u) << "the way back reads nothing either";
}

TEST(Streamer, dropsWhatIsReadForAnEyeThatHasGoneBack) {
    Streamed s;
    s.tasks.framesToRead = 3;
    s.step(eyeFromHome(220, 96));
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(s.step(eyeFromHome(10, 96)));
    EXPECT_EQ(s.tasks.dropped, 1u);
    EXPECT_EQ(s.tasks.read.size(), 1u);
    EXPECT_EQ(s.streamer.phase(), Streamer::Phase::Idle);
}

TEST(Streamer, aJumpBeyondAllThatIsLoadedIsFollowed) {
    Streamed s;
    s.tasks.framesToRead = 2;
    s.tasks.framesToUpload = 3;
    s.step(eyeFromHome(220, 96)); // a read has started
    const StreamEye far = eyeAt(20 * world::kBlockSize, 7 * world::kBlockSize);
    ASSERT_GT(s.framesUntilShown(far), 0);
    EXPECT_EQ(s.shown.centre, far.block);
    EXPECT_EQ(s.tasks.dropped, 1u);
}

TEST(Streamer, whoWaitsToGoFarAwayIsNotServedHalfTheWay) {
    Streamed s;
    s.tasks.framesToRead = 5;
    s.step(eyeFromHome(220, 96)); // a read of the next block has started
    StreamEye there = eyeFromHome(96 + 3 * world::kBlockSize, 96);
    there.isAway = true;
    s.tasks.eachRead = 2;
    ASSERT_GT(s.framesUntilShown(there), 0);
    EXPECT_EQ(s.shown.centre, there.block);
    ASSERT_EQ(s.tasks.shown.size(), 1u);
    EXPECT_EQ(s.tasks.dropped, 1u);
}

TEST(Streamer, itIsToldWhetherAPlaceHasFailed) {
    Streamed s;
    s.tasks.fails = true;
    StreamEye there = eyeFromHome(96 + 3 * world::kBlockSize, 96);
    there.isAway = true;
    EXPECT_FALSE(s.streamer.hasFailed({there.block, kLoad}));
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(s.step(there));
    EXPECT_TRUE(s.streamer.hasFailed({there.block, kLoad}));
    EXPECT_FALSE(s.streamer.hasFailed({kHome, kLoad}));
}

// Otherwise an eye that flies faster than parts load would never get a new part.
TEST(Streamer, showsWhatIsNearerThanWhatIsShownThoughTheEyeHasGoneOn) {
    Streamed s;
    s.tasks.eachRead = 20;
    std::size_t shown = 0;
    for (int frame = 0; frame < 400; ++frame) {
        shown += s.step(eyeFromHome(96.0 + 15.0 * frame, 96)) ? 1 : 0; // 900 m a second
        if (frame > 60)
            EXPECT_LE(std::abs(s.shown.centre.x - eyeFromHome(96.0 + 15.0 * frame, 96).block.x), 6);
    }
    EXPECT_GE(shown, 10u);
}

TEST(Streamer, whatCannotBeLoadedIsToldOnceAndTheRestGoesOn) {
    Streamed s;
    s.tasks.fails = true;
    const StreamEye beyond = eyeFromHome(220, 96);
    for (int i = 0; i < 20; ++i)
        EXPECT_FALSE(s.step(beyond));
    EXPECT_EQ(s.tasks.read.size(), 1u) << "a failed part is not tried again";
    EXPECT_NE(s.streamer.takeFault(), "");
    EXPECT_EQ(s.streamer.takeFault(), "") << "a failure is reported once";
    s.tasks.fails = false;
    EXPECT_GT(s.framesUntilShown(eyeFromHome(220 + 192, 96)), 0) << "the next block";
    EXPECT_GT(s.framesUntilShown(beyond), 0) << "tried again, coming back";
}

TEST(Streamer, anUploadThatFailsIsToldAndLeavesWhatIsShown) {
    Streamed s;
    s.tasks.uploadFails = true;
    EXPECT_EQ(s.framesUntilShown(eyeFromHome(220, 96), 20), 0);
    EXPECT_NE(s.streamer.takeFault().find("out of memory"), std::string::npos);
    EXPECT_EQ(s.tasks.read.size(), 1u);
    EXPECT_EQ(s.tasks.dropped, 1u) << "the part is dropped";
}

TEST(Streamer, otherOptionsAreReadWhereTheEyeIs) {
    Streamed s;
    world::LoadOptions wide = kLoad;
    wide.radius = 6;
    s.tasks.framesToRead = 2;
    s.step(eyeFromHome(96, 96), wide);
    EXPECT_EQ(s.tasks.read.size(), 1u);
    wide.radius = 2; // meanwhile
    for (int i = 0; i < 20; ++i)
        s.step(eyeFromHome(96, 96), wide);
    EXPECT_EQ(s.shown, (PartTarget{kHome, wide}));
    EXPECT_EQ(s.tasks.dropped, 1u);
    EXPECT_EQ(s.tasks.shown.size(), 1u);
}

TEST(Streamer, whatSomebodyElseHasShownEndsWhatWasComing) {
    for (const int framesToRead : {0, 4}) {
        Streamed s;
        s.tasks.framesToRead = framesToRead;
        s.tasks.framesToUpload = 4;
        for (int i = 0; i < 3; ++i)
            s.step(eyeFromHome(220, 96));
        s.shown.centre = {50, 60}; // another caller has loaded a part
        const StreamEye there = eyeAt(50.5 * world::kBlockSize, 60.5 * world::kBlockSize);
        for (int i = 0; i < 20; ++i)
            EXPECT_FALSE(s.step(there));
        EXPECT_EQ(s.tasks.dropped, 1u);
        // Back again. The dropped part would fit, but it was staged as the successor of another scene.
        EXPECT_GT(s.framesUntilShown(eyeFromHome(220, 96)), 0);
        EXPECT_EQ(s.tasks.read.size(), 2u);
    }
}

TEST(Streamer, inADungeonThePositionSaysNothing) {
    Streamed s;
    StreamEye eye = eyeAt(5.0, 7.0); // a dungeon's cells can have any coordinates
    eye.block = kHome;
    EXPECT_FALSE(s.step(eye));
    EXPECT_TRUE(s.tasks.read.empty());
    eye.block = {7, 9};
    EXPECT_GT(s.framesUntilShown(eye), 0);
    EXPECT_EQ(s.shown.centre, (dat::BlockCoord{7, 9}));
}

TEST(Streamer, offersAPartUntilItsUserIsReady) {
    Streamed s;
    s.userIsReady = false;
    const StreamEye eye = eyeFromHome(220, 96);
    for (int i = 0; i < 20; ++i)
        EXPECT_FALSE(s.step(eye));
    EXPECT_EQ(s.streamer.phase(), Streamer::Phase::Uploading);
    EXPECT_EQ(s.tasks.dropped, 0u);
    s.userIsReady = true;
    EXPECT_EQ(s.framesUntilShown(eye), 1);
}

TEST(Streamer, dropsAnOfferedPartThatIsNotWantedAnyMore) {
    Streamed s;
    s.userIsReady = false;
    for (int i = 0; i < 10; ++i)
        s.step(eyeFromHome(220, 96));
    s.step(eyeFromHome(10, 96));
    EXPECT_EQ(s.tasks.dropped, 1u);
    EXPECT_EQ(s.streamer.phase(), Streamer::Phase::Idle);
}

// For all movements of the eye: each part that was read is shown or dropped once, and the part around an eye
// that stops is shown in the end.
RC_GTEST_PROP(Streamer, comesToRestAroundTheEye, ()) {
    Streamed s;
    Vec3 at(kHome.x * world::kBlockSize, kHome.y * world::kBlockSize, 0.0);
    const int frames = *rc::gen::inRange(0, 200);
    for (int i = 0; i < frames; ++i) {
        const double step = *rc::gen::element(0.1, 5.0, 60.0, 2000.0);
        at.x = std::clamp(at.x + step * *rc::gen::inRange(-2, 3), 0.0, 254.0 * world::kBlockSize);
        at.y = std::clamp(at.y + step * *rc::gen::inRange(-2, 3), 0.0, 254.0 * world::kBlockSize);
        s.tasks.framesToRead = std::max(s.tasks.framesToRead, *rc::gen::inRange(-5, 4));
        s.tasks.framesToUpload = std::max(s.tasks.framesToUpload, *rc::gen::inRange(-5, 4));
        s.step(eyeAt(at.x, at.y));
    }
    const StreamEye rest = eyeAt(at.x, at.y);
    for (int i = 0; i < 60; ++i)
        s.step(rest);
    RC_ASSERT(s.streamer.phase() == Streamer::Phase::Idle);
    RC_ASSERT(world::metresBeside(s.shown.centre, rest.position) <= Streamer::kLeash);
    RC_ASSERT(s.tasks.read.size() == s.tasks.shown.size() + s.tasks.dropped);
}

} // namespace
} // namespace limen::engine
