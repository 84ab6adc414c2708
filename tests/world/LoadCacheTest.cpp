#include "world/load/LoadCache.h"

#include "support/LoadTestWorld.h"
#include "support/SameWorld.h"

#include <rapidcheck/gtest.h>

namespace limen::world {
namespace {

using test::rectangle;
using test::TestWorld;

constexpr dat::BlockCoord kHome{0x20, 0x30};

/// 7 x 7 blocks of hills with houses, objects and lamps. Some records are missing or damaged, and one block
/// does not exist.
class Patchwork {
public:
    Patchwork() {
        const std::uint32_t crate = source_.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}, "wood"));
        const std::uint32_t bare = source_.addModel(test::boxExterior({0, 0, 0}, {1, 2, 1}, "lost"));
        const std::uint32_t missing = 0x01000777;
        dat::Setup lamp;
        lamp.parts = {crate, missing};
        dat::LightInfo light;
        light.intensity = 1.0f;
        light.falloff = 6.0f;
        lamp.lights.push_back({0, light});
        const std::uint32_t lampId = source_.addSetup(lamp);
        for (int x = -3; x <= 3; ++x) {
            for (int y = -3; y <= 3; ++y) {
                const dat::BlockCoord block{kHome.x + x, kHome.y + y};
                if (x == 2 && y == 1)
                    continue; // this block does not exist
                source_.setFlatTerrain(block, static_cast<std::uint8_t>(3 + (x + 3) % 2), 1);
                source_.terrain(block).heights[static_cast<std::size_t>(40 + x + y)] = 9;
                if ((x + y) % 2 == 0)
                    addHouse(block, crate);
                source_.addObject(block, (x + 3) % 3 == 0 ? bare : lampId, test::frameAt({30, 30, 8}));
                if (y == -2)
                    source_.addObject(block, missing, test::frameAt({40, 30, 8}));
            }
        }
        EXPECT_TRUE(source_.write(directory_.path()));
        source_.portalFile().add(source_.surfaceId("lost"), dat::Bytes(3));
        EXPECT_TRUE(source_.portalFile().write(directory_.path() / "client_portal.dat"));
        Result<dat::Archive> archive = dat::Archive::open(directory_.path());
        EXPECT_TRUE(archive);
        archive_ = std::move(*archive);
    }

    [[nodiscard]] World load(dat::BlockCoord centre, const LoadOptions& options, const LoadHelp& help) const {
        Result<World> world = loadWorld(*archive_, centre, options, {}, help);
        EXPECT_TRUE(world) << (world ? "" : world.error().message());
        return world ? std::move(*world) : World{};
    }

private:
    void addHouse(dat::BlockCoord block, std::uint32_t crate) {
        TestWorld::CellOptions cell;
        cell.block = block;
        const auto room = source_.addBox({50, 50, 8}, {54, 54, 11}, "wood", cell);
        const auto rear = source_.addBox({50, 54, 8}, {54, 58, 11}, "lost", cell);
        source_.link(room, rectangle({51, 54, 8}, {52, 54, 10}), rear);
        const auto door = source_.openOutside(room, rectangle({51, 50, 8}, {52, 50, 10}));
        TestWorld::BuildingOptions building;
        building.block = block;
        source_.addBuilding(test::boxExterior({50, 50, 8}, {54, 58, 11}), {door}, building);
        source_.addStatic(room, crate, test::frameAt({52, 51, 8}));
    }

    TestWorld source_{kHome};
    test::TempDir directory_;
    std::optional<dat::Archive> archive_;
};

const Patchwork& patchwork() {
    static const Patchwork world;
    return world;
}

std::string difference(const World& a, const World& b) {
    const std::string names = test::differenceOf(a, b);
    return names.empty() ? names : names + "\n" + test::findingsOf(a) + "---\n" + test::findingsOf(b);
}

TEST(LoadCache, everyLoadReportsMissingRecords) {
    LoadCache cache;
    const World first = patchwork().load(kHome, {.radius = 1}, {&cache});
    const World again = patchwork().load(kHome, {.radius = 1}, {&cache});
    EXPECT_GE(first.findings.size(), 2u) << test::findingsOf(first);
    EXPECT_EQ(first.findings, again.findings);
    EXPECT_EQ(difference(first, again), "");
}

TEST(LoadCache, buildsABlockOnce) {
    LoadCache cache;
    (void)patchwork().load(kHome, {.radius = 1}, {&cache});
    EXPECT_EQ(cache.blocks.size(), 9u);
    const auto kept = cache.blocks.find({kHome.x, kHome.y});
    ASSERT_NE(kept, nullptr);
    (void)patchwork().load({kHome.x + 1, kHome.y}, {.radius = 1}, {&cache});
    EXPECT_EQ(cache.blocks.size(), 11u) << "two more: the third does not exist";
    EXPECT_EQ(cache.blocks.find({kHome.x, kHome.y}), kept);
}

TEST(LoadCache, worldsShareTheirPictures) {
    LoadCache cache;
    const World first = patchwork().load(kHome, {.radius = 1}, {&cache});
    const World second = patchwork().load({kHome.x + 1, kHome.y}, {.radius = 1}, {&cache});
    ASSERT_FALSE(first.textures.empty());
    for (const auto& picture : first.textures) {
        EXPECT_NE(picture->contentKey, 0u);
        EXPECT_EQ(std::count(second.textures.begin(), second.textures.end(), picture), 1);
    }
}

