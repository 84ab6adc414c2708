#include "world/terrain/Terrain.h"

#include "geometry/Angles.h"
#include "support/LoadTestWorld.h"
#include "world/LandRandom.h"
#include "world/terrain/Scenery.h"
#include "world/terrain/SceneryFit.h"

#include <gmock/gmock.h>

namespace limen::world {
namespace {

using test::TestWorld;
using testing::ElementsAre;
using testing::IsEmpty;

// The vectors are from docs/formats/landscape.md#random-numbers.
TEST(LandHash, agreesWithTheTestVectors) {
    struct Vector {
        std::uint32_t x, y, split, scene, frequency, displace, quadrant;
        bool southWestNorthEast;
    };
    constexpr Vector kVectors[] = {
        {0, 0, 0xAE6470DB, 0x7F8CDA01, 0xF4D7C05F, 0x7EF78C75, 0xE8031203, true},
        {1, 0, 0x6C488D1E, 0x3D70F644, 0xB2BBDCA2, 0x3CDBA8B8, 0xA5E72E46, false},
        {0, 1, 0x1A7F3662, 0xEBA79F88, 0x60F285E6, 0xEB1251FC, 0x541DD78A, false},
        {1, 1, 0xE52E12D8, 0xD40AE754, 0x31787400, 0x664B8DDC, 0xA2861A68, true},
        {1232, 1416, 0x896E9983, 0x75C7C1A9, 0x42F5F307, 0xB6D8D61D, 0x73849EAB, true},
        {1000, 1000, 0x7540A0AB, 0x813A0B51, 0xACA0A12F, 0xAC3AEAC5, 0x69B7ABD3, false},
        {2039, 2039, 0x3846F0E4, 0xC8A4F040, 0xC6DA954C, 0xE9769D08, 0x6FF478F4, false}};
    for (const Vector& v : kVectors) {
        EXPECT_EQ(landHash(v.x, v.y, seed::kSplit), v.split);
        EXPECT_EQ(landHash(v.x, v.y, seed::kScene), v.scene);
        EXPECT_EQ(landHash(v.x, v.y, seed::kFrequency), v.frequency);
        EXPECT_EQ(landHash(v.x, v.y, seed::kDisplaceX), v.displace);
        EXPECT_EQ(landHash(v.x, v.y, seed::kQuadrant), v.quadrant);
        EXPECT_EQ(splitsSouthWestNorthEast(v.x, v.y), v.southWestNorthEast);
    }
    EXPECT_DOUBLE_EQ(landRandom(0, 0, seed::kSplit), 0xAE6470DB / 4294967296.0);
    EXPECT_EQ(landHash(1352, 1440, seed::kFrequency), 0x16DC1C97u);
    EXPECT_EQ(landHash(1352, 1440, seed::kDisplaceX), 0x3666E6ADu);
    EXPECT_EQ(landHash(1352, 1440, seed::kRotation), 0x6DF74D47u);
    EXPECT_EQ(landHash(1352, 1440, seed::kScene), 0x4B261039u);
}

TEST(LandHash, cutsTheLandcellsOfABlockAsStated) {
    constexpr std::array<std::string_view, 8> kBlockA9B4{R"(////////)", R"(////////)", R"(///\\\\\)",
                                                         R"(//\\\\\/)", R"(//\\\///)", R"(//\\//\\)",
                                                         R"(/\\//\\/)", R"(/\\//\//)"};
    for (int row = 0; row < 8; ++row) // the first one is the northern one
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(splitsSouthWestNorthEast({0xA9, 0xB4}, x, 7 - row),
                      kBlockA9B4.at(static_cast<std::size_t>(row)).at(static_cast<std::size_t>(x)) == '/')
                << x << "," << 7 - row;
}

Ground hill() {
    Ground ground;
    for (int x = 0; x < 9; ++x)
        for (int y = 0; y < 9; ++y)
            ground.heights[static_cast<std::size_t>(x * 9 + y)] = static_cast<float>((x * 7 + y * 5) % 11);
    return ground;
}

TEST(TerrainMesh, hasTwoTrianglesACellCutAsTheHashSays) {
    const Ground ground = hill();
    const MeshData mesh = terrainMesh(ground, [](int, int) { return std::nullopt; });
    ASSERT_EQ(mesh.vertices.size(), 384u);
    ASSERT_EQ(mesh.polygonIds.size(), 128u);
    // Cell (0,0) is cut SW-NE: its first triangle is SW, SE, NE; cell (1,0) is cut SE-NW: SW, SE, NW.
    EXPECT_EQ(mesh.vertices[2].position, Vec3f(24, 24, ground.heights[10]));
    const std::size_t east = 8 * 6;
    EXPECT_EQ(mesh.vertices[east].surface, 8);
    EXPECT_EQ(mesh.vertices[east + 2].position, Vec3f(24, 24, ground.heights[10]));
    EXPECT_EQ(mesh.vertices[east + 3].position, Vec3f(48, 24, ground.heights[19]));
    EXPECT_EQ(mesh.vertices[east].uv, Vec2f(0, 0));
    EXPECT_EQ(mesh.vertices[east + 3].uv, Vec2f(1, 1));
}

TEST(TerrainMesh, isSeenFromAboveAndMatchesTheGroundItself) {
    const Ground ground = hill();
    const MeshData mesh = terrainMesh(ground, [](int, int) { return std::nullopt; });
    for (std::size_t i = 0; i < mesh.indices[0].size(); i += 3) {
        Vec3 p[3];
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = mesh.vertices[mesh.indices[0][i + k]].position;
        EXPECT_GT(glm::cross(p[1] - p[0], p[2] - p[0]).z, 0.0);
        const Vec3 middle = (p[0] + p[1] + p[2]) / 3.0;
        EXPECT_NEAR(groundAt({0, 0}, ground.heights, middle.x, middle.y).z, middle.z, 1e-9);
        EXPECT_EQ(mesh.vertices[mesh.indices[0][i]].polygon, i / 3);
    }
}

TEST(Land, isACentimetreBelowTheHeightsOfTheRecords) {
    TestWorld source;
    dat::LandBlock& land = source.terrain(source.home());
    for (std::size_t i = 0; i < 81; ++i)
        land.heights[i] = static_cast<std::uint8_t>(i * 7 % 5);
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.blocks.size(), 1u);
    for (std::size_t i = 0; i < 81; ++i) {
        const float height = 2.0f * static_cast<float>(land.heights[i]);
        EXPECT_EQ(world.blocks[0].heights[i], height - 0.01f);
        const Vec3 at = world.blocks[0].origin() +
                        Vec3(24.0 * static_cast<double>(i / 9), 24.0 * static_cast<double>(i % 9), 0.0);
        const bool isDrawn =
            std::any_of(world.vertices.begin(), world.vertices.end(), [&](const MeshVertex& v) {
                return Vec3(v.position) == Vec3(at.x - world.blocks[0].origin().x,
                                                at.y - world.blocks[0].origin().y, height - 0.01f);
            });
        EXPECT_TRUE(isDrawn) << "vertex " << i;
    }
}

TEST(TerrainMesh, normalsAgreeAcrossTheBorder) {
    TestWorld source;
    for (int block = 0; block < 2; ++block) {
        dat::LandBlock& land = source.terrain({0x20 + block, 0x30});
        for (int x = 0; x < 9; ++x) {
            for (int y = 0; y < 9; ++y)
                land.heights[static_cast<std::size_t>(x * 9 + y)] =
                    static_cast<std::uint8_t>(((x + 8 * block) * 3 + y) % 7 + 1);
        }
    }
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.blocks.size(), 2u);
    std::map<std::pair<float, float>, Vec3f> western;
    int compared = 0;
    for (const Instance& instance : world.instances) {
        const Mesh& mesh = world.meshes[instance.mesh];
        for (std::uint32_t v = 0; v < mesh.vertexCount; ++v) {
            const MeshVertex& vertex = world.vertices[mesh.firstVertex + v];
            const std::pair<float, float> key{vertex.position.y, vertex.position.z};
            if (instance.block == 0 && vertex.position.x == 192.0f) {
                western[key] = vertex.normal;
            } else if (instance.block == 1 && vertex.position.x == 0.0f) {
                ASSERT_TRUE(western.contains(key));
                EXPECT_NEAR(glm::length(western[key] - vertex.normal), 0.0f, 1e-6f);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 8);
}

CellCorners cornersOf(std::array<std::uint32_t, 4> terrain, std::array<std::uint32_t, 4> road = {}) {
    return {terrain, road};
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> overlaysOf(std::array<std::uint32_t, 4> terrain) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (const BlendLayer& layer : blendRecipe(cornersOf(terrain)).overlays)
        out.emplace_back(layer.terrainType, layer.code);
    return out;
}

TEST(BlendRecipe, laysTypesOverTheCommonestEarlyOne) {
    using P = std::pair<std::uint32_t, std::uint32_t>;
    EXPECT_THAT(overlaysOf({5, 5, 5, 5}), IsEmpty());
    EXPECT_THAT(overlaysOf({1, 2, 3, 4}), ElementsAre(P{2, 2}, P{3, 4}, P{4, 8}));
    EXPECT_THAT(overlaysOf({1, 1, 2, 2}), ElementsAre(P{2, 12})) << "a side";
    EXPECT_THAT(overlaysOf({2, 1, 1, 2}), ElementsAre(P{1, 6})) << "the first pair is SW and NW";
    EXPECT_THAT(overlaysOf({2, 1, 1, 3}), ElementsAre(P{2, 1}, P{3, 8}));
    EXPECT_THAT(overlaysOf({1, 2, 1, 2}), ElementsAre(P{2, 2}, P{2, 8}))
        << "opposite corners stay two overlays";
    EXPECT_THAT(overlaysOf({2, 1, 1, 1}), ElementsAre(P{2, 1}));
    EXPECT_EQ(blendRecipe(cornersOf({2, 1, 1, 3})).base, 1u);
    EXPECT_EQ(blendRecipe(cornersOf({1, 2, 3, 4})).base, 1u);
}

TEST(BlendRecipe, wrapsNoSideFromNorthWestToSouthWest) {
    using P = std::pair<std::uint32_t, std::uint32_t>;
    EXPECT_THAT(overlaysOf({4, 7, 7, 4}), ElementsAre(P{7, 6}));
    // Base is the pair 7,7 in SE and NE only if SW and NW differ from each other; equal ones are the base
    // themselves.
    EXPECT_EQ(blendRecipe(cornersOf({4, 7, 7, 4})).base, 4u);
}

TEST(BlendRecipe, splitsRoadsIntoAtMostTwoCodes) {
    const auto roads = [](std::uint32_t mask) {
        return blendRecipe(cornersOf({1, 1, 1, 1}, {mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1}))
            .roadCodes;
    };
    EXPECT_THAT(roads(0), IsEmpty());
    EXPECT_THAT(roads(0xE), ElementsAre(6u, 12u));
    EXPECT_THAT(roads(0xD), ElementsAre(9u, 12u));
    EXPECT_THAT(roads(0xB), ElementsAre(9u, 3u));
    EXPECT_THAT(roads(0x7), ElementsAre(3u, 6u));
    EXPECT_THAT(roads(0x5), ElementsAre(5u));
    EXPECT_THAT(roads(0xF), IsEmpty());
    EXPECT_EQ(blendRecipe(cornersOf({1, 2, 3, 4}, {1, 2, 3, 1})).base, kRoadType);
    EXPECT_THAT(blendRecipe(cornersOf({1, 2, 3, 4}, {1, 2, 3, 1})).overlays, IsEmpty());
}

TEST(PaletteCode, packsCorners) {
    EXPECT_EQ(paletteCode(cornersOf({1, 2, 3, 4}, {3, 0, 1, 2})),
              1u << 28 | 3u << 26 | 1u << 22 | 2u << 20 | 1u << 15 | 2u << 10 | 3u << 5 | 4u);
}

TEST(AlphaMaps, areTurnedIntoPlace) {
    const std::vector<std::uint32_t> corner{8}, side{9}, roads{8, 9, 10};
    EXPECT_EQ(chooseTerrainMap(corner, 8, 0)->rotation, 0u);
    EXPECT_EQ(chooseTerrainMap(corner, 1, 0)->rotation, 1u);
    EXPECT_EQ(chooseTerrainMap(corner, 4, 0)->rotation, 3u);
    EXPECT_EQ(chooseTerrainMap(side, 3, 0)->rotation, 1u);
    EXPECT_EQ(chooseTerrainMap(side, 12, 0)->rotation, 3u);
    EXPECT_FALSE(chooseTerrainMap(side, 8, 0))
        << "no rotation turns a side into a corner: the overlay is dropped";
    EXPECT_FALSE(chooseTerrainMap({}, 8, 0));
    for (std::uint32_t palette = 0; palette < 50; ++palette) {
        ASSERT_TRUE(chooseRoadMap(roads, 5, palette)) << "for roads, the search continues until a map fits";
        EXPECT_EQ(chooseRoadMap(roads, 5, palette)->map, 2u);
    }
    EXPECT_EQ(chooseRoadMap(roads, 5, 0)->rotation, 1u);
}

TEST(TerrainCells, arePaintedFromTheRegionsTextures) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1, 1);
    source.terrain(source.home()).terrain[9 + 1] = 2 << 2;         // one vertex of ice: corners of four cells
    source.terrain(source.home()).terrain[5 * 9 + 5] = 1 << 2 | 1; // one road vertex
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.terrainCells.size(), 64u);
    const TerrainCell& plain = world.terrainCells[63];
    EXPECT_NE(plain.base.texture, kNone);
    EXPECT_EQ(plain.base.tiling, 2.0f);
    EXPECT_EQ(plain.overlays[0].texture, kNone);
    const TerrainCell& iced = world.terrainCells[0]; // its north-east corner
    EXPECT_NE(iced.overlays[0].texture, kNone);
    EXPECT_EQ(iced.overlays[0].rotation, 3u);
    const TerrainCell& paved = world.terrainCells[5 * 8 + 5]; // its south-west corner
    EXPECT_NE(paved.roads[0].alpha, kNone);
    EXPECT_EQ(paved.roads[0].rotation, 1u);
    EXPECT_EQ(paved.split, splitsSouthWestNorthEast({0x20, 0x30}, 5, 5) ? 1u : 0u);
    EXPECT_EQ(world.textures[plain.base.texture]->rgba[1], 0x80) << "grassland";
}

