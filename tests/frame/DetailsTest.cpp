#include "PlannedWorld.h"

#include "frame/DrawRecords.h"
#include "frame/SceneBuilder.h"

#include <gtest/gtest.h>

namespace limen::test {
namespace {

namespace gpu = frame::gpu;
using frame::FramePlan;

/// Two rooms, and a Region whose first rows name detail pictures.
struct GrainedRooms {
    static constexpr std::uint32_t kLand = 0x05000003, kExteriors = 0x05000004, kShells = 0x05000005;
    Rooms rooms;
    GrainedRooms() {
        auto& rows = rooms.world.region().texMerge.textures;
        const std::array pictures{kLand, kExteriors, kShells, 0x05000002u};
        for (std::size_t row = 0; row < pictures.size(); ++row) {
            rows.at(row).terrainType = 31 - static_cast<std::uint32_t>(row); // of no importance
            rows.at(row).detailTexture = pictures[row];
            rows.at(row).detailTiling = static_cast<std::uint32_t>(row) + 2;
        }
    }
};

int redOf(const world::World& world, const world::DetailPicture& picture) {
    return world.textures.at(picture.texture)->rgba[0];
}

TEST(Details, areNamedByTheFirstThreeRowsOfTheRegion) {
    GrainedRooms source;
    const world::World world = loadTestWorld(source.rooms.world);
    EXPECT_EQ(redOf(world, world.details.land), 0xC0) << "the colour of 0x05000003";
    EXPECT_EQ(redOf(world, world.details.exteriors), 0x40);
    EXPECT_EQ(redOf(world, world.details.shells), 0x70);
    EXPECT_EQ(world.details.land.tiling, 2.0f);
    EXPECT_EQ(world.details.exteriors.tiling, 3.0f);
    EXPECT_EQ(world.details.shells.tiling, 4.0f);
}

TEST(Details, areNoneWithoutPicturesOrRepeats) {
    GrainedRooms source;
    auto& rows = source.rooms.world.region().texMerge.textures;
    rows[0].detailTexture = 0;
    rows[1].detailTiling = 0;
    rows.resize(2);
    EXPECT_EQ(loadTestWorld(source.rooms.world).details, world::Details{});
}

TEST(Details, ofWallsAreOffByTheReading) {
    GrainedRooms source;
    world::LoadOptions options;
    options.readings.details = world::DetailPictures::Off;
    const world::Details on = loadTestWorld(source.rooms.world).details,
                         off = loadTestWorld(source.rooms.world, options).details;
    EXPECT_EQ(off.land, on.land) << "the option concerns walls";
    EXPECT_NE(on.exteriors, world::DetailPicture{});
    EXPECT_EQ(off.exteriors, world::DetailPicture{});
    EXPECT_EQ(off.shells, world::DetailPicture{});
}

TEST(Details, areTexturesOfTheUploadThatRepeat) {
    GrainedRooms source;
    const world::World world = loadTestWorld(source.rooms.world);
    const frame::SceneUpload upload = frame::buildScene(frame::StaticScene(world));
    EXPECT_EQ(upload.details.land, world.details.land.texture);
    EXPECT_EQ(upload.details.exteriors, world.details.exteriors.texture);
    EXPECT_EQ(upload.details.shells, world.details.shells.texture);
    for (const std::uint32_t texture : {upload.details.land, upload.details.exteriors, upload.details.shells})
        EXPECT_FALSE(upload.textures.at(texture).clamp);
}

TEST(Planner, placesTheGrainOfTheGroundInTheEnhancedLookOnly) {
    GrainedRooms source;
    PlannedWorld planned(source.rooms.world);
    planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside);
    for (const auto& [look, land] : {std::pair{world::Look::Retail, 0.0f}, {world::Look::Enhanced, 2.0f}}) {
        planned.view.look = look;
        planned.planner.plan(planned.view, {}, planned.visible, planned.plan);
        EXPECT_EQ(planned.plan.constants.detailTiling, gpu::vec4(land, 3, 4, 0));
        EXPECT_EQ(planned.plan.constants.detailTextures.z, planned.world.details.shells.texture);
        EXPECT_EQ((planned.plan.constants.flags & gpu::kFramePixelLamps) != 0, look == world::Look::Enhanced);
    }
}

TEST(DrawRecords, nameTheDetailPictureOfTheirInstance) {
    GrainedRooms source;
    PlannedWorld planned(source.rooms.world);
    const frame::RecordTables tables = frame::tablesOf(frame::buildScene(planned.scene));
    const FramePlan& plan = planned.planFrom({92, 125, 1.6}, 180.0, world::kOutside);
    const frame::DrawRecords records(tables, plan, {});
    for (std::uint32_t i = 0; i < planned.world.instances.size(); ++i) {
        const world::InstanceKind kind = planned.world.instances[i].kind;
        const std::uint32_t expected = kind == world::InstanceKind::Shell      ? gpu::kDetailOfShells
                                       : kind == world::InstanceKind::Exterior ? gpu::kDetailOfExteriors
                                       : kind == world::InstanceKind::Terrain  ? gpu::kDetailOfLand
                                                                               : gpu::kNoDetail;
        EXPECT_EQ(records.of(i).members.w >> gpu::kRecordDetail, expected) << i;
    }
}

} // namespace
} // namespace limen::test
