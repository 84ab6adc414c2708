#include "gpu/device/NullDevice.h"
#include "placements/WorldDb.h"
#include "play/Play.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Demo.h"

#include <algorithm>
#include <gtest/gtest.h>

// The key that opens doors, at a chest of a world database that is locked or not.
namespace limen::play {
namespace {

/// A player on the lane of the built-in world, before a chest whose lid is a door leaf.
class ChestOnTheLane {
public:
    explicit ChestOnTheLane(bool isLocked) {
        EXPECT_TRUE(worlds::writeBuiltInWorld(directory_.path()));
        const Result<world::WorldFile> file = world::loadWorldFile(directory_.path());
        const world::Place lane =
            *std::find_if(file->places.begin(), file->places.end(),
                          [](const world::Place& place) { return place.name == "lane"; });
        writeChest(*file, lane.eye + Vec3(1.5, 0.1, -engine::kEyeHeight), isLocked);
        Result<engine::WorldSource> source = engine::openWorldSource(directory_.path().string());
        session_.emplace(std::make_shared<const engine::WorldSource>(std::move(*source)),
                         engine::SessionOptions(), device_);
        engine::ViewRequest view = engine::requestAt(lane);
        view.yaw = 90.0;
        view.pitch = -20.0;
        view.size = {64, 36};
        EXPECT_TRUE(session_->load(engine::centreOf(view)));
        const Result<engine::FrameRequest> start =
            engine::frameRequest(session_->part().world, session_->source().file, view);
        play_.emplace(*session_, *start);
        step(0.02, {PlayActKind::Walk});
    }

    void step(double seconds, std::vector<PlayActKind> acts = {}) {
        PlayInput input;
        input.size = {64, 36};
        input.seconds = seconds;
        for (const PlayActKind act : acts)
            input.acts.push_back({act, 0.0, 0.0});
        ASSERT_TRUE(play_->step(input));
        ASSERT_TRUE(session_->draw(play_->request(), {}));
    }
    [[nodiscard]] const Play& play() const { return *play_; }
    [[nodiscard]] double openness() const {
        const std::optional<std::size_t> chest = play_->doorInReach();
        return chest ? play_->request().scene.eachDoor.at(*chest) : -1.0;
    }

private:
    void writeChest(const world::WorldFile& file, const Vec3& at, bool isLocked) {
        const auto door = std::find_if(
            file.moving.doors.begin(), file.moving.doors.end(), [](const world::DoorEntry& each) {
                return !each.leaves.empty() && each.leaves.front().motionTable != 0;
            });
        ASSERT_NE(door, file.moving.doors.end());
        placements::Content content;
        placements::Template& of = content.templates[7];
        of.id = 7;
        of.type = static_cast<std::int32_t>(placements::TemplateType::Chest);
        of.name = "Chest";
        of.setup = door->leaves.front().model;
        of.motionTable = door->leaves.front().motionTable;
        of.locked = isLocked;
        const dat::BlockCoord block = world::blockAt(at);
        const auto landblock = static_cast<std::uint32_t>(block.x << 24 | block.y << 16);
        const Vec3 local = at - Vec3(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        content.landblocks[landblock >> 16].placements.push_back(
            {0x7A9B4001,
             7,
             {landblock,
              {static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)},
              {1.0f, 0.0f, 0.0f, 0.0f}},
             false});
        EXPECT_TRUE(
            placements::writeWorldDb(directory_.path() / placements::kWorldDbName, content, {"test", "now"}));
    }

    test::TemporaryDirectory directory_;
    gpu::NullDevice device_;
    std::optional<engine::Session> session_;
    std::optional<Play> play_;
};

TEST(ChestInReach, opensWhenItIsUsed) {
    ChestOnTheLane f(false);
    EXPECT_EQ(f.openness(), 0.0);
    f.step(0.02, {PlayActKind::Use});
    EXPECT_FALSE(f.play().isRefused());
    for (int i = 0; i < 100; ++i)
        f.step(0.1);
    EXPECT_EQ(f.openness(), 1.0);
}

TEST(ChestInReach, staysShutWhenItIsLocked_andSaysSoForTwoSeconds) {
    ChestOnTheLane f(true);
    EXPECT_FALSE(f.play().isRefused());
    f.step(0.02, {PlayActKind::Use});
    EXPECT_TRUE(f.play().isRefused());
    for (int i = 0; i < 19; ++i)
        f.step(0.1);
    EXPECT_TRUE(f.play().isRefused());
    f.step(0.2);
    EXPECT_FALSE(f.play().isRefused());
    EXPECT_EQ(f.openness(), 0.0);
}

} // namespace
} // namespace limen::play