TEST(TerrainCells, ofWaterArePaintedAsOtherGround) {
    constexpr std::uint8_t kWater = 18;
    TestWorld source;
    source.setFlatTerrain(source.home(), 1, kWater);
    auto& rows = source.region().texMerge.textures;
    dat::TerrainTexture row = rows.front();
    row.terrainType = kWater;
    row.texture = rows[2].texture;
    rows.push_back(row);
    const World world = test::loadTestWorld(source);
    for (const TerrainCell& cell : world.terrainCells) {
        EXPECT_EQ(world.textures.at(cell.base.texture)->rgba[0], 0xC0) << "the picture of its row";
        EXPECT_EQ(cell.overlays[0].texture, kNone);
    }
    for (const Instance& instance : world.instances)
        EXPECT_EQ(instance.kind, InstanceKind::Terrain) << "no surface of water is added";
}

TEST(IsOnRoad, followsTheTableOfTheFormat) {
    Ground ground;
    const auto pave = [&](std::initializer_list<std::pair<int, int>> vertices) {
        ground.words.fill(0);
        for (const auto& [x, y] : vertices)
            ground.words[static_cast<std::size_t>(x * 9 + y)] = 1;
    };
    pave({{0, 0}, {0, 1}}); // along the western edge
    EXPECT_TRUE(isOnRoad(ground, 4.9, 12));
    EXPECT_FALSE(isOnRoad(ground, 5.1, 12));
    pave({{0, 0}, {1, 1}});
    EXPECT_TRUE(isOnRoad(ground, 12, 15));
    EXPECT_FALSE(isOnRoad(ground, 12, 18));
    pave({{1, 1}});
    EXPECT_TRUE(isOnRoad(ground, 22, 22));
    EXPECT_TRUE(isOnRoad(ground, 25, 25)) << "the next cell's south-west corner";
    EXPECT_FALSE(isOnRoad(ground, 12, 12));
    pave({});
    EXPECT_FALSE(isOnRoad(ground, 0, 0));
}

