#include "engine/map/MapCoordinates.h"
#include "engine/map/MapInBackground.h"
#include "engine/map/MapPainter.h"
#include "engine/map/PlacesOnMap.h"
#include "engine/picture/LinearFilter.h"
#include "support/LoadTestWorld.h"

#include <chrono>
#include <thread>

namespace limen::engine {
namespace {

using test::TestWorld;

/// Writes a test world and opens its files.
struct Files {
    explicit Files(TestWorld& world) { EXPECT_TRUE(world.write(directory.path())); }
    [[nodiscard]] Result<LandscapeMap> paint(int scale = 8) const {
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        EXPECT_TRUE(archive);
        return paintMap(*archive, scale);
    }
    test::TempDir directory;
};

std::array<std::uint8_t, 3> colourAt(const LandscapeMap& map, double blockX, double blockY) {
    const auto colour = map.colourAt(Vec2(blockX, blockY) * world::kBlockSize);
    EXPECT_TRUE(colour);
    return colour.value_or(std::array<std::uint8_t, 3>{1, 2, 3});
}

int brightness(const std::array<std::uint8_t, 3>& colour) {
    return colour[0] + colour[1] + colour[2];
}

TEST(LandscapeMap, isCroppedToTheBlocksAndNorthIsUp) {
    TestWorld world({0x20, 0x30});
    world.setFlatTerrain({0x20, 0x30}, 0, 0);
    world.setFlatTerrain({0x22, 0x30}, 0, 1);
    world.setFlatTerrain({0x20, 0x33}, 0, 2);
    const Result<LandscapeMap> map = Files(world).paint();
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(std::tuple(map->left, map->bottom, map->columns, map->rows), std::tuple(0x20, 0x30, 3, 4));
    EXPECT_EQ(map->width(), 24u);
    EXPECT_EQ(map->height(), 32u);
    EXPECT_EQ(map->southWest(), Vec2(0x20, 0x30) * 192.0);
    // South-west is in the lower left corner, north in the first rows, east in the last columns.
    const auto texel = [&](std::size_t x, std::size_t y) {
        const std::size_t i = (y * map->width() + x) * 3;
        return std::array{map->rgb[i], map->rgb[i + 1], map->rgb[i + 2]};
    };
    EXPECT_EQ(texel(0, 31), colourAt(*map, 0x20 + 0.01, 0x30 + 0.01));
    EXPECT_EQ(texel(0, 0), colourAt(*map, 0x20 + 0.01, 0x33 + 0.99));
    EXPECT_EQ(texel(23, 31), colourAt(*map, 0x22 + 0.99, 0x30 + 0.01));
    EXPECT_NE(texel(0, 31), texel(0, 0)) << "two terrain types";
    EXPECT_NE(texel(0, 31), texel(23, 31));
    EXPECT_EQ(texel(12, 31), kNoGround) << "no landblock";
    EXPECT_EQ(map->find({0x21, 0x30}), nullptr);
    ASSERT_NE(map->find({0x22, 0x30}), nullptr);
    EXPECT_TRUE(map->find({0x22, 0x30})->hasGround);
}

TEST(LandscapeMap, flatGroundHasTheMeanColourOfItsTexture) {
    TestWorld world;
    dat::RenderSurface checks = test::solidImage(2, 1, 0xFF000000u); // A8R8G8B8, as bytes B G R A
    for (std::size_t i = 4; i < 8; ++i)
        checks.pixels[i] = 0xFF;
    checks.id = 0x06004000;
    dat::SurfaceTexture texture;
    texture.id = 0x05004000;
    texture.images = {checks.id};
    world.portalFile().add(checks);
    world.portalFile().add(texture);
    world.region().texMerge.textures.front().texture = texture.id;
    world.setFlatTerrain(world.home(), 3,
                         static_cast<std::uint8_t>(world.region().texMerge.textures.front().terrainType));
    const Result<LandscapeMap> map = Files(world).paint();
    ASSERT_TRUE(map) << map.error().message();
    // Black and white texels: the mean light is 1/2, which sRGB encodes as 188.
    EXPECT_EQ(colourAt(*map, world.home().x + 0.5, world.home().y + 0.5),
              (std::array<std::uint8_t, 3>{188, 188, 188}));
}

TEST(LandscapeMap, lightComesFromTheNorthWest) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    dat::LandBlock& ground = world.terrain(world.home());
    for (std::size_t x = 0; x < 9; ++x) // a ridge from south to north
        for (std::size_t y = 0; y < 9; ++y)
            ground.heights[x * 9 + y] = static_cast<std::uint8_t>(x <= 4 ? 6 * x : 6 * (8 - x));
    const Result<LandscapeMap> map = Files(world).paint();
    ASSERT_TRUE(map);
    const int west = brightness(colourAt(*map, world.home().x + 0.2, world.home().y + 0.5));
    const int east = brightness(colourAt(*map, world.home().x + 0.8, world.home().y + 0.5));
    EXPECT_GT(west, east + 60);
}

TEST(LandscapeMap, waterIsNotShaded) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0, 0x12);
    dat::LandBlock& ground = world.terrain(world.home());
    for (std::size_t i = 0; i < 81; ++i)
        ground.heights[i] = static_cast<std::uint8_t>(i % 7 * 5);
    const Result<LandscapeMap> map = Files(world).paint();
    ASSERT_TRUE(map);
    EXPECT_EQ(colourAt(*map, world.home().x + 0.1, world.home().y + 0.3),
              colourAt(*map, world.home().x + 0.7, world.home().y + 0.9));
}

