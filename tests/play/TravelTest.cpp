#include "gpu/device/NullDevice.h"
#include "placements/WorldDb.h"
#include "play/Play.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Demo.h"

#include <gtest/gtest.h>

// The key that uses doors goes through a travel portal of a world database.
namespace limen::play {
namespace {

/// Writes the built-in world with one travel portal on the lane, which leads to a cell of the inn.
void writeWorld(const std::filesystem::path& directory, const Vec3& portal, const world::Place& inn) {
    placements::Content content;
    placements::Template& of = content.templates[7];
    of.id = 7;
    of.type = static_cast<std::int32_t>(placements::TemplateType::Portal);
    of.name = "Portal to the inn";
    of.setup = 0x02000150;
    const auto spotAt = [](const Vec3& at, dat::RecordId cell) {
        const dat::BlockCoord block = cell != 0 ? dat::blockOf(cell) : world::blockAt(at);
        const auto landblock = static_cast<std::uint32_t>(block.x << 24 | block.y << 16);
        const Vec3 local = at - Vec3(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        return placements::Spot{
            cell != 0 ? cell : landblock,
            {static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)},
            {1.0f, 0.0f, 0.0f, 0.0f}};
    };
    of.destination = spotAt(inn.eye - Vec3(0.0, 0.0, engine::kEyeHeight), inn.cell);
    const placements::Spot spot = spotAt(portal, 0);
    content.landblocks[placements::landblockOf(spot)].placements.push_back({0x7A9B4001, 7, spot, false});
    EXPECT_TRUE(placements::writeWorldDb(directory / placements::kWorldDbName, content, {"test", "now"}));
}

TEST(TravelPortal, leadsToItsDestinationWhenItIsUsed) {
    const test::TemporaryDirectory directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    const Result<world::WorldFile> file = world::loadWorldFile(directory.path());
    ASSERT_TRUE(file);
    const auto placeOf = [&](const char* name) {
        return *std::find_if(file->places.begin(), file->places.end(),
                             [&](const world::Place& place) { return place.name == name; });
    };
    const world::Place lane = placeOf("lane"), inn = placeOf("inn.hall");
    writeWorld(directory.path(), lane.eye + Vec3(2.0, 0.1, -1.0), inn);

    Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
    ASSERT_TRUE(source) << source.error().message();
    gpu::NullDevice device;
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), {}, device);
    engine::ViewRequest view = engine::requestAt(lane);
    view.yaw = 90.0;
    view.pitch = 0.0;
    view.size = {64, 36};
    ASSERT_TRUE(session.load(engine::centreOf(view)));
    ASSERT_EQ(session.part().world.placed.size(), 1u);
    Result<engine::FrameRequest> start =
        engine::frameRequest(session.part().world, session.source().file, view);
    ASSERT_TRUE(start);
    Play play(session, *start);
    PlayInput input;
    input.size = {64, 36};
    input.seconds = 0.02;
    input.acts = {{PlayActKind::Use, 0.0, 0.0}};
    ASSERT_TRUE(play.step(input));
    EXPECT_LT(glm::length(play.request().camera.eye - inn.eye), 0.01);
    EXPECT_EQ(engine::cellOf(session.part().world, play.request().root), inn.cell);
    EXPECT_NEAR(play.request().camera.heading.yaw, 0.0, 1e-6) << "the direction of the destination";
}

TEST(TravelPortal, isNotUsedFromAfar) {
    const test::TemporaryDirectory directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    const Result<world::WorldFile> file = world::loadWorldFile(directory.path());
    ASSERT_TRUE(file);
    const world::Place lane = *std::find_if(file->places.begin(), file->places.end(),
                                            [](const world::Place& place) { return place.name == "lane"; });
    writeWorld(directory.path(), lane.eye + Vec3(5.0, 0.0, -1.0), lane);
    Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
    ASSERT_TRUE(source);
    gpu::NullDevice device;
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), {}, device);
    engine::ViewRequest view = engine::requestAt(lane);
    view.yaw = 90.0;
    view.size = {64, 36};
    ASSERT_TRUE(session.load(engine::centreOf(view)));
    Result<engine::FrameRequest> start =
        engine::frameRequest(session.part().world, session.source().file, view);
    ASSERT_TRUE(start);
    Play play(session, *start);
    PlayInput input;
    input.size = {64, 36};
    input.acts = {{PlayActKind::Use, 0.0, 0.0}};
    ASSERT_TRUE(play.step(input));
    EXPECT_LT(glm::length(play.request().camera.eye - lane.eye), 0.01);
}

} // namespace
} // namespace limen::play
