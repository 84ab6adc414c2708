#include "dat/Hex.h"

#include <gtest/gtest.h>

namespace limen::dat {
namespace {

// One triangle: three vertices, the last without uvs.
const std::string kVertices = R"(
    01 00 00 00  03 00 00 00                                    # type, count
    00 00  01 00  00 00 00 00 00 00 00 00 00 00 00 00           # key 0, one uv, position 0 0 0
                  00 00 00 00 00 00 00 00 00 00 80 3F           # normal 0 0 1
                  00 00 00 3F 00 00 80 3E                       # uv 0.5 0.25
    01 00  02 00  00 00 80 3F 00 00 00 00 00 00 00 00           # key 1, two uvs, position 1 0 0
                  00 00 00 00 00 00 00 00 00 00 80 3F
                  00 00 80 3F 00 00 00 00  00 00 00 00 00 00 80 3F
    07 00  00 00  00 00 00 00 00 00 00 40 00 00 00 00           # key 7, no uvs, position 0 2 0
                  00 00 00 00 00 00 00 00 00 00 80 3F
)";

TEST(GfxObjCodec, readsTheSmallestRecord) {
    const Bytes bytes = hex(R"(
        05 00 00 01  00 00 00 00  00                             # id, flags, no surfaces
        01 00 00 00  00 00 00 00                                 # no vertices
        00 00 80 3F  00 00 00 40  00 00 40 40                    # sort centre 1 2 3
    )");
    const auto g = decode<GfxObj>(0x01000005, bytes);
    ASSERT_TRUE(g) << g.error().message();
    EXPECT_EQ(g->sortCenter, Vec3f(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(*encode(*g), bytes);
}

TEST(GfxObjCodec, readsPolygonsAndBothTrees) {
    const Bytes bytes = hex(R"(
        05 00 00 01  0B 00 00 00  01  CB 0D 00 08                # id, flags 1|2|8, one surface
    )" + kVertices + R"(
        01  03 00  03 04  00 00 00 00  FF FF FF FF  00 00 01 00 07 00      # physics: polygon 3, no positive uvs
        46 41 45 4C  00 00 00 00  01 00 00 00                              # LEAF 0, solid
        00 00 00 00 00 00 00 00 00 00 00 00 00 00 80 3F                    # sphere, radius 1
        01 00 00 00  03 00                                                 # polygon 3
        00 00 00 00 00 00 00 00 00 00 00 00                                # sort centre
        01  03 00  03 00  02 00 00 00  00 00 01 00  00 00 01 00 07 00      # drawing: two surfaces
        00 01 00  00 00 00                                                 # its uvs, front and back
        54 52 4F 50  00 00 00 00 00 00 00 00 00 00 80 3F  00 00 80 BF      # PORT, plane z = 1
        46 41 45 4C  01 00 00 00                                           # positive LEAF 1
        46 41 45 4C  02 00 00 00                                           # negative LEAF 2
        00 00 00 00 00 00 00 00 00 00 00 00 00 00 80 3F                    # sphere
        01 00 00 00  01 00 00 00  03 00  05 00 01 00                       # polygon 3; polygon 5 is portal 1
        EF 00 00 11                                                        # degrade
    )");
    const auto g = decode<GfxObj>(0x01000005, bytes);
    ASSERT_TRUE(g) << g.error().message();
    ASSERT_EQ(g->vertexArray.vertices.size(), 3u);
    EXPECT_EQ(g->vertexArray.vertices[0].second.uvs[0], Vec2f(0.5f, 0.25f));
    EXPECT_EQ(g->vertexArray.vertices[1].second.uvs.size(), 2u);
    EXPECT_EQ(g->vertexArray.vertices[2].first, 7);
    EXPECT_EQ(g->vertexArray.vertices[2].second.position, Vec3f(0.0f, 2.0f, 0.0f));
    const Polygon& physics = g->physicsPolygons.at(0).second;
    EXPECT_EQ(physics.posSurface, -1);
    EXPECT_TRUE(physics.posUv.empty());
    EXPECT_EQ(g->physicsBsp.nodes.at(0).solid, 1);
    EXPECT_EQ(g->physicsBsp.nodes[0].sphere.radius, 1.0f);
    const Polygon& front = g->polygons.at(0).second;
    EXPECT_EQ(g->polygons[0].first, 3);
    EXPECT_EQ(front.vertexKeys, (SmallVec<std::uint16_t, 8>{0, 1, 7}));
    EXPECT_EQ(front.posUv, (SmallVec<std::uint8_t, 8>{0, 1, 0}));
    EXPECT_EQ(front.negUv, (SmallVec<std::uint8_t, 8>{0, 0, 0}));
    EXPECT_EQ(front.negSurface, 1);
    ASSERT_EQ(g->drawingBsp.nodes.size(), 3u);
    const BspNode& port = g->drawingBsp.nodes[0];
    EXPECT_EQ(port.tag, BspTag::Port);
    EXPECT_EQ(port.plane.d, -1.0f);
    EXPECT_EQ(port.positive, 1);
    EXPECT_EQ(port.negative, 2);
    EXPECT_EQ(port.portals[0].polygonId, 5);
    EXPECT_EQ(port.portals[0].portalIndex, 1);
    EXPECT_EQ(g->drawingBsp.nodes[2].leafIndex, 2);
    EXPECT_EQ(g->degradeId, 0x110000EFu);
    EXPECT_EQ(*encode(*g), bytes);
}

TEST(GfxObjCodec, refusesWhatIsNoMesh) {
    const auto vertexType = decode<GfxObj>(0x01000005, hex("05 00 00 01  00 00 00 00  00  02 00 00 00"));
    ASSERT_FALSE(vertexType);
    EXPECT_EQ(vertexType.error().message(),
              "record 0x01000005, offset 0x9: the vertex type is 2; only type 1 is known");
    const std::string empty =
        "05 00 00 01  02 00 00 00  00  01 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00";
    const auto twoCorners = decode<GfxObj>(
        0x01000005,
        hex(empty + "01  00 00  02 04 00 00 00 00 00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00"));
    ASSERT_FALSE(twoCorners);
    EXPECT_EQ(twoCorners.error().what, "a polygon has 2 vertices; it needs three");
}

TEST(GfxObjCodec, nodesOfUnknownTagsHaveNoChildren) {
    const std::string empty =
        "E8 05 00 01  02 00 00 00  00  01 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00";
    for (const char* tag : {"4C 4F 50 42", "4C 46 50 42", "58 58 50 42", "00 00 00 00"}) { // BPOL, BPFL, BPXX
        const Bytes bytes = hex(empty + "00" + tag + "00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00" +
                                "00 00 00 00 00 00 00 00 00 00 00 00 00 00 80 3F  01 00 00 00  09 00");
        const auto g = decode<GfxObj>(0x010005E8, bytes);
        ASSERT_TRUE(g) << g.error().message();
        EXPECT_EQ(g->drawingBsp.nodes.at(0).polygonIds[0], 9);
        EXPECT_EQ(*encode(*g), bytes);
    }
}

TEST(GfxObjCodec, aTreeDeeperThanTheLimitIsRefusedAndOneOfItsDepthIsRead) {
    const auto chain = [](int nodes) {
        std::string text = "05 00 00 01  01 00 00 00  00  01 00 00 00 00 00 00 00  00";
        for (int i = 0; i + 1 < nodes; ++i)
            text += "6E 6E 50 42  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00"; // BPnn, plane
        text += "46 41 45 4C 00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00  00 00 "
                "00 00";
        for (int i = 0; i + 1 < nodes; ++i)
            text += "00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00";
        return hex(text + "00 00 00 00 00 00 00 00 00 00 00 00");
    };
    const auto deep = decode<GfxObj>(0x01000005, chain(512));
    ASSERT_TRUE(deep) << deep.error().message();
    EXPECT_EQ(*encode(*deep), chain(512));
    const auto deeper = decode<GfxObj>(0x01000005, chain(513));
    ASSERT_FALSE(deeper);
    EXPECT_EQ(deeper.error().what, "the BSP tree is deeper than 512 nodes");
}

const std::string kNoFrame =
    "00 00 00 00 00 00 00 00 00 00 00 00  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00 ";
const std::string kSetupTail = R"(
    01 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00  00 00 00 3F  00 00 80 3F        # cylinder, radius .5, height 1
    01 00 00 00  00 00 00 00 00 00 00 00 00 00 00 3F  00 00 80 3E                     # sphere at z .5, radius .25
    00 00 00 40  00 00 80 3F  00 00 00 3F  00 00 80 3E                                # height 2, radius 1, steps .5, .25
    00 00 00 00 00 00 00 00 00 00 00 00 00 00 40 40                                   # sorting sphere
    00 00 00 00 00 00 00 00 00 00 00 00 00 00 80 40                                   # selection sphere
    01 00 00 00  09 00 00 00  00 00 00 00 00 00 00 00 00 00 80 3F
                 00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 00                      # light 9 at z 1
                 30 20 10 FF  00 00 80 3F  00 00 A0 40  CD CD CD CD                   # colour, intensity 1, range 5, cone
    01 00 00 03  02 00 00 33  03 00 00 09  04 00 00 20  05 00 00 34
)";

TEST(SetupCodec, readsPartsPlacementsAndLights) {
    const Bytes bytes = hex(R"(
        01 00 00 02  03 00 00 00  01 00 00 00  05 00 00 01        # id, parents and scales, one part
        FF FF FF FF  00 00 80 3F 00 00 00 40 00 00 40 40          # no parent, scale 1 2 3
        01 00 00 00  01 00 00 00  00 00 00 00 )" +
                            kNoFrame + R"( # right hand
        00 00 00 00                                               # no connection points
        01 00 00 00  65 00 00 00 )" +
                            kNoFrame + R"(              # placement resting
        02 00 00 00  13 00 00 00 01 00 00 00  0A 00 00 33 00 00 00 3F     # CallPES, forward
                     05 00 00 00 FF FF FF FF  02 34 92 78 56 CD CD CD      # ReplaceObject, long id, padding
    )" + kSetupTail);
    const auto s = decode<dat::Setup>(0x02000001, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->parts, std::vector<std::uint32_t>{0x01000005});
    EXPECT_EQ(s->parents, std::vector<std::uint32_t>{0xFFFFFFFF});
    EXPECT_EQ(s->scales.at(0), Vec3f(1.0f, 2.0f, 3.0f));
    EXPECT_EQ(s->holdingLocations.at(0).key, 1);
    EXPECT_EQ(s->holdingLocations[0].frame.orientation, Quatf(1.0f, 0.0f, 0.0f, 0.0f));
    ASSERT_EQ(s->placementFrames.size(), 1u);
    EXPECT_EQ(s->placementFrames[0].first, dat::Setup::kPlacementResting);
    const auto& hooks = s->placementFrames[0].second.hooks;
    ASSERT_EQ(hooks.size(), 2u);
    EXPECT_EQ(hooks[0].payload.size(), 8u);
    EXPECT_EQ(hooks[1].direction, -1);
    EXPECT_EQ(hooks[1].payload.size(), 8u);
    EXPECT_EQ(s->cylSpheres.at(0).height, 1.0f);
    EXPECT_EQ(s->spheres.at(0).centre.z, 0.5f);
    EXPECT_EQ(s->stepDown, 0.25f);
    EXPECT_EQ(s->selectionSphere.radius, 4.0f);
    EXPECT_EQ(s->lights.at(0).first, 9);
    EXPECT_EQ(s->lights[0].second.colour.argb, 0xFF102030u);
    EXPECT_EQ(s->lights[0].second.falloff, 5.0f);
    EXPECT_EQ(s->scriptTable, 0x34000005u);
    EXPECT_EQ(*encode(*s), bytes);
}

