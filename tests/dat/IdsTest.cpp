#include "dat/Ids.h"

#include <gtest/gtest.h>

namespace limen::dat {
namespace {

TEST(KindOf, portalIdsFollowTheirRanges) {
    const auto kind = [](RecordId id) { return kindOf(FileRole::Portal, id); };
    EXPECT_EQ(kind(0x01000000), RecordKind::GfxObj);
    EXPECT_EQ(kind(0x0100FFFF), RecordKind::GfxObj);
    EXPECT_EQ(kind(0x01010000), RecordKind::Other);
    EXPECT_EQ(kind(0x02000001), RecordKind::Setup);
    EXPECT_EQ(kind(0x03000001), RecordKind::Animation);
    EXPECT_EQ(kind(0x09000001), RecordKind::MotionTable);
    EXPECT_EQ(kind(0x0A000001), RecordKind::Other) << "sounds are not decoded";
    EXPECT_EQ(kind(0x0F00FFFF), RecordKind::PaletteSet);
    EXPECT_EQ(kind(0x10000001), RecordKind::ClothingTable);
    EXPECT_EQ(kind(0x11000001), RecordKind::DegradeInfo);
    EXPECT_EQ(kind(0x32000001), RecordKind::ParticleEmitter);
    EXPECT_EQ(kind(0x33000001), RecordKind::PhysicsScript);
    EXPECT_EQ(kind(0x34000001), RecordKind::PhysicsScriptTable);
    EXPECT_EQ(kind(0x04000001), RecordKind::Palette);
    EXPECT_EQ(kind(0x05FFFFFF), RecordKind::SurfaceTexture);
    EXPECT_EQ(kind(0x06000000), RecordKind::RenderSurface);
    EXPECT_EQ(kind(0x07FFFFFF), RecordKind::RenderSurface);
    EXPECT_EQ(kind(0x08000DCB), RecordKind::Surface);
    EXPECT_EQ(kind(0x0D0002E6), RecordKind::Environment);
    EXPECT_EQ(kind(0x12000001), RecordKind::Scene);
    EXPECT_EQ(kind(kRegionId), RecordKind::Region);
    EXPECT_EQ(kind(kIterationId), RecordKind::Iteration);
    EXPECT_EQ(kind(0), RecordKind::Other);
}

TEST(KindOf, cellIdsFollowTheirLowWord) {
    const auto kind = [](RecordId id) { return kindOf(FileRole::Cell, id); };
    EXPECT_EQ(kind(0x9AB1FFFF), RecordKind::LandBlock);
    EXPECT_EQ(kind(0x9AB1FFFE), RecordKind::LandBlockInfo);
    EXPECT_EQ(kind(0x9AB1FFFD), RecordKind::EnvCell);
    EXPECT_EQ(kind(0x9AB10100), RecordKind::EnvCell);
    EXPECT_EQ(kind(0x9AB100FF), RecordKind::Other);
    EXPECT_EQ(kind(0x9AB10001), RecordKind::Other);
    EXPECT_EQ(kind(0x01000100), RecordKind::EnvCell);
    EXPECT_EQ(kind(kIterationId), RecordKind::Iteration);
}

TEST(KindOf, highresReadsLikePortalAndLocalHoldsNothingKnown) {
    EXPECT_EQ(kindOf(FileRole::Highres, 0x06001234), RecordKind::RenderSurface);
    EXPECT_EQ(kindOf(FileRole::Local, 0x06001234), RecordKind::Other);
    EXPECT_EQ(kindOf(FileRole::Local, kIterationId), RecordKind::Iteration);
}

TEST(NameOf, isTheTypesName) {
    EXPECT_STREQ(nameOf(RecordKind::LandBlockInfo), "LandBlockInfo");
    EXPECT_STREQ(nameOf(RecordKind::Other), "Other");
}

TEST(BlockCoord, goesToIdsAndBack) {
    const BlockCoord corner{0xFE, 0xFE};
    EXPECT_EQ(landBlockId(corner), 0xFEFEFFFFu);
    EXPECT_EQ(landBlockInfoId({0x14, 0x55}), 0x1455FFFEu);
    EXPECT_EQ(blockOf(0xFEFE0100u), corner);
}

} // namespace
} // namespace limen::dat
