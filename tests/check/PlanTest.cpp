#include "check/Plan.h"

#include "check/House.h"

#include <numeric>

namespace limen::check {
namespace {

constexpr std::array<ViewKind, kKindCount> kEveryKind{
    ViewKind::Random, ViewKind::Outside,  ViewKind::Path,      ViewKind::Sweep,
    ViewKind::Still,  ViewKind::Straddle, ViewKind::Telephoto, ViewKind::Wide};

std::size_t sum(const KindCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

TEST(Plan, kindsShareTheBudget) {
    EXPECT_EQ(sum(shareAmongKinds(1000, kEveryKind)), 1000u);
    const std::array<ViewKind, 1> sweep{ViewKind::Sweep};
    const KindCounts only = shareAmongKinds(77, sweep);
    EXPECT_EQ(only[static_cast<std::size_t>(ViewKind::Sweep)], 77u);
    EXPECT_EQ(sum(only), 77u);
}

TEST(Plan, everyWantedKindGetsAView) {
    for (const std::size_t count : shareAmongKinds(1, kEveryKind))
        EXPECT_GE(count, 1u);
}

TEST(Plan, kindsWithoutAPlaceLeaveTheirShareToOthers) {
    const BlockSummary dungeon{{1, 1}, 30, false, false}, hills{{2, 2}, 0, false, true};
    const std::vector<ViewKind> below = kindsWithPlaces(kEveryKind, std::vector{dungeon});
    EXPECT_EQ(below,
              (std::vector<ViewKind>{ViewKind::Random, ViewKind::Path, ViewKind::Sweep, ViewKind::Still,
                                     ViewKind::Straddle, ViewKind::Telephoto, ViewKind::Wide}));
    EXPECT_EQ(sum(shareAmongKinds(50, below)), 50u);
    EXPECT_EQ(kindsWithPlaces(kEveryKind, std::vector{hills}), std::vector<ViewKind>{ViewKind::Outside});
    EXPECT_EQ(kindsWithPlaces(kEveryKind, std::vector{dungeon, hills}).size(), kEveryKind.size());
}

TEST(Plan, blocksShareByCells) {
    const std::vector<BlockSummary> blocks{
        {{1, 1}, 30, true, true}, {{1, 2}, 0, false, true}, {{9, 9}, 10, false, false}};
    KindCounts counts{};
    counts[static_cast<std::size_t>(ViewKind::Random)] = 40;
    counts[static_cast<std::size_t>(ViewKind::Outside)] = 26;
    const std::vector<BlockTask> tasks = planTasks(blocks, {}, counts);
    ASSERT_EQ(tasks.size(), 3u);
    EXPECT_EQ(tasks[0].counts[0], 30u);
    EXPECT_EQ(tasks[1].counts[0], 0u) << "no cells";
    EXPECT_EQ(tasks[2].counts[0], 10u);
    EXPECT_EQ(tasks[0].counts[1], 24u) << "has buildings";
    EXPECT_EQ(tasks[1].counts[1], 2u);
    EXPECT_EQ(tasks[2].counts[1], 0u) << "no landscape";
}

TEST(Plan, leavesOutBlocksWithoutAShare) {
    const std::vector<BlockSummary> blocks{{{1, 1}, 1, true, true}, {{1, 2}, 1, true, true}};
    KindCounts counts{};
    counts[static_cast<std::size_t>(ViewKind::Random)] = 1;
    EXPECT_EQ(planTasks(blocks, {}, counts).size(), 1u);
    EXPECT_TRUE(planTasks({}, {}, counts).empty());
}

TEST(Plan, halfOfThePathIsTheTourWhereThereIsOne) {
    const test::House house;
    const std::vector<BlockSummary> blocks{{house.source.home(), 2, true, true}};
    KindCounts counts{};
    counts[static_cast<std::size_t>(ViewKind::Path)] = 20;
    const auto with = planTasks(blocks, house.tour, counts), without = planTasks(blocks, {}, counts);
    ASSERT_EQ(with.size(), 1u);
    EXPECT_EQ(with[0].tourViews, 10u);
    EXPECT_EQ(with[0].total(), 10u);
    EXPECT_EQ(without[0].tourViews, 0u);
    EXPECT_EQ(without[0].total(), 20u);
}

TEST(Plan, viewsThatAreThereAlreadyAreLookedAtBlockByBlock) {
    const auto viewIn = [](dat::RecordId root, double yaw) {
        View view;
        view.root = root;
        view.yaw = yaw;
        return view;
    };
    const std::vector<View> views{viewIn(0xA9B40105, 1), viewIn(0xA9B30101, 2), viewIn(0xA9B40100, 3)};
    const std::vector<BlockTask> tasks = tasksOf(views);
    ASSERT_EQ(tasks.size(), 2u);
    EXPECT_EQ(tasks[0].block, (dat::BlockCoord{0xA9, 0xB3}));
    EXPECT_EQ(tasks[0].total(), 1u);
    ASSERT_EQ(tasks[1].given.size(), 2u);
    EXPECT_EQ(tasks[1].given[0].yaw, 1.0);
    EXPECT_EQ(tasks[1].given[1].yaw, 3.0);
}

TEST(Plan, findsTheBlocksOfAnArchive) {
    test::House house;
    house.source.setFlatTerrain({0x21, 0x30}, 5); // beside the house
    house.source.setFlatTerrain({0x40, 0x30}, 5); // far away
    const limen::test::TempDir directory;
    ASSERT_TRUE(house.source.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const auto blocks = blocksOf(*archive);
    ASSERT_TRUE(blocks);
    ASSERT_EQ(blocks->size(), 2u);
    EXPECT_EQ((*blocks)[0].block, house.source.home());
    EXPECT_EQ((*blocks)[0].cells, 2u);
    EXPECT_TRUE((*blocks)[0].hasBuildings);
    EXPECT_TRUE((*blocks)[0].hasLandscape);
    EXPECT_EQ((*blocks)[1].cells, 0u);
}

TEST(Plan, aDungeonHasNoLandscape) {
    limen::test::TestWorld source;
    source.addBox({0, 0, 0}, {4, 4, 3});
    source.setFlatTerrain(source.home(), 0); // as the original's dungeons have it
    const limen::test::TempDir directory;
    ASSERT_TRUE(source.write(directory.path()));
    const auto archive = dat::Archive::open(directory.path());
    ASSERT_TRUE(archive);
    const auto blocks = blocksOf(*archive);
    ASSERT_TRUE(blocks);
    ASSERT_EQ(blocks->size(), 1u);
    EXPECT_FALSE((*blocks)[0].hasLandscape);
}

} // namespace
} // namespace limen::check