TEST(IsOnRoad, agreesWithTheStatedCases) {
    struct Case {
        std::string_view
            roads; ///< corners of the landcell: A south-west, B north-west, C south-east, D north-east
        double x, y;
        bool isOn;
    };
    for (const Case& c :
         {Case{"A", 1, 1, true},  {"A", 12, 12, false},    {"B", 1, 23, true},      {"C", 23, 1, true},
          {"D", 23, 23, true},    {"AB", 1, 12, true},     {"AC", 12, 1, true},     {"CD", 23, 12, true},
          {"BD", 12, 23, true},   {"AD", 12, 12, true},    {"AD", 2, 22, false},    {"BC", 12, 12, true},
          {"BC", 2, 2, false},    {"ABC", 1, 20, true},    {"ABD", 12, 23, true},   {"ACD", 12, 1, true},
          {"BCD", 12, 23, true},  {"ABCD", 12, 12, true},  {"", 12, 12, false},     {"AB", 4.999, 12, true},
          {"AB", 5.0, 12, false}, {"CD", 19.0, 12, false}, {"CD", 19.001, 12, true}}) {
        Ground ground;
        for (const char corner : c.roads) {
            const std::size_t x = corner == 'C' || corner == 'D' ? 1 : 0,
                              y = corner == 'B' || corner == 'D' ? 1 : 0;
            ground.words[x * 9 + y] = 1;
        }
        EXPECT_EQ(isOnRoad(ground, c.x, c.y), c.isOn) << c.roads << " at " << c.x << "," << c.y;
    }
}

