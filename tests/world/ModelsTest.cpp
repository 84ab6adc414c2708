#include "world/mesh/Models.h"

#include "world/mesh/ModelCache.h"

#include "support/LoadTestWorld.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace limen::world {
namespace {

/// Two boxes, and a setup of both. The first has levels of detail.
struct Levels {
    test::TestWorld source;
    std::uint32_t second = source.addModel(test::boxExterior({0, 0, 0}, {2, 2, 2}));
    std::uint32_t third = source.addModel(test::boxExterior({0, 0, 0}, {3, 3, 3}));
    std::uint32_t first = 0, setup = 0;

    explicit Levels(const std::vector<dat::DegradeLevel>& levels) {
        first = source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}), levels);
        dat::Setup both;
        both.parts = {first, second};
        setup = source.addSetup(both);
    }

    Model model(dat::RecordId id, double detail = 1.0) { return model(id, LevelLimits{detail, 1.0}); }
    Model model(dat::RecordId id, const LevelLimits& limits) {
        const test::TempDir directory;
        EXPECT_TRUE(source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        Records records(*archive);
        Models models(records, limits);
        return models.model(id);
    }
};

using Ids = std::vector<dat::RecordId>;
constexpr std::uint32_t kSecond = 0x01000001, kThird = 0x01000002, kItself = test::TestWorld::kItself;
constexpr std::uint32_t kMesh = dat::DegradeLevel::kMesh;

Ids idsOf(const std::vector<ModelPart>& parts) {
    Ids ids;
    for (const ModelPart& part : parts)
        ids.push_back(part.gfxObj);
    return ids;
}

constexpr double kEndless = std::numeric_limits<double>::infinity();

std::vector<LevelBand> bandsOf(const std::vector<ModelPart>& parts) {
    std::vector<LevelBand> bands;
    for (const ModelPart& part : parts)
        bands.push_back(part.band);
    return bands;
}
using Bands = std::vector<LevelBand>;

std::vector<Facing> facingsOf(const std::vector<ModelPart>& parts) {
    std::vector<Facing> facings;
    for (const ModelPart& part : parts)
        facings.push_back(part.facing);
    return facings;
}

