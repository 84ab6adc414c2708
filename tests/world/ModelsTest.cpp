#include "world/mesh/Models.h"

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

    Model model(dat::RecordId id, double detail = 1.0) {
        const test::TempDir directory;
        EXPECT_TRUE(source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        Records records(*archive);
        Models models(records, detail);
        return models.model(id);
    }
};

using Ids = std::vector<dat::RecordId>;
constexpr std::uint32_t kSecond = 0x01000001, kThird = 0x01000002, kItself = test::TestWorld::kItself;
constexpr std::uint32_t kMesh = dat::DegradeLevel::kMesh, kSprite = 2;

Ids idsOf(const std::vector<ModelPart>& parts) {
    Ids ids;
    for (const ModelPart& part : parts)
        ids.push_back(part.gfxObj);
    return ids;
}

std::vector<LevelRange> levelRangesOf(const std::vector<ModelPart>& parts) {
    std::vector<LevelRange> ranges;
    for (const ModelPart& part : parts)
        ranges.push_back(part.levelRange);
    return ranges;
}

TEST(Models, takeEachLevelOfDetailUpToItsGreatestDistance) {
    Levels levels({{kSecond, kMesh, 0, 10, 20}, {kThird, kMesh, 20, 30, 40.03f}, {0, kMesh, 40, 50, 60}});
    const Model model = levels.model(levels.setup);
    EXPECT_EQ(idsOf(model.parts), (Ids{kSecond, kSecond}))
        << "the nearest level of the first part, and the second part";
    EXPECT_EQ(levelRangesOf(model.parts), (std::vector<LevelRange>{{0, 20 * 16}, {}}));
    EXPECT_EQ(idsOf(model.farther), Ids{kThird});
    EXPECT_EQ(levelRangesOf(model.farther), (std::vector<LevelRange>{{20 * 16, 40 * 16}}))
        << "to the nearest sixteenth";
}

TEST(Models, boundsContainFartherLevelsOfDetail) {
    Levels levels({{kItself, kMesh, 0, 0, 5}, {kThird, kMesh, 0, 0, 9}});
    EXPECT_NEAR(levels.model(levels.first).bounds.radius, 3 * std::sqrt(3.0) / 2, 0.1);
}

TEST(Models, changeLevelsSoMuchFartherAwayAsDetailSays) {
    Levels levels({{kItself, kMesh, 0, 0, 5}, {kThird, kMesh, 0, 0, 9}});
    const Model finer = levels.model(levels.first, 2.5);
    EXPECT_EQ(levelRangesOf(finer.parts), (std::vector<LevelRange>{{0, 200}}));
    EXPECT_EQ(levelRangesOf(finer.farther), (std::vector<LevelRange>{{200, 360}}));
    const Model finest = levels.model(levels.first, std::numeric_limits<double>::infinity());
    EXPECT_EQ(levelRangesOf(finest.parts), std::vector<LevelRange>(1));
    EXPECT_EQ(idsOf(finest.farther), Ids{});
}

TEST(Models, keepAMeshWhereASpriteWouldTakeItsPlace) {
    Levels levels({{kItself, kMesh, 0, 0, 5}, {kThird, kSprite, 0, 0, 9}, {kSecond, kMesh, 0, 0, 11}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(idsOf(model.parts), Ids{levels.first});
    EXPECT_EQ(levelRangesOf(model.parts), (std::vector<LevelRange>{{0, 9 * 16}}));
    EXPECT_EQ(levelRangesOf(model.farther), (std::vector<LevelRange>{{9 * 16, 11 * 16}}));
}

TEST(Models, leaveOutPartsThatShowNothingFromNearby) {
    Levels levels({{0, kMesh, 0, 0, 1000}});
    EXPECT_EQ(idsOf(levels.model(levels.first).parts), Ids{});
    EXPECT_EQ(idsOf(levels.model(levels.setup).parts), Ids{kSecond});
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
                   {kThird, kMesh, 0, 0, none},
                   {kSecond, kMesh, 0, 0, 90}});
    const Model model = levels.model(levels.first);
    EXPECT_EQ(levelRangesOf(model.parts), (std::vector<LevelRange>{{0, 160}}));
    EXPECT_EQ(idsOf(model.farther), Ids{kThird});
    EXPECT_EQ(levelRangesOf(model.farther), (std::vector<LevelRange>{{160, LevelRange::kEndless}}));
}

} // namespace
} // namespace limen::world