std::string setupWithHook(const std::string& hook) {
    return "01 00 00 02  00 00 00 00  00 00 00 00  00 00 00 00  00 00 00 00  01 00 00 00  00 00 00 00  01 00 "
           "00 00 " +
           hook + kSetupTail;
}

TEST(SetupCodec, readsEveryHookByItsLength) {
    const std::size_t lengths[] = {0, 4, 4, 28, 0, 4, 4,  16, 12, 16, 12, 16, 8, 40,
                                   4, 4, 4, 0,  4, 8, 12, 16, 12, 8,  12, 4,  0};
    for (std::size_t type = 0; type < std::size(lengths); ++type) {
        std::string hook = toHex(Bytes{static_cast<std::byte>(type)}) + "00 00 00  00 00 00 00 ";
        for (std::size_t i = 0; i < lengths[type]; ++i)
            hook += "01 ";
        const Bytes bytes = hex(setupWithHook(hook));
        const auto s = decode<dat::Setup>(0x02000001, bytes);
        ASSERT_TRUE(s) << type << ": " << s.error().message();
        EXPECT_EQ(s->placementFrames[0].second.hooks[0].payload.size(), lengths[type]);
        EXPECT_EQ(*encode(*s), bytes);
    }
}

TEST(SetupCodec, triesTheOtherReadingOfABlockingParticleHook) {
    std::string hook = "1A 00 00 00  00 00 00 00 ";
    for (int i = 0; i < 40; ++i)
        hook += "77 ";
    const Bytes bytes = hex(setupWithHook(hook));
    const auto s = decode<dat::Setup>(0x02000001, bytes);
    ASSERT_TRUE(s) << s.error().message();
    EXPECT_EQ(s->placementFrames[0].second.hooks[0].payload.size(), 40u);
    EXPECT_EQ(*encode(*s), bytes);
}