// A typical tree of the original game: docs/formats/geometry.md, 50 m are subtracted from the distance.
TEST(Models, changeLevels50MetresBeyondTheirGreatestDistance) {
    constexpr float kMost = std::numeric_limits<float>::max();
    Levels levels({{kItself, kMesh, 10, 25, 50},
                   {kThird, kMesh, 25, 50, 100},
                   {kSecond, kMesh, 50, 100, 200},
                   {0, kMesh, kMost, kMost, kMost}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(idsOf(model.parts), Ids{levels.first});
    EXPECT_EQ(bandsOf(model.parts), (Bands{{0, 100}}));
    EXPECT_EQ(idsOf(model.farther), (Ids{kThird, kSecond}));
    EXPECT_EQ(bandsOf(model.farther), (Bands{{100, 150}, {150, 250}})) << "then nothing";
}

TEST(Models, measureTheLevelsOfAllPartsFromTheirObject) {
    Levels levels({{kItself, kMesh, 10, 25, 50}, {kThird, kMesh, 25, 50, 100}});
    dat::Setup apart;
    apart.parts = {levels.first, levels.first};
    apart.placementFrames = {
        {dat::Setup::kPlacementDefault, {{test::frameAt({9, 0, 0}), test::frameAt({-9, 0, 4})}, {}}}};
    levels.source.setFlatTerrain(levels.source.home(), 1);
    levels.source.addObject(levels.source.addSetup(apart), test::frameAt({70, 80, 2}));
    const World world = test::loadTestWorld(levels.source);
    std::size_t parts = 0;
    for (const Instance& instance : world.instances) {
        if (instance.level == kNone)
            continue;
        ++parts;
        EXPECT_EQ(world.levels[instance.level].origin, localRangeSteps({70, 80, 2}));
    }
    EXPECT_EQ(parts, 4u) << "two levels of two parts";
}

TEST(Models, drawTheLastLevelAtEveryDistanceThatIsLeft) {
    Levels levels({{kSecond, kMesh, 0, 10, 20}, {kThird, kMesh, 20, 30, 40}});
    const Model model = levels.model(levels.setup);
    EXPECT_EQ(idsOf(model.parts), (Ids{kSecond, kSecond}))
        << "the nearest level of the first part, and the second part";
    EXPECT_EQ(bandsOf(model.parts), (Bands{{0, 70}, {}}));
    EXPECT_EQ(idsOf(model.farther), Ids{kThird});
    EXPECT_EQ(bandsOf(model.farther), (Bands{{70, kEndless}}));
}

TEST(Models, boundsContainFartherLevelsOfDetail) {
    Levels levels({{kItself, kMesh, 0, 0, 5}, {kThird, kMesh, 0, 0, 9}});
    EXPECT_NEAR(levels.model(levels.first).bounds.radius, 3 * std::sqrt(3.0) / 2, 0.1);
}

TEST(Models, boundsContainEveryTurnOfABillboard) {
    Levels fixed({{kThird, kMesh, 0, 0, 5}});
    const Sphere still = fixed.model(fixed.first).bounds;
    for (const std::uint32_t mode : {2u, 3u, 4u, 5u}) {
        Levels levels({{kThird, mode, 0, 0, 5}});
        const Sphere bounds = levels.model(levels.first).bounds;
        EXPECT_NEAR(glm::length(bounds.centre), 0.0, 1e-9) << "it turns about its origin";
        EXPECT_NEAR(bounds.radius, glm::length(still.centre) + still.radius, 1e-6);
    }
}

TEST(Models, scaleTheGreatestDistancesByDetail) {
    Levels levels({{kItself, kMesh, 0, 0, 5}, {kThird, kMesh, 0, 0, 9}});
    const Model finer = levels.model(levels.first, 2.5);
    EXPECT_EQ(bandsOf(finer.parts), (Bands{{0, 62.5}}));
    EXPECT_EQ(bandsOf(finer.farther), (Bands{{62.5, kEndless}}));
    const Model finest = levels.model(levels.first, kEndless);
    EXPECT_EQ(bandsOf(finest.parts), Bands(1));
    EXPECT_EQ(idsOf(finest.farther), Ids{});
}

// ideal + b (max - ideal) for b >= 0, else ideal + b (ideal - min): docs/formats/geometry.md.
TEST(Models, changeLevelsByTheQualityBias) {
    Levels levels({{kItself, kMesh, 10, 25, 50}, {kThird, kMesh, 30, 50, 100}, {kSecond, kMesh, 0, 0, 900}});
    for (const auto& [bias, first, second] : {std::tuple{1.0, 100.0, 150.0},
                                              {0.5, 87.5, 125.0},
                                              {0.0, 75.0, 100.0},
                                              {-0.5, 67.5, 90.0},
                                              {-1.0, 60.0, 80.0}}) {
        const Model model = levels.model(levels.first, LevelLimits{1.0, bias});
        EXPECT_EQ(bandsOf(model.parts), (Bands{{0, first}})) << bias;
        EXPECT_EQ(bandsOf(model.farther), (Bands{{first, second}, {second, kEndless}})) << bias;
    }
    EXPECT_EQ(bandsOf(levels.model(levels.first, LevelLimits{2.0, 0.0}).parts), (Bands{{0, 100}}));
}

TEST(Models, ofEachQualityBiasAreCachedApart) {
    Levels levels({{kItself, kMesh, 10, 25, 50}, {kThird, kMesh, 25, 50, 100}});
    const test::TempDir directory;
    ASSERT_TRUE(levels.source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Records records(*archive);
    ModelCache cache(1 << 20, 1 << 20);
    for (const auto& [bias, upTo] : {std::pair{1.0, 100.0}, {0.0, 75.0}, {1.0, 100.0}}) {
        Models models(records, {.bias = bias}, &cache);
        EXPECT_EQ(bandsOf(models.model(levels.first).parts), (Bands{{0, upTo}}));
    }
}

TEST(Models, turnLevelsByTheirMode) {
    Levels levels({{kItself, 1, 0, 0, 5},
                   {kThird, 2, 0, 0, 9},
                   {kSecond, 3, 0, 0, 11},
                   {kSecond, 4, 0, 0, 12},
                   {kSecond, 5, 0, 0, 13},
                   {kThird, 6, 0, 0, 14}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(facingsOf(model.parts), std::vector{Facing::Fixed});
    EXPECT_EQ(facingsOf(model.farther),
              (std::vector{Facing::Eye, Facing::AroundX, Facing::AroundY, Facing::AroundZ, Facing::Fixed}));
}

TEST(Models, leaveOutMarkers) {
    constexpr float kMost = std::numeric_limits<float>::max();
    for (const double detail : {1.0, kEndless}) {
        Levels ended({{kItself, kMesh, 0, 0, 0}, {0, kMesh, kMost, kMost, kMost}});
        EXPECT_EQ(idsOf(ended.model(ended.first, detail).parts), Ids{});
        EXPECT_EQ(idsOf(ended.model(ended.first, detail).farther), Ids{});
        EXPECT_EQ(idsOf(ended.model(ended.setup, detail).parts), Ids{kSecond});
        Levels alone({{kItself, kMesh, 0, 0, 0}});
        EXPECT_EQ(idsOf(alone.model(alone.first, detail).parts), Ids{});
    }
}

TEST(Models, drawNothingWhereALevelHasNoMesh) {
    Levels levels({{0, kMesh, 0, 0, 10}, {kThird, kMesh, 0, 0, 90}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(idsOf(model.parts), Ids{});
    EXPECT_EQ(bandsOf(model.farther), (Bands{{60, kEndless}}));
}

TEST(Models, drawThePartItselfWhereItsLevelsAreNotThere) {
    Levels levels({});
    EXPECT_EQ(idsOf(levels.model(levels.first).parts), Ids{levels.first});
    EXPECT_EQ(idsOf(levels.model(levels.second).parts), Ids{levels.second});
}

TEST(Models, copeWithDistancesThatAreNone) {
    const float none = std::numeric_limits<float>::quiet_NaN();
    Levels levels({{kItself, kMesh, 0, 0, 10},
                   {kSecond, kMesh, 0, 0, -4},
                   {kSecond, kMesh, 0, 0, none},
                   {kThird, kMesh, 0, 0, none}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(bandsOf(model.parts), (Bands{{0, 60}}));
    EXPECT_EQ(idsOf(model.farther), Ids{kThird}) << "no distance is less than none; the last level is left";
    EXPECT_EQ(bandsOf(model.farther), (Bands{{60, kEndless}}));
}

TEST(LevelBands, areDividedByTheScalesZ) {
    EXPECT_EQ(levelRangeOf({0, 100}, 1.0), (LevelRange{0, 1600}));
    EXPECT_EQ(levelRangeOf({100, 150}, 0.5), (LevelRange{800, 1200}));
    EXPECT_EQ(levelRangeOf({100, 150}, -2.0), (LevelRange{3200, 4800}));
    EXPECT_EQ(levelRangeOf({100, kEndless}, 2.0), (LevelRange{3200, LevelRange::kEndless}));
    EXPECT_EQ(levelRangeOf({100, 150}, 0.0), levelRangeOf({100, 150}, 1.0));
    EXPECT_EQ(levelRangeOf({100, 150}, std::nan("")), levelRangeOf({100, 150}, 1.0));
}

/// Vectors of the emitter's reach: the second-last level, or the only one; 100 m without levels.
TEST(Models, emittersReachTheSecondLastLevelOfTheirMesh) {
    const auto reachOf = [](const std::vector<dat::DegradeLevel>& levels) {
        test::TestWorld source;
        const std::uint32_t mesh = source.addModel(test::boxExterior({0, 0, 0}, {1, 1, 1}), levels);
        const test::TempDir directory;
        EXPECT_TRUE(source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        Records records(*archive);
        return Models(records).particleBand(mesh);
    };
    const float max = std::numeric_limits<float>::max();
    EXPECT_EQ(
        reachOf({{kItself, kMesh, 0, 10, 20}, {kItself, kMesh, 0, 30, 40}, {kItself, kMesh, 0, 60, max}}),
        (LevelBand{0.0, 40.0}));
    EXPECT_EQ(reachOf({{kItself, kMesh, 0, 10, 20}, {kItself, kMesh, 0, 30, max}}), (LevelBand{0.0, 20.0}));
    EXPECT_EQ(reachOf({}), (LevelBand{0.0, 100.0}));
}

TEST(Models, aFirstLevelUpToNoDistanceIsNeverDrawn) {
    Levels levels({{kItself, kMesh, 0, 0, 0}, {kSecond, kMesh, 0, 10, 20}, {0, kMesh, 0, 0, 0}});
    EXPECT_EQ(idsOf(levels.model(levels.first).parts), (Ids{kSecond}));
}

} // namespace
} // namespace limen::world
