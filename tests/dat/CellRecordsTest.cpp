#include "dat/Hex.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limen::dat {
namespace {

// The cell with the values of the format page.
const std::string kQuotedCell = R"(
    02 01 02 00  01 00 00 00  02 01 02 00                        # id, seen outside, id again
    06 03 02 00                                                  # surfaces, portals, visible cells
    0C 01 0D 01 0E 01 34 00 0F 01 0C 01                          # surfaces
    E6 02  02 00                                                 # environment, structure
    00 00 00 00  00 00 20 C2  00 00 40 C1                        # origin 0 -40 -12
    F5 04 35 BF  00 00 00 00  00 00 00 00  F5 04 35 BF           # w, x, y, z
    02 00 03 00 04 01 03 00                                      # portals
    03 00 04 00 01 01 01 00
    01 00 05 00 03 01 02 00
    03 01 04 01                                                  # visible cells
)";

TEST(EnvCellCodec, readsTheQuotedCell) {
    const Bytes bytes = hex(kQuotedCell);
    const auto c = decode<EnvCell>(0x00020102, bytes);
    ASSERT_TRUE(c) << c.error().message();
    EXPECT_EQ(c->environment, 0x2E6);
    EXPECT_EQ(c->cellStructure, 2);
    EXPECT_EQ(c->surfaces, (std::vector<std::uint16_t>{0x10C, 0x10D, 0x10E, 0x34, 0x10F, 0x10C}));
    EXPECT_EQ(c->position.origin, Vec3f(0.0f, -40.0f, -12.0f));
    EXPECT_NEAR(c->position.orientation.w, -0.707107f, 1e-6f);
    EXPECT_NEAR(c->position.orientation.z, -0.707107f, 1e-6f);
    ASSERT_EQ(c->portals.size(), 3u);
    EXPECT_EQ(c->portals[0].flags, CellPortal::kPortalSide);
    EXPECT_EQ(c->portals[1].polygonId, 4);
    EXPECT_EQ(c->portals[2].otherCellId, 0x103);
    EXPECT_EQ(c->portals[2].otherPortalId, 2);
    EXPECT_EQ(c->visibleCells, (std::vector<std::uint16_t>{0x103, 0x104}));
    EXPECT_EQ(*encode(*c), bytes);
}