TEST(LandscapeMap, roadsAreLinesAlongTheirVertices) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    dat::LandBlock& ground = world.terrain(world.home());
    for (std::size_t y = 0; y < 9; ++y)
        ground.terrain[4 * 9 + y] |= 1; // along x = 96 m
    for (const int scale : {8, 12, 64}) {
        const Result<LandscapeMap> map = Files(world).paint(scale);
        ASSERT_TRUE(map);
        const auto on = colourAt(*map, world.home().x + 0.501, world.home().y + 0.55);
        const auto beside = colourAt(*map, world.home().x + 0.8, world.home().y + 0.55);
        EXPECT_NE(on, beside) << scale;
        EXPECT_EQ(beside, colourAt(*map, world.home().x + 0.1, world.home().y + 0.55)) << scale;
    }
}

TEST(LandscapeMap, buildingsAreFootprintsAndTurnWithTheirFrames) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 0);
    const auto house = world.addBox({93, 80, 0}, {99, 112, 4});
    TestWorld::BuildingOptions turned;
    turned.frame = test::frameAt({96, 96, 0}, 90);
    const auto door = world.openOutside(house, test::rectangle({95, 80, 0}, {97, 80, 2}));
    world.addBuilding(test::boxExterior({92, 80, 0}, {100, 116, 5}), {door}, turned);
    const Result<LandscapeMap> map = Files(world).paint(64); // 3 m a texel
    ASSERT_TRUE(map) << map.error().message();
    const auto at = [&](double x, double y) {
        return *map->colourAt(Vec2(world.home().x, world.home().y) * 192.0 + Vec2(x, y));
    };
    EXPECT_NE(at(96, 96), at(20, 20));
    EXPECT_EQ(at(96, 112), at(96, 96)) << "its long side is from south to north";
    EXPECT_EQ(at(112, 96), at(20, 20));
    EXPECT_EQ(map->find(world.home())->buildings, 1u);
    EXPECT_FALSE(map->find(world.home())->isDungeon());
    const Result<LandscapeMap> coarse = Files(world).paint(8);
    ASSERT_TRUE(coarse);
    EXPECT_NE(*coarse->colourAt(Vec2(world.home().x, world.home().y) * 192.0 + Vec2(97, 100)),
              *coarse->colourAt(Vec2(world.home().x, world.home().y) * 192.0 + Vec2(20, 20)))
        << "a building narrower than a texel is still there";
}

TEST(LandscapeMap, damagedAndMissingRecordsAreDarkAndCounted) {
    TestWorld world;
    world.setFlatTerrain({0x20, 0x30}, 0);
    world.setFlatTerrain({0x21, 0x30}, 0);
    const Files files(world);
    {
        dat::Writer cells(dat::FileTraits::cell());
        const Result<dat::Archive> archive = dat::Archive::open(files.directory.path());
        ASSERT_TRUE(archive);
        dat::Bytes scratch;
        const Result<dat::ByteView> good = archive->cell().read(dat::landBlockId({0x20, 0x30}), scratch);
        ASSERT_TRUE(good);
        cells.add(dat::landBlockId({0x20, 0x30}), dat::Bytes(good->begin(), good->end()));
        cells.add(dat::landBlockId({0x21, 0x30}), dat::Bytes(7));
        ASSERT_TRUE(cells.write(files.directory.path() / "client_cell_1.dat"));
    }
    const Result<LandscapeMap> map = files.paint();
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(map->damaged, 1u);
    EXPECT_EQ(colourAt(*map, 0x21 + 0.5, 0x30 + 0.5), kNoGround);
    EXPECT_FALSE(map->find({0x21, 0x30})->hasGround);
    EXPECT_NE(colourAt(*map, 0x20 + 0.5, 0x30 + 0.5), kNoGround);
}