struct Grove {
    TestWorld source;
    dat::SceneObject tree;
    Grove() {
        tree.object = source.addModel(test::boxExterior({-0.2, -0.2, 0}, {0.2, 0.2, 3}));
        tree.frequency = 1.0f;
        tree.baseLoc.origin = {3, 4, 0};
        source.setFlatTerrain(source.home(), 3, 1);
        source.region().partsMask |= dat::Region::kScene;
        source.region().sceneTypes = {{0, {0x12000001}}};
        source.region().terrainTypes[1].sceneTypes = {0};
    }
    World load() {
        dat::Scene scene;
        scene.id = 0x12000001;
        scene.objects = {tree};
        source.add(scene);
        return test::loadTestWorld(source);
    }
    static std::vector<const Instance*> trees(const World& world) {
        std::vector<const Instance*> out;
        for (const Instance& instance : world.instances)
            if (instance.kind == InstanceKind::Scenery)
                out.push_back(&instance);
        return out;
    }
};

TEST(Scenery, growsAtEveryVertexInTheQuadrantOfChance) {
    Grove grove;
    const World world = grove.load();
    const auto trees = Grove::trees(world);
    std::size_t expected = 0, at = 0;
    for (int vertex = 0; vertex < 81; ++vertex) {
        const double q = landRandom(static_cast<std::uint32_t>(0x20 * 8 + vertex / 9),
                                    static_cast<std::uint32_t>(0x30 * 8 + vertex % 9), seed::kQuadrant);
        const Vec2 offset = q >= 0.75   ? Vec2(4, -3)
                            : q >= 0.5  ? Vec2(-3, -4)
                            : q >= 0.25 ? Vec2(-4, 3)
                                        : Vec2(3, 4);
        const Vec2 place = Vec2(vertex / 9 * 24, vertex % 9 * 24) + offset;
        if (place.x < 0 || place.y < 0 || place.x >= 192 || place.y >= 192)
            continue;
        ++expected;
        ASSERT_LT(at, trees.size());
        EXPECT_NEAR(glm::length(Vec3(trees[at]->origin) - Vec3(place, 6.0)), 0.0, 1e-4);
        EXPECT_EQ(trees[at]->object, static_cast<std::uint64_t>(dat::landBlockId({0x20, 0x30})) << 32 | at);
        ++at;
    }
    EXPECT_EQ(trees.size(), expected);
    EXPECT_GT(expected, 50u);
}