TEST(EnvCellCodec, staticsAndRestrictionFollowTheFlags) {
    const Bytes bytes = hex(R"(
        00 01 B1 9A  0A 00 00 00  00 01 B1 9A  00 00 00 00  01 00  00 00
        00 00 00 00 00 00 00 00 00 00 00 00  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        01 00 00 00  01 00 00 02  00 00 80 3F 00 00 00 40 00 00 40 40  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        78 56 34 12
    )");
    const auto c = decode<EnvCell>(0x9AB10100, bytes);
    ASSERT_TRUE(c) << c.error().message();
    ASSERT_EQ(c->statics.size(), 1u);
    EXPECT_EQ(c->statics[0].model, 0x02000001u);
    EXPECT_EQ(c->statics[0].frame.origin, Vec3f(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(c->restriction, 0x12345678u);
    EXPECT_EQ(*encode(*c), bytes);
}

TEST(EnvCellCodec, refusesASecondIdThatDiffers) {
    Bytes bytes = hex(kQuotedCell);
    bytes[8] = std::byte{3};
    const auto c = decode<EnvCell>(0x00020102, bytes);
    ASSERT_FALSE(c);
    EXPECT_EQ(c.error().message(), "record 0x00020102, offset 0x8: the record repeats its id as 0x00020103");
}

// The landblock with some values of the format page; others are zero.
TEST(LandBlockCodec, readsTerrainColumnsFromWestToEast) {
    Bytes bytes = hex("FF FF B1 9A  00 00 00 00");
    bytes.resize(252);
    const auto put = [&](std::size_t at, int value) { bytes[at] = static_cast<std::byte>(value); };
    put(8, 0x34), put(9, 0x48);     // type 0x0D, scenery 9
    put(10, 0x24), put(11, 0x68);   // type 9, scenery 13
    put(168, 0x34), put(169, 0x58); // index 80: type 0x0D, scenery 11
    put(170, 120), put(171, 139), put(210, 93), put(249, 93), put(250, 110);
    put(251, 0xCD);
    const auto b = decode<LandBlock>(0x9AB1FFFF, bytes);
    ASSERT_TRUE(b) << b.error().message();
    EXPECT_EQ(b->hasObjects, 0u);
    EXPECT_EQ((b->terrain[0] >> 2) & 31, 0x0D);
    EXPECT_EQ(b->terrain[0] >> 11, 9);
    EXPECT_EQ((b->terrain[1] >> 2) & 31, 9);
    EXPECT_EQ(b->terrain[1] >> 11, 13);
    EXPECT_EQ((b->terrain[80] >> 2) & 31, 0x0D);
    EXPECT_EQ(b->terrain[80] >> 11, 11);
    EXPECT_EQ(b->terrain[80] & 3, 0);
    EXPECT_EQ(b->heights[0], 120);
    EXPECT_EQ(b->heights[1], 139);
    EXPECT_EQ(b->heights[40], 93);
    EXPECT_EQ(b->heights[79], 93);
    EXPECT_EQ(b->heights[80], 110);
    EXPECT_EQ(b->padding, 0xCD);
    EXPECT_EQ(*encode(*b), bytes);
}

// The building with the values of the format page; five stabs need two bytes of padding.
const std::string kQuotedInfo = R"(
    FE FF 55 14  05 00 00 00
    00 00 00 00                                                  # no objects
    01 00  00 00                                                 # one building, no restrictions
    A9 11 00 01  C5 00 2E 43  6F 12 8D 41  00 00 8C 42           # model, origin
    16 15 C9 3E  00 00 00 00  00 00 00 00  2F 6E 6B BF           # w .. z
    7F 00 00 00  01 00 00 00                                     # leaves, portals
    03 00 04 01 01 00  05 00  00 01 01 01 02 01 03 01 04 01      # flags, cell, portal, stabs
)";

TEST(LandBlockInfoCodec, readsTheQuotedBuilding) {
    const Bytes bytes = hex(kQuotedInfo + "00 00");
    ASSERT_EQ(bytes.size() % 4, 0u);
    const auto info = decode<LandBlockInfo>(0x1455FFFE, bytes);
    ASSERT_TRUE(info) << info.error().message();
    EXPECT_EQ(info->numCells, 5u);
    ASSERT_EQ(info->buildings.size(), 1u);
    const Building& b = info->buildings[0];
    EXPECT_EQ(b.model, 0x010011A9u);
    EXPECT_EQ(b.numLeaves, 127u);
    EXPECT_NEAR(b.frame.origin.x, 174.003f, 1e-3f);
    EXPECT_NEAR(b.frame.origin.y, 17.634f, 1e-3f);
    EXPECT_EQ(b.frame.origin.z, 70.0f);
    EXPECT_NEAR(b.frame.orientation.w, 0.392739f, 1e-5f);
    EXPECT_NEAR(b.frame.orientation.z, -0.91965f, 1e-5f);
    ASSERT_EQ(b.portals.size(), 1u);
    EXPECT_EQ(b.portals[0].flags, CellPortal::kExactMatch | CellPortal::kPortalSide);
    EXPECT_EQ(b.portals[0].otherCellId, 0x104);
    EXPECT_EQ(b.portals[0].otherPortalId, 1);
    EXPECT_EQ(b.portals[0].stabs, (std::vector<std::uint16_t>{0x100, 0x101, 0x102, 0x103, 0x104}));
    EXPECT_EQ(*encode(*info), bytes);
}

TEST(LandBlockInfoCodec, keepsWhatThePaddingHolds) {
    const Bytes bytes = hex(kQuotedInfo + "CD AB");
    const auto info = decode<LandBlockInfo>(0x1455FFFE, bytes);
    ASSERT_TRUE(info) << info.error().message();
    EXPECT_EQ(*encode(*info), bytes);
}

TEST(LandBlockInfoCodec, readsObjectsAndRestrictions) {
    const Bytes bytes = hex(R"(
        FE FF 00 00  00 00 00 00
        01 00 00 00  05 00 00 01  00 00 80 3F 00 00 00 40 00 00 40 40  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00
        00 00  01 00
        01 00  08 00  00 01 00 00  21 43 65 87
    )");
    const auto info = decode<LandBlockInfo>(0x0000FFFE, bytes);
    ASSERT_TRUE(info) << info.error().message();
    EXPECT_EQ(info->objects.at(0).model, 0x01000005u);
    EXPECT_EQ(info->restrictionBuckets, 8);
    EXPECT_EQ(info->restrictions.at(0), (std::pair<std::uint32_t, std::uint32_t>{0x100, 0x87654321}));
    EXPECT_EQ(*encode(*info), bytes);
}

} // namespace
} // namespace limen::dat