TEST(SetupCodec, refusesAnUnknownHook) {
    const auto s = decode<dat::Setup>(0x02000001, hex(setupWithHook("1B 00 00 00  00 00 00 00 ")));
    ASSERT_FALSE(s);
    EXPECT_EQ(s.error().what, "0x1B is not the type of an animation hook");
}

// A cell with one portal polygon, a one-leaf cell tree and filled padding.
std::string cellStruct(const std::string& firstPadding, const std::string& lastPadding) {
    return R"(
        01 00 00 00  00 00 00 00  01 00 00 00                              # one polygon, none for physics, one portal
        01 00 00 00  00 00 00 00                                           # no vertices
        02 00  03 04 00 00 00 00 FF FF FF FF  00 00 01 00 02 00            # polygon 2, no uvs: 18 bytes
        02 00                                                              # portal 0 is polygon 2; offset 52 of the record
        )" +
           firstPadding + R"(
        6E 6E 50 42  00 00 80 3F 00 00 00 00 00 00 00 00 00 00 00 40       # BPnn, plane x = -2
        46 41 45 4C  07 00 00 00                                           # LEAF 7
        46 41 45 4C  00 00 00 00  00 00 00 00                              # physics LEAF, open
        00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00  00 00 00 00
        00 00 00 00                                                        # no drawing tree
    )" + lastPadding;
}