TEST(Scenery, standsOnAllBlocksWithContent_notOnTheNearestNineAlone) {
    Grove grove;
    const dat::BlockCoord far{grove.source.home().x + 3, grove.source.home().y};
    grove.source.setFlatTerrain(far, 3, 1);
    dat::Scene scene;
    scene.id = 0x12000001;
    scene.objects = {grove.tree};
    grove.source.add(scene);
    const World world = test::loadTestWorld(grove.source, {.radius = 3});
    const auto trees = Grove::trees(world);
    const auto ofFar = [&](const Instance* tree) { return tree->object >> 32 == dat::landBlockId(far); };
    EXPECT_GT(std::count_if(trees.begin(), trees.end(), ofFar), 50);
}

TEST(Scenery, staysAwayFromRoadsBuildingsAndSteepGround) {
    Grove paved;
    for (std::uint16_t& word : paved.source.terrain(paved.source.home()).terrain)
        word = static_cast<std::uint16_t>(word | 1);
    EXPECT_TRUE(Grove::trees(paved.load()).empty());
    Grove built;
    TestWorld::BuildingOptions options;
    options.frame = test::frameAt({60, 60, 6});
    built.source.addBuilding(test::boxExterior({55, 55, 6}, {65, 65, 9}), {}, options);
    const World builtWorld = built.load();
    for (const Instance* tree : Grove::trees(builtWorld)) {
        const bool inCell =
            tree->origin.x >= 48 && tree->origin.x < 72 && tree->origin.y >= 48 && tree->origin.y < 72;
        EXPECT_FALSE(inCell);
    }
    Grove steep;
    steep.tree.maxSlope = 0.99f;
    EXPECT_TRUE(Grove::trees(steep.load()).empty()) << "flat ground has a slope of 1";
}