TEST(LoadCache, keepsNoMoreThanItMay) {
    LoadCache cache(std::size_t{1} << 20);
    for (int x = -3; x <= 3; ++x)
        (void)patchwork().load({kHome.x + x, kHome.y}, {.radius = 2}, {&cache});
    EXPECT_LE(cache.blocks.bytes() + cache.models.models.bytes() + cache.models.parts.bytes() +
                  cache.pictures.bytes(),
              std::size_t{1} << 20);
    EXPECT_EQ(cache.blocks.find({kHome.x - 3, kHome.y}), nullptr) << "the least recently used block";
    EXPECT_NE(cache.blocks.find({kHome.x + 3, kHome.y}), nullptr);
}

RC_GTEST_PROP(LoadCache, aWalkOverBlocksIsTheSameWithAndWithoutIt, ()) {
    LoadCache cache(*rc::gen::element<std::size_t>(1, 4, 64) << 20);
    dat::BlockCoord at{kHome.x + *rc::gen::inRange(-3, 4), kHome.y + *rc::gen::inRange(-3, 4)};
    const int steps = *rc::gen::inRange(1, 6);
    for (int i = 0; i < steps; ++i) {
        at.x = std::clamp(at.x + *rc::gen::inRange(-2, 3), kHome.x - 3, kHome.x + 3);
        at.y = std::clamp(at.y + *rc::gen::inRange(-2, 3), kHome.y - 3, kHome.y + 3);
        LoadOptions options;
        options.radius = *rc::gen::inRange(0, 3);
        options.farRadius = *rc::gen::element(0, 1, 4);
        options.mergeZones = *rc::gen::arbitrary<bool>();
        options.detail = *rc::gen::element(1.0, 0.5);
        const unsigned threads = *rc::gen::inRange(1u, 4u);
        if (at == dat::BlockCoord{kHome.x + 2, kHome.y + 1} && options.radius == 0 && options.farRadius == 0)
            continue; // this block does not exist
        const World kept = patchwork().load(at, options, {&cache, threads});
        const World fresh = patchwork().load(at, options, {});
        RC_ASSERT(difference(kept, fresh) == "");
    }
}

TEST(FarTier, hasTheGroundAlone) {
    const World near = patchwork().load(kHome, {.radius = 3}, {});
    const World world = patchwork().load(kHome, {.radius = 1, .farRadius = 3}, {});
    ASSERT_EQ(world.blocks.size(), near.blocks.size());
    std::size_t far = 0;
    for (std::size_t i = 0; i < world.blocks.size(); ++i) {
        const Block &block = world.blocks[i], &whole = near.blocks[i];
        const int away = std::max(std::abs(block.coord.x - kHome.x), std::abs(block.coord.y - kHome.y));
        EXPECT_EQ(block.isFar, away > 1);
        EXPECT_EQ(block.heights, whole.heights);
        far += block.isFar ? 1 : 0;
    }
    EXPECT_EQ(far, 39u);
    for (const Space& space : world.spaces)
        EXPECT_TRUE(space.block == kNone || !world.blocks[space.block].isFar);
    std::size_t grounds = 0;
    for (const Instance& instance : world.instances) {
        if (world.blocks[instance.block].isFar) {
            EXPECT_EQ(instance.kind, InstanceKind::Terrain);
            ++grounds;
        }
    }
    EXPECT_EQ(grounds, far);
}

TEST(FarTier, theNearTierIsAsItIsAlone) {
    const World alone = patchwork().load(kHome, {.radius = 1}, {});
    const World world = patchwork().load(kHome, {.radius = 1, .farRadius = 3}, {});
    ASSERT_EQ(world.spaces.size(), alone.spaces.size());
    for (std::size_t i = 0; i < world.spaces.size(); ++i)
        EXPECT_EQ(world.spaces[i].cellId, alone.spaces[i].cellId);
    EXPECT_EQ(world.portalVertices, alone.portalVertices);
    EXPECT_EQ(world.instances.size(), alone.instances.size() + 39);
}

TEST(FarTier, aSealedDungeonHasNone) {
    TestWorld source(kHome);
    source.addBox({0, 0, 0}, {4, 4, 3});
    (void)source.terrain(kHome); // all heights 0
    source.setFlatTerrain({kHome.x + 1, kHome.y}, 3);
    EXPECT_EQ(test::loadTestWorld(source, {.radius = 0, .farRadius = 3}).blocks.size(), 1u);
}

TEST(FarTier, leavesOutDungeons) {
    TestWorld source(kHome);
    source.setFlatTerrain(kHome, 3);
    TestWorld::CellOptions elsewhere;
    elsewhere.block = dat::BlockCoord{kHome.x + 2, kHome.y};
    source.addBox({0, 0, 0}, {4, 4, 3}, "grey", elsewhere);
    (void)source.terrain(*elsewhere.block); // all heights 0, with cells: a dungeon
    (void)source.terrain({kHome.x + 2, kHome.y + 1});
    const World world = test::loadTestWorld(source, {.radius = 0, .farRadius = 3});
    ASSERT_EQ(world.blocks.size(), 2u);
    EXPECT_EQ(world.blocks[1].coord, (dat::BlockCoord{kHome.x + 2, kHome.y + 1})) << "the sea";
    EXPECT_TRUE(world.blocks[1].hasTerrain);
}

} // namespace
} // namespace limen::world
