#include "check/Report.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limen::check {
namespace {

using testing::HasSubstr;

View viewWith(ViewKind kind, double x) {
    View view;
    view.kind = kind;
    view.eye = {x, 2.0 / 3.0, -1e-9};
    view.yaw = 1.0 / 7.0;
    view.root = kind == ViewKind::Outside ? 0 : 0xA9B40105;
    view.about = "here";
    return view;
}

Comparison comparisonWith(Verdict verdict, std::uint64_t count) {
    Comparison comparison;
    comparison.verdicts.assign(100, Verdict::Agrees);
    comparison.counts[0] = 100 - count;
    comparison.counts[static_cast<std::size_t>(verdict)] += count;
    return comparison;
}

Totals someTotals() {
    Totals totals;
    totals.add(viewWith(ViewKind::Random, 1), 0, comparisonWith(Verdict::Sliver, 3), 0);
    totals.add(viewWith(ViewKind::Sweep, 2), 1, comparisonWith(Verdict::Disagrees, 4), 0);
    totals.add(viewWith(ViewKind::Outside, 3), 2, comparisonWith(Verdict::Void, 9), 0);
    totals.add(viewWith(ViewKind::Path, 4), 3, comparisonWith(Verdict::EdgeOn, 2), 0);
    totals.seconds = 2.0;
    return totals;
}

TEST(Totals, keepTheWorstFirst) {
    const Totals totals = someTotals();
    ASSERT_EQ(totals.worst.size(), 3u);
    EXPECT_EQ(totals.worst[0].count, 9u);
    EXPECT_EQ(totals.worst[0].number, 2u);
    EXPECT_EQ(totals.worst[2].count, 2u);
    EXPECT_EQ(totals.viewsWithFindings, 3u);
    EXPECT_EQ(totals.sum().disagreeing(), 15u);
}

TEST(Totals, keepOnlySoMany) {
    Totals totals;
    for (std::size_t i = 0; i < Totals::kWorst + 10; ++i)
        totals.add(viewWith(ViewKind::Random, 1), i, comparisonWith(Verdict::Disagrees, i + 1), 0);
    EXPECT_EQ(totals.worst.size(), Totals::kWorst);
    EXPECT_EQ(totals.worst.front().count, Totals::kWorst + 10);
}

TEST(Totals, everyFindingCounts) {
    for (const Verdict verdict :
         {Verdict::EdgeOn, Verdict::Disagrees, Verdict::Void, Verdict::Depth, Verdict::Layers}) {
        Totals totals;
        totals.add(viewWith(ViewKind::Random, 1), 0, comparisonWith(verdict, 1), 0);
        EXPECT_EQ(totals.sum().findings(), 1u);
    }
    Totals moved;
    moved.add(viewWith(ViewKind::Still, 1), 0, comparisonWith(Verdict::Agrees, 0), 5);
    EXPECT_EQ(moved.sum().findings(), 5u);
    EXPECT_EQ(moved.sum().disagreeing(), 0u);
}

TEST(Totals, whatIsExcusedIsNoFinding) {
    for (const Verdict verdict :
         {Verdict::Agrees, Verdict::ByZone, Verdict::Hole, Verdict::Unjudged, Verdict::Sliver}) {
        Totals totals;
        totals.add(viewWith(ViewKind::Random, 1), 0, comparisonWith(verdict, 1), 0);
        EXPECT_EQ(totals.sum().findings(), 0u);
        EXPECT_TRUE(totals.worst.empty());
    }
}

TEST(Report, hasTheFieldsThatOtherToolsRead) {
    const auto json = nlohmann::json::parse(reportJson(someTotals(), {7, " --dat 'd'"}));
    EXPECT_EQ(json["views"], 4);
    EXPECT_EQ(json["pixels"], 400);
    EXPECT_EQ(json["disagreeing_pixels"], 15);
    EXPECT_EQ(json["void_pixels"], 9);
    EXPECT_EQ(json["seed"], 7);
    EXPECT_EQ(json["seconds"], 2.0);
    EXPECT_EQ(json["slivers"], 3);
    EXPECT_EQ(json["edge_on"], 2);
    EXPECT_EQ(json["views_per_second"], 2.0);
    EXPECT_EQ(json["kinds"]["sweep"]["wrong_ids"], 4);
    EXPECT_FALSE(json["kinds"].contains("still"));
    ASSERT_EQ(json["worst"].size(), 3u);
    EXPECT_EQ(json["worst"][0]["count"], 9);
    EXPECT_EQ(
        json["worst"][1]["command"],
        "limen shot --dat 'd' --eye=2,0.6666666666666666,-1e-09 --yaw=0.14285714285714285 --pitch=0 --fov=60 "
        "--size=640x360 --root=0xA9B40105 --day=0 --ids ids.npy");
}

TEST(Report, textNamesEveryCategoryAndTheCommands) {
    const std::string text = reportText(someTotals(), {});
    for (const std::string_view name : kVerdictNames)
        EXPECT_TRUE(name == "agrees" || text.find(name) != std::string::npos) << name;
    EXPECT_THAT(text, HasSubstr("limen shot --eye=3,"));
    EXPECT_THAT(text, HasSubstr("--root=outside"));
    EXPECT_THAT(text, HasSubstr("15 of 400 pixels disagree (9 of them void) in "));
}

TEST(Report, theLastLineCountsPixelsThatAreWrongWithTheRightId) {
    Totals totals;
    totals.add(viewWith(ViewKind::Random, 1), 0, comparisonWith(Verdict::Layers, 7), 0);
    EXPECT_THAT(
        reportText(totals, {}),
        HasSubstr("0 of 100 pixels disagree (0 of them void), 7 more are wrong (7 layers) in 1 of 1 views"));
    totals.add(viewWith(ViewKind::Random, 2), 1, comparisonWith(Verdict::Depth, 1), 2);
    EXPECT_THAT(reportText(totals, {}),
                HasSubstr(", 10 more are wrong (1 depth, 7 layers, 2 moved) in 2 of 2 views"));
}

TEST(Resume, aStateComesBackAsItWas) {
    Progress progress{"this run", 3, 17, someTotals()};
    progress.totals.blocksLeftOut = 2;
    ASSERT_FALSE(progress.totals.worst.empty());
    View& worst = progress.totals.worst.front().view; // everything that its command names
    worst.seconds = 12.5;
    worst.doors = 0.25;
    worst.dayGroup = 2;
    worst.rain = true;
    worst.look = world::Look::Enhanced;
    const auto back = parseProgress(progressJson(progress));
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(back->run, "this run");
    EXPECT_EQ(back->tasks, 3u);
    EXPECT_EQ(back->views, 17u);
    EXPECT_EQ(reportJson(back->totals, {}), reportJson(progress.totals, {}));
}

TEST(Resume, refusesWhatIsNoState) {
    for (const char* text : {"", "{}", "[1,2]", "{\"limen_check\":1}", "{\"limen_check\":3,\"run\":\"\"}",
                             "{\"limen_check\":\"x\"}"})
        EXPECT_FALSE(parseProgress(text)) << text;
}

} // namespace
} // namespace limen::check