TEST(Scenery, scalesAndTurnsByChanceAndIgnoresWeenies) {
    Grove grove;
    grove.tree.minScale = 0.5f;
    grove.tree.maxScale = 2.0f;
    grove.tree.maxRotation = 360.0f;
    const World world = grove.load();
    float smallest = 10.0f, largest = 0.0f;
    for (const Instance* tree : Grove::trees(world)) {
        const float scale = std::cbrt(glm::determinant(tree->linear));
        EXPECT_NEAR(glm::length(tree->linear[2] - Vec3f(0, 0, scale)), 0.0f, 1e-4f) << "upright";
        smallest = std::min(smallest, scale);
        largest = std::max(largest, scale);
    }
    EXPECT_GE(smallest, 0.5f);
    EXPECT_LE(largest, 2.0f);
    EXPECT_LT(smallest, 0.8f);
    EXPECT_GT(largest, 1.5f);
    Grove weenies;
    weenies.tree.weenieObj = 1;
    EXPECT_TRUE(Grove::trees(weenies.load()).empty());
}

TEST(Scenery, keepsThePitchOfItsBaseWhenItIsTurned) {
    Grove grove;
    const double pitch = -1.1 * kDegree;
    grove.tree.baseLoc.orientation =
        Quatf(static_cast<float>(std::cos(pitch / 2)), static_cast<float>(std::sin(pitch / 2)), 0.0f, 0.0f);
    for (const bool isTurned : {false, true}) {
        grove.tree.maxRotation = isTurned ? 360.0f : 0.0f;
        Grove grown = grove;
        const World world = grown.load();
        double most = 0.0;
        for (const Instance* tree : Grove::trees(world)) {
            EXPECT_NEAR(tree->linear[1].z, std::sin(pitch), 1e-6);
            EXPECT_NEAR(tree->linear[0].z, 0.0, 1e-6) << "no roll";
            most = std::max(most, std::abs(static_cast<double>(tree->linear[1].x)));
        }
        EXPECT_EQ(most > 0.5, isTurned);
    }
}

