#include "doctor/retail/Census.h"
#include "doctor/OriginalRecords.h"

#include <cstring>
#include <gtest/gtest.h>

namespace limen::doctor {
namespace {

using test::bareTriangle;
using test::leafTree;

/// A small world whose counts are known by construction.
class CensusTest : public testing::Test {
protected:
    [[nodiscard]] Census taken() const {
        Result<Census> census = takeCensus(test::archiveOf(portal, cell));
        EXPECT_TRUE(census);
        return census ? *census : Census{};
    }
    dat::Writer portal{dat::FileTraits::portal()}, cell{dat::FileTraits::cell()};
};

dat::GfxObj meshOf(dat::RecordId id, dat::RecordId levels) {
    dat::GfxObj object;
    object.id = id;
    object.flags = dat::GfxObj::kDrawing | (levels != 0 ? dat::GfxObj::kHasDegrade : 0u);
    object.degradeId = levels;
    object.drawingBsp = leafTree();
    return object;
}

dat::DegradeInfo levelsOf(dat::RecordId id, std::vector<std::pair<dat::RecordId, std::uint32_t>> levels) {
    dat::DegradeInfo info;
    info.id = id;
    for (const auto& [mesh, mode] : levels)
        info.levels.push_back({mesh, mode, 0, 0, 0});
    return info;
}

TEST_F(CensusTest, countsMeshesAndLevels) {
    dat::GfxObj first = meshOf(0x01000001, 0x11000001), second = meshOf(0x01000002, 0x11000002);
    first.vertexArray.vertices = {{0, {{}, {0, 0, 1}, {}}}, {1, {{}, {0, 0, 0}, {}}}};
    second.vertexArray.vertices = {{0, {{}, {0, 1, 0}, {}}}};
    dat::Polygon both = bareTriangle(0);
    both.sides = static_cast<int>(dat::Sides::Both);
    both.stippling |= dat::kNoNegativeUv;
    first.polygons = {{0, bareTriangle(0)}, {1, both}};
    portal.add(first);
    portal.add(second);
    portal.add(levelsOf(0x11000001, {{0x01000001, 1}, {0, 1}}));
    portal.add(levelsOf(0x11000002, {{0x01000003, 2}, {0x01000002, 5}, {0, 4}}));
    dat::ParticleEmitter emitter;
    emitter.id = 0x32000001;
    emitter.gfxObj = 0x01000002;
    portal.add(emitter);
    emitter.id = 0x32000002;
    portal.add(emitter);
    const Census census = taken();
    EXPECT_EQ(census[Tally::GfxObjs], 2);
    EXPECT_EQ(census[Tally::Vertices], 3);
    EXPECT_EQ(census[Tally::ZeroNormals], 1);
    EXPECT_EQ(census[Tally::ObjectsWithZeroNormals], 1);
    EXPECT_EQ(census[Tally::TwoSurfaceSides], 1);
    EXPECT_EQ(census[Tally::UvBit8], 1);
    EXPECT_EQ(census[Tally::DegradeInfos], 2);
    EXPECT_EQ(census[Tally::LevelMode1], 2);
    EXPECT_EQ(census[Tally::LevelMode2], 1);
    EXPECT_EQ(census[Tally::LevelMode4], 1);
    EXPECT_EQ(census[Tally::LevelMode5], 1);
    EXPECT_EQ(census[Tally::OtherLevel0], 1) << "the second record's level 0 is another mesh";
    EXPECT_EQ(census[Tally::Emitters], 2);
    EXPECT_EQ(census[Tally::EmitterMeshes], 1);
    EXPECT_EQ(census[Tally::EmitterMeshesWithLevels], 1);
    EXPECT_EQ(census[Tally::EmitterMode2], 1);
}

TEST_F(CensusTest, countsClipMapsByPictureAndBlending) {
    const auto picture = [&](dat::RecordId id, dat::PixelFormat format) {
        dat::RenderSurface image;
        image.id = id;
        image.format = format;
        image.width = image.height = 4;
        image.pixels.resize(format == dat::PixelFormat::P8 ? 16 : format == dat::PixelFormat::Dxt5 ? 16 : 64);
        portal.add(image);
        portal.add(dat::SurfaceTexture{id - 0x01000000, 0, 2, {id}});
    };
    picture(0x06000001, dat::PixelFormat::P8);
    picture(0x06000002, dat::PixelFormat::Dxt5);
    const auto surface = [&](dat::RecordId id, std::uint32_t type, dat::RecordId texture) {
        dat::Surface made;
        made.type = type;
        made.texture = texture;
        portal.add(id, made);
    };
    surface(0x08000001, dat::Surface::kBase1ClipMap, 0x05000001);
    surface(0x08000002, dat::Surface::kBase1ClipMap | dat::Surface::kAlpha | dat::Surface::kAdditive,
            0x05000002);
    surface(0x08000003, dat::Surface::kBase1Image | dat::Surface::kLuminous | dat::Surface::kInvAlpha,
            0x05000002);
    portal.add(dat::Palette{0x04000001, {{}}});
    portal.add(dat::Palette{0x04000002, std::vector<dat::Colour>(2048)});
    const Census census = taken();
    EXPECT_EQ(census[Tally::Surfaces], 3);
    EXPECT_EQ(census[Tally::ClipMaps], 2);
    EXPECT_EQ(census[Tally::PalettisedClipMaps], 1);
    EXPECT_EQ(census[Tally::OtherClipMaps], 1);
    EXPECT_EQ(census[Tally::ClipDxt5], 1);
    EXPECT_EQ(census[Tally::ClipPlain], 1);
    EXPECT_EQ(census[Tally::ClipAlphaAdditive], 1);
    EXPECT_EQ(census[Tally::GlowFlags], 1);
    EXPECT_EQ(census[Tally::InverseAlpha], 1);
    EXPECT_EQ(census[Tally::Palettes], 2);
    EXPECT_EQ(census[Tally::OtherPalettes], 1);
}

dat::Setup setupOf(dat::RecordId id, std::vector<std::uint32_t> parts) {
    dat::Setup setup;
    setup.id = id;
    setup.parts = std::move(parts);
    return setup;
}

TEST_F(CensusTest, countsThingsAndLampsInCells) {
    dat::Setup lamp = setupOf(0x02000001, {});
    dat::LightInfo light;
    light.intensity = 20;
    light.falloff = 1;
    lamp.lights = {{0, light}};
    light.intensity = 100;
    light.falloff = 15;
    lamp.lights.emplace_back(1, light);
    portal.add(lamp);
    dat::Setup marker = setupOf(0x02000002, {0x010001EC});
    marker.script = 0x33000001;
    portal.add(marker);
    dat::Setup mill = setupOf(0x02000003, {});
    mill.animation = 0x03000001;
    mill.placementFrames = {{0, {}}};
    portal.add(mill);
    const auto room = [&](dat::RecordId id, std::vector<std::uint32_t> models, std::uint32_t flags) {
        dat::EnvCell made;
        made.id = id;
        made.flags = flags | dat::EnvCell::kHasStatics;
        for (const std::uint32_t model : models)
            made.statics.push_back({model, {}});
        cell.add(made);
    };
    room(0x7F030100, {0x02000001, 0x02000001, 0x02000003}, 0);
    room(0x7F030101, {0x02000001, 0x02000002}, dat::EnvCell::kHasWeenies);
    room(0x10100100, {0x01000001}, 0);
    dat::LandBlockInfo info;
    info.id = 0x1010FFFE;
    info.objects = {{0x02000003, {}}, {0x02000002, {}}, {0x02000003, {}}};
    info.buildings.resize(2);
    info.buildings[0].portals.resize(1);
    cell.add(info);
    dat::LandBlock land;
    land.id = 0x1010FFFF;
    land.terrain[3] = 0x0080;
    land.terrain[4] = 0xF87F;
    cell.add(land);
    const Census census = taken();
    EXPECT_EQ(census[Tally::EnvCells], 3);
    EXPECT_EQ(census[Tally::OddCellFlags], 1);
    EXPECT_EQ(census[Tally::CellThings], 6);
    EXPECT_EQ(census[Tally::CellMarkers], 1);
    EXPECT_EQ(census[Tally::BlocksWithMarkers], 1);
    EXPECT_EQ(census[Tally::PlacedLamps], 6);
    EXPECT_EQ(census[Tally::LitCells], 2);
    EXPECT_EQ(census[Tally::MedianLampsOfCell], 2);
    EXPECT_EQ(census[Tally::MostLampsOfCell], 4);
    EXPECT_EQ(census[Tally::LeastLampIntensity], 20);
    EXPECT_EQ(census[Tally::MostLampIntensity], 100);
    EXPECT_EQ(census[Tally::LeastLampFalloff], 1);
    EXPECT_EQ(census[Tally::MostLampFalloff], 15);
    EXPECT_EQ(census[Tally::SetupsWithLamps], 1);
    EXPECT_EQ(census[Tally::PlacedSetupsWithLamps], 1);
    EXPECT_EQ(census[Tally::SetupsWithScript], 1);
    EXPECT_EQ(census[Tally::SetupsWithoutScript], 2);
    EXPECT_EQ(census[Tally::IndoorSetups], 3);
    EXPECT_EQ(census[Tally::AnimatedIndoor], 1);
    EXPECT_EQ(census[Tally::OutdoorSetups], 2);
    EXPECT_EQ(census[Tally::AnimatedOutdoor], 1);
    EXPECT_EQ(census[Tally::AcademySetups], 3);
    EXPECT_EQ(census[Tally::AcademySetupsDefaultOnly], 1);
    EXPECT_EQ(census[Tally::Buildings], 2);
    EXPECT_EQ(census[Tally::BuildingsWithRooms], 1);
    EXPECT_EQ(census[Tally::LandBlocks], 1);
    EXPECT_EQ(census[Tally::OtherLandBlocks], 0);
    EXPECT_EQ(census[Tally::OddTerrainWords], 1);
}

TEST_F(CensusTest, countsShapesSceneryAndCalls) {
    const auto shapeWith = [](std::size_t vertices) {
        dat::CellStruct shape;
        shape.cellBsp = shape.physicsBsp = leafTree();
        for (std::size_t i = 0; i < vertices; ++i)
            shape.vertexArray.vertices.emplace_back(static_cast<std::uint16_t>(i), dat::Vertex{});
        return shape;
    };
    dat::Environment environment;
    environment.id = 0x0D000001;
    environment.cells = {{0, shapeWith(4)}, {1, shapeWith(8)}, {2, shapeWith(30)}};
    portal.add(environment);
    dat::Scene scene;
    scene.id = 0x12000001;
    scene.objects.resize(3);
    scene.objects[0].object = 0x02000001;
    scene.objects[1].object = 0x02000002;
    scene.objects[1].baseLoc.orientation = Quatf(0.9998f, 0.0174f, 0, 0); // two degrees about x
    scene.objects[2].object = 0x01000001;
    scene.objects[2].baseLoc.orientation = Quatf(0.7071f, 0, 0, 0.7071f); // heading alone
    portal.add(scene);
    dat::PhysicsScript script;
    script.id = 0x33000001;
    for (const float pause : {0.0f, 900.0f, 0.5f}) {
        dat::AnimationHook hook;
        hook.type = 0x13;
        hook.payload.resize(8);
        std::memcpy(hook.payload.data() + 4, &pause, sizeof pause);
        script.hooks.push_back({0.0, hook});
    }
    portal.add(script);
    portal.add(0x33000002, dat::Bytes(3));
    const Census census = taken();
    EXPECT_EQ(census[Tally::CellShapes], 3);
    EXPECT_EQ(census[Tally::CellShapeVertices], 42);
    EXPECT_EQ(census[Tally::MedianShapeVertices], 8);
    EXPECT_EQ(census[Tally::MostShapeVertices], 30);
    EXPECT_EQ(census[Tally::ScenerySetups], 2);
    EXPECT_EQ(census[Tally::TiltedScenery], 1);
    EXPECT_EQ(census[Tally::TiltedScenerySetups], 1);
    EXPECT_EQ(census[Tally::ScriptCalls], 3);
    EXPECT_EQ(census[Tally::ScriptCallsWithPause], 2);
    EXPECT_EQ(census[Tally::LeastPause], 0.5);
    EXPECT_EQ(census[Tally::MostPause], 900);
    EXPECT_EQ(census[Tally::Unreadable], 1);
}

TEST_F(CensusTest, reportsProgressToTheEnd) {
    for (dat::RecordId id = 0x04000001; id < 0x04000300; ++id)
        portal.add(dat::Palette{id, {{}}});
    std::size_t last = 0, of = 0;
    ASSERT_TRUE(takeCensus(test::archiveOf(portal, cell), [&](std::size_t total, std::size_t done) {
        EXPECT_GT(done, last);
        last = done;
        of = total;
    }));
    EXPECT_GT(last, 500u);
    EXPECT_LE(last, of);
}

} // namespace
} // namespace limen::doctor