TEST(LandscapeMap, dungeonsAreNoLandscapeAndDoNotWidenTheMap) {
    TestWorld world({0x20, 0x30});
    world.setFlatTerrain(world.home(), 0);
    TestWorld::CellOptions far;
    far.block = dat::BlockCoord{0x02, 0x05};
    world.addBox({0, 0, -10}, {4, 4, -7}, "grey", far);
    const Result<LandscapeMap> map = Files(world).paint();
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(std::tuple(map->left, map->bottom, map->columns, map->rows), std::tuple(0x20, 0x30, 1, 1));
    ASSERT_NE(map->find({0x02, 0x05}), nullptr);
    EXPECT_TRUE(map->find({0x02, 0x05})->isDungeon());
    EXPECT_FALSE(map->find({0x02, 0x05})->hasGround);
}

TEST(LandscapeMap, aWorldWithoutRegionHasNoGround) {
    TestWorld dungeon;
    dungeon.addBox({0, 0, 0}, {4, 4, 3});
    dungeon.omitRegion();
    const Result<LandscapeMap> map = Files(dungeon).paint();
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(map->columns, 1);
    EXPECT_EQ(colourAt(*map, dungeon.home().x + 0.5, dungeon.home().y + 0.5), kDungeonBlock);
    EXPECT_TRUE(map->find(dungeon.home())->isDungeon());
}

TEST(LandscapeMap, isPaintedInTheBackgroundToTheSameBytes) {
    TestWorld world;
    world.setFlatTerrain(world.home(), 5, 1);
    const Files files(world);
    Result<dat::Archive> archive = dat::Archive::open(files.directory.path());
    ASSERT_TRUE(archive);
    const auto source = std::make_shared<const WorldSource>(WorldSource{{}, std::move(*archive), {}, ""});
    const MapInBackground work(source);
    while (!work.isDone())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::uint64_t revision = 0;
    const std::shared_ptr<const LandscapeMap> map = work.since(revision);
    ASSERT_NE(map, nullptr);
    EXPECT_EQ(map->rgb, files.paint()->rgb);
    EXPECT_EQ(work.progress(), 1.0);
    EXPECT_EQ(work.since(revision), nullptr) << "nothing new";
}

TEST(MapCoordinates, areThoseOfTheFormatPage) {
    const auto at = [](int x, int y, double localX, double localY) {
        return mapText(Vec2(x, y) * 192.0 + Vec2(localX, localY));
    };
    EXPECT_EQ(at(0xF9, 0x2F, 68, 20), "64.3S 97.5E");
    EXPECT_EQ(mapText({0xF9 * 192.0 + 68.0, 0x2F * 192.0 + 20.0}), "64.3S 97.5E"); // ACE issue 3163
    EXPECT_EQ(mapText({24468.0 - 5.0, 24468.0 - 5.0}), "0.0N 0.0E") << "a rounded zero has no side";
    EXPECT_EQ(mapText({24468.0 - 240.0, 24468.0 + 24.0}), "0.1N 1.0W");
    EXPECT_EQ(blockAtPoint({-5.0, 1e9}), (dat::BlockCoord{0, 254}));
    EXPECT_EQ(blockText({0xA9, 0x04}), "A904");
}

TEST(PlacesOnMap, dungeonsAreKnownByTheirBlocks) {
    LandscapeMap map;
    map.blocks = {{{1, 2}, false, 0, 7}, {{3, 4}, true, 2, 9}};
    const std::vector<world::Place> places{{"cellar", {600, 800, 0}, 0, 0, 0x03040102},
                                           {"dungeon", {200, 400, -6}, 0, 0, 0x01020100},
                                           {"field", {250, 500, 30}, 0, 0, 0}};
    const std::vector<PlaceOnMap> shown = placesOnMap(places, map);
    ASSERT_EQ(shown.size(), 3u);
    EXPECT_FALSE(shown[0].isDungeon);
    EXPECT_TRUE(shown[1].isDungeon);
    EXPECT_FALSE(shown[2].isDungeon) << "outside, above a dungeon's block";
    EXPECT_EQ(shown[0].point, Vec2(600, 800));
}

TEST(PlacesOnMap, labelsGiveWayToEarlierOnes) {
    const std::vector<LabelBox> boxes{{0, 0, 10, 5}, {8, 2, 10, 5}, {11, 0, 5, 5}, {8, 4.9, 2, 2}};
    EXPECT_EQ(labelsWithoutOverlap(boxes), (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(matchesName("Holtburg", "burg"));
    EXPECT_TRUE(matchesName("Holtburg", "HOLT"));
    EXPECT_FALSE(matchesName("Holtburg", "x"));
    EXPECT_TRUE(matchesName("Holtburg", ""));
}

TEST(LinearFilter, isTheInverseOfItselfAndMeansAreOfLight) {
    const LinearMean light;
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(light.encoded(light.linear(static_cast<std::uint8_t>(i))), i);
    EXPECT_EQ(light.encoded((light.linear(0) + light.linear(255)) / 2), 188);
}

} // namespace
} // namespace limen::engine