TEST(Scenery, leavesOutObjectsThatReachAcrossTheBlocksBorder) {
    const Vec3 near(3.0, 100.0, 0.0);
    const Quat upright(1.0, 0.0, 0.0, 0.0), turned = glm::angleAxis(180.0 * kDegree, Vec3(0, 0, 1));
    TestWorld source;
    const std::uint32_t mesh = source.addModel(test::boxExterior({-0.2, -0.2, 0}, {0.2, 0.2, 3}));
    dat::Setup bare;
    bare.parts = {mesh};
    bare.sortingSphere = {Vec3f(1.0f, 0, 1), 3.5f};
    dat::Setup solid = bare, round = bare, posts = bare;
    solid.flags = dat::Setup::kPhysicsBsp;
    solid.cylSpheres = {{Vec3f(0.0f), 0.1f, 1.0f}};
    round.spheres = {{Vec3f(0.0f), 0.1f}};
    posts.cylSpheres = {{Vec3f(0.0f), 0.1f, 1.0f}, {Vec3f(-2.0f, 0, 0), 0.9f, 1.0f}};
    const std::uint32_t bareId = source.addSetup(bare), solidId = source.addSetup(solid),
                        roundId = source.addSetup(round), postsId = source.addSetup(posts);
    const test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    const auto fits = [&](std::uint32_t model, const Vec3& at, const Quat& turn) {
        return isWithinBlock(model, at, turn, records);
    };
    EXPECT_TRUE(fits(bareId, {0.01, 0.01, 0}, upright)) << "its origin counts";
    EXPECT_FALSE(fits(bareId, {192.0, 1, 0}, upright));
    for (const std::uint32_t model : {solidId, roundId}) {
        EXPECT_TRUE(fits(model, near, upright)) << "the sorting sphere's middle is 4 m from the edge";
        EXPECT_FALSE(fits(model, near, turned)) << "2 m";
        EXPECT_FALSE(fits(model, {189, 100, 0}, upright));
        EXPECT_FALSE(fits(model, {100, 3.4, 0}, upright));
        EXPECT_FALSE(fits(model, {100, 188.6, 0}, upright));
    }
    EXPECT_TRUE(fits(postsId, near, upright)) << "the second post is 1 m from the edge";
    EXPECT_FALSE(fits(postsId, {2.8, 100, 0}, upright));
    EXPECT_TRUE(fits(postsId, {2.8, 100, 0}, turned));
    EXPECT_TRUE(fits(0x02FFFFFF, near, upright)) << "a missing record is reported elsewhere";
}

} // namespace
} // namespace limen::world