TEST(EnvironmentCodec, readsACellShape) {
    const Bytes bytes = hex("E6 02 00 0D  01 00 00 00  02 00 00 00 " + cellStruct("", ""));
    const auto e = decode<Environment>(0x0D0002E6, bytes);
    ASSERT_TRUE(e) << e.error().message();
    ASSERT_EQ(e->cells.size(), 1u);
    EXPECT_EQ(e->cells[0].first, 2u);
    const CellStruct& cell = e->cells[0].second;
    EXPECT_EQ(cell.portalPolygons, std::vector<std::uint16_t>{2});
    ASSERT_EQ(cell.cellBsp.nodes.size(), 2u);
    EXPECT_EQ(cell.cellBsp.nodes[0].tag, BspTag::BPnn);
    EXPECT_EQ(cell.cellBsp.nodes[0].positive, 1);
    EXPECT_EQ(cell.cellBsp.nodes[0].negative, -1);
    EXPECT_EQ(cell.cellBsp.nodes[1].leafIndex, 7);
    EXPECT_EQ(cell.physicsBsp.nodes.at(0).solid, 0);
    EXPECT_FALSE(cell.drawingBsp.has_value());
    EXPECT_EQ(*encode(*e), bytes);
}

TEST(EnvironmentCodec, alignsFromTheStartOfTheRecordAndKeepsThePadding) {
    // Two portals need no padding. Behind one portal, two bytes of padding with any content restore the
    // alignment.
    const std::string twoPortals = R"(
        E6 02 00 0D  01 00 00 00  00 00 00 00  00 00 00 00  00 00 00 00  02 00 00 00
        01 00 00 00  00 00 00 00  01 00 02 00
        46 41 45 4C  00 00 00 00
        46 41 45 4C  00 00 00 00  00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00  00 00 00 00
        00 00 00 00)";
    EXPECT_TRUE(decode<Environment>(0x0D0002E6, hex(twoPortals)));
    std::string onePortal = twoPortals;
    onePortal.replace(onePortal.find("02 00 00 00\n"), 11, "01 00 00 00");
    onePortal.replace(onePortal.find("01 00 02 00\n"), 11, "01 00 AB CD");
    const Bytes bytes = hex(onePortal);
    const auto e = decode<Environment>(0x0D0002E6, bytes);
    ASSERT_TRUE(e) << e.error().message();
    EXPECT_EQ(e->cells[0].second.portalPadding[1], 0xCD);
    EXPECT_EQ(*encode(*e), bytes);
}

