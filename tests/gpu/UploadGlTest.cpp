// Hard case 21 of docs/cases.md: a failed upload is reported once and leaves the old scene unchanged, and the
// next upload is complete. Several renderers on one device draw their own scenes.
#include "FailingDevice.h"
#include "GlFixture.h"
#include "gpu/device/NullDevice.h"

namespace limen::gpu::test {
namespace {

using UploadGl = GlTest;

constexpr std::uint32_t kForGood = 1000;

/// A wall with a picture before another without one.
void buildScene(SceneBuilder& scene, std::uint32_t id, std::uint8_t shade) {
    scene.root(0);
    std::vector<std::uint8_t> small(2 * 2 * 4, shade), large(8 * 4 * 4, static_cast<std::uint8_t>(shade / 2));
    const auto first = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(2, 2, small));
    const auto second = scene.addMaterial({1, 1, 1, 1}, scene.addTexture(8, 4, large));
    scene.addWall(id, {-2, -2}, {2, 0.5f}, 4, {.material = first});
    scene.addWall(id + 1, {-2, -0.5f}, {2, 2}, 5, {.material = second});
}

TEST_F(UploadGl, case21_aFailedUploadLeavesTheOldSceneAndTheNextOneIsComplete) {
    FailingDevice failing(*device_);
    Renderer renderer(failing, {.textures = {.mode = TextureMode::ArrayPages}});
    SceneBuilder before, after;
    buildScene(before, 'A', 200);
    buildScene(after, 'P', 90);
    const Frame expected = render(after);
    ASSERT_TRUE(renderer.upload(before.upload));
    const Frame old = renderWith(renderer, before.finish(), 8, 8);
    for (const std::uint32_t made : {0u, 1u, 2u, 3u, 9u, 10u, 16u}) { // pages, buffers, their texels
        failing.madeBeforeFailure = made;
        failing.failures = kForGood;
        const Result<void> failed = renderer.upload(after.upload);
        failing.madeBeforeFailure.reset();
        ASSERT_FALSE(failed) << "after " << made;
        EXPECT_EQ(failed.error().what, "out of memory");
        const Frame still = renderWith(renderer, before.finish(), 8, 8);
        EXPECT_EQ(still.ids, old.ids);
        EXPECT_EQ(still.colour, old.colour);
        EXPECT_EQ(still.depth, old.depth);
    }
    ASSERT_TRUE(renderer.upload(after.upload)) << "nothing is left of the failures";
    const Frame now = renderWith(renderer, after.finish(), 8, 8);
    EXPECT_EQ(now.ids, expected.ids);
    EXPECT_EQ(now.colour, expected.colour);
    EXPECT_EQ(now.depth, expected.depth);
    EXPECT_NE(now.colour, old.colour);
}

// A few failures are temporary and are not reported.
TEST(Upload, isRetriedAFewTimes) {
    NullDevice device;
    FailingDevice failing(device);
    Renderer renderer(failing, {.textures = {.mode = TextureMode::ArrayPages}});
    SceneBuilder scene;
    buildScene(scene, 'A', 200);
    failing.madeBeforeFailure = 5;
    failing.failures = 2;
    EXPECT_TRUE(renderer.upload(scene.upload));
    EXPECT_FALSE(failing.madeBeforeFailure.has_value()) << "it did fail";
    failing.madeBeforeFailure = 5;
    failing.failures = kForGood;
    EXPECT_FALSE(renderer.upload(scene.upload));
    EXPECT_EQ(failing.failures, kForGood - 3);
}

TEST_F(UploadGl, framesAreDrawnUnculledWithoutMemory_andRetryThreeTimes) {
    FailingDevice failing(*device_);
    Renderer renderer(failing), other(*device_);
    SceneBuilder scene;
    buildScene(scene, 'A', 200);
    ASSERT_TRUE(renderer.upload(scene.upload));
    ASSERT_TRUE(other.upload(scene.upload));
    scene.finish();
    const Frame expected = renderWith(other, scene.plan, 8, 8);
    EXPECT_EQ(other.report().trouble, "");
    failing.scratchFailures = kForGood;
    for (std::uint32_t asked : {1u, 2u, 3u, 3u, 3u}) {
        const Frame frame = renderWith(renderer, scene.plan, 8, 8);
        EXPECT_EQ(failing.scratchRequests, asked);
        EXPECT_EQ(frame.ids, expected.ids);
        EXPECT_EQ(frame.colour, expected.colour);
        EXPECT_EQ(frame.depth, expected.depth);
        EXPECT_NE(renderer.report().trouble.find("out of memory"), std::string::npos);
    }
}

TEST_F(UploadGl, frameReportsADeviceReset) {
    FailingDevice failing(*device_);
    Renderer renderer(failing);
    SceneBuilder scene;
    buildScene(scene, 'A', 200);
    ASSERT_TRUE(renderer.upload(scene.upload));
    Result<RenderTarget> target = RenderTarget::create(failing, 8, 8);
    ASSERT_TRUE(target);
    failing.isReset = true;
    const Result<void> drawn = renderer.render(scene.finish(), *target);
    ASSERT_FALSE(drawn);
    EXPECT_EQ(drawn.error().message(), "a driver: was reset");
}

TEST_F(UploadGl, missingMemoryIsAnErrorThatNamesTheObject) {
    constexpr std::size_t kTooMuch = std::size_t{1} << 50;
    const Result<BufferHandle> buffer = device_->createScratch("too much", kTooMuch);
    ASSERT_FALSE(buffer);
    EXPECT_EQ(buffer.error().code, ErrorCode::Driver);
    EXPECT_NE(buffer.error().message().find(device_->capabilities().renderer), std::string::npos);
    EXPECT_NE(buffer.error().message().find("too much"), std::string::npos);
    debug_->clear(); // the driver reported it as well
    EXPECT_TRUE(device_->createScratch("little", 64)) << "later frames are drawn";
}

TEST(DeviceLoss, messageNamesTheCause) {
    EXPECT_NE(lossMessage(GL_GUILTY_CONTEXT_RESET).find("a command of this program"), std::string::npos);
    EXPECT_NE(lossMessage(GL_INNOCENT_CONTEXT_RESET).find("another program"), std::string::npos);
    EXPECT_NE(lossMessage(GL_NO_ERROR).find("unknown reason"), std::string::npos);
}

TEST_F(UploadGl, twoRenderersOnOneDeviceDrawTheirOwnScenesInTurns) {
    Renderer first(*device_), second(*device_);
    SceneBuilder one, other;
    one.root(0);
    one.addWall('A', {-2, -2}, {2, 0.5f}, 4);
    other.root(0);
    other.addWall('P', {-1, -1}, {1, 1}, 1);
    other.addWall('Q', {-3, -3}, {3, 3}, 3);
    ASSERT_TRUE(first.upload(one.upload));
    const Frame alone = renderWith(first, one.finish(), 8, 8);
    ASSERT_TRUE(second.upload(other.upload));
    const Frame otherAlone = renderWith(second, other.finish(), 8, 8);
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_EQ(renderWith(first, one.plan, 8, 8).ids, alone.ids);
        EXPECT_EQ(renderWith(second, other.plan, 8, 8).ids, otherAlone.ids);
    }
    EXPECT_NE(alone.ids, otherAlone.ids);
}

TEST(Upload, case21_aFailureLeavesNothingBehindOnTheDevice) {
    NullDevice device;
    FailingDevice failing(device);
    Renderer renderer(failing, {.textures = {.mode = TextureMode::ArrayPages}});
    SceneBuilder scene;
    buildScene(scene, 'A', 200);
    ASSERT_TRUE(renderer.upload(scene.upload));
    const std::size_t objects = device.liveObjects();
    for (const std::uint32_t made : {0u, 1u, 2u, 3u, 9u, 10u, 16u}) { // pages, buffers, their texels
        failing.madeBeforeFailure = made;
        failing.failures = kForGood;
        EXPECT_FALSE(renderer.upload(scene.upload));
        failing.madeBeforeFailure.reset();
        EXPECT_EQ(device.liveObjects(), objects);
    }
    EXPECT_TRUE(renderer.upload(scene.upload));
    EXPECT_EQ(device.liveObjects(), objects);
}

} // namespace
} // namespace limen::gpu::test