TEST(EnvironmentCodec, refusesADrawingFlagThatIsNeitherZeroNorOne) {
    Bytes bytes = hex("E6 02 00 0D  01 00 00 00  02 00 00 00 " + cellStruct("", ""));
    bytes[bytes.size() - 4] = std::byte{2};
    const auto e = decode<Environment>(0x0D0002E6, bytes);
    ASSERT_FALSE(e);
    EXPECT_EQ(e.error().what, "the flag for a drawing BSP is 2; 0 or 1 was expected");
}

TEST(PackedCount, oneTwoAndFourBytes) {
    // A GfxObj's number of surfaces is a packed count: 127, 128 and 16384.
    for (const auto& [count, prefix] : {std::pair<std::size_t, const char*>{127, "7F"},
                                        {128, "80 80"},
                                        {0x3FFF, "BF FF"},
                                        {0x4000, "C0 00 00 40"},
                                        {0x12345, "C0 01 45 23"}}) {
        Bytes bytes = hex(std::string("05 00 00 01  00 00 00 00 ") + prefix);
        bytes.resize(bytes.size() + count * 4, std::byte{8});
        const Bytes tail = hex("01 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00 00 00 00 00");
        bytes.insert(bytes.end(), tail.begin(), tail.end());
        const auto g = decode<GfxObj>(0x01000005, bytes);
        ASSERT_TRUE(g) << g.error().message();
        EXPECT_EQ(g->surfaces.size(), count);
        EXPECT_EQ(*encode(*g), bytes);
    }
}

TEST(PackedCount, moreBytesThanNeededAreRefused) {
    for (const char* prefix : {"80 05", "C0 00 05 00", "C0 00 FF 3F"}) {
        Bytes bytes = hex(std::string("05 00 00 01  00 00 00 00 ") + prefix);
        bytes.resize(bytes.size() + 0x20000);
        const auto g = decode<GfxObj>(0x01000005, bytes);
        ASSERT_FALSE(g);
        EXPECT_NE(g.error().what.find("more bytes than it needs"), std::string::npos) << g.error().message();
    }
}

} // namespace
} // namespace limen::dat
