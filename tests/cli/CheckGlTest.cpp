#include "cli/ProgramRunner.h"
#include "engine/WorldSource.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `limen check` on the built-in world, run as a process.
namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;

TEST(Check, findsNothingWrongWithTheBuiltInWorld) {
    const ProgramRunner runner;
    const ProgramRun run =
        runner.run({"check", "--views", "40", "--size", "96x54", "--json", "-o", "findings"});
    EXPECT_EQ(run.exit, 0) << run.out << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_GE(json["views"], 36);
    EXPECT_EQ(json["pixels"], json["views"].get<int>() * 96 * 54);
    EXPECT_EQ(json["disagreeing_pixels"], 0);
    EXPECT_EQ(json["void_pixels"], 0);
    EXPECT_EQ(json["seed"], 1);
    EXPECT_GT(json["seconds"], 0.0);
    EXPECT_TRUE(json["worst"].is_array() && json["worst"].empty());
    for (const char* kind : {"random", "outside", "path", "sweep", "still"})
        EXPECT_GT(json["kinds"][kind]["views"], 0) << kind;
    EXPECT_TRUE(std::filesystem::is_empty(runner.work() / "findings"));
}

// A body passes two doorways in third person: case 23, frame by frame.
TEST(Check, case23_findsNothingWrongAlongAWalkSeenFromBehind) {
    const ProgramRunner runner;
    putText(runner.work() / "path", "--at cottage.front\n--eye=32532.1,34664,31.9\n--eye=32532.1,34668,32\n"
                                    "--eye=32532.1,34664,31.9\n--at cottage.front\n");
    ASSERT_EQ(runner.run({"walk", "--path", "path", "--chase", "-o", "walk"}).exit, 0);
    const ProgramRun run = runner.run({"check", "--walk", "walk", "--size", "96x54", "--json"});
    EXPECT_EQ(run.exit, 0) << run.out << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_GT(json["views"], 200);
    EXPECT_EQ(json["disagreeing_pixels"], 0);
    EXPECT_EQ(json["void_pixels"], 0);
}

TEST(Check, theSameSeedChecksTheSameAndZonesDoNotMatter) {
    const ProgramRunner runner;
    const auto pixels = [&](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"check",  "--views", "6",      "--size",  "48x27",
                                           "--json", "--kinds", "random", "--block", "A9B4"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 0) << run.out << run.err;
        return nlohmann::json::parse(run.out)["kinds"].dump();
    };
    EXPECT_EQ(pixels({}), pixels({}));
    EXPECT_EQ(nlohmann::json::parse(pixels({"--apart"}))["random"]["views"], 6);
}

// The tour that tour, walk and probe take: made from the records where world.json has none.
// A dungeon of convex cells, on which every gate is exact (docs/gates.md).
TEST(Check, findsNothingWrongWithAnyGateInADungeon) {
    const ProgramRunner runner;
    ASSERT_EQ(runner.run({"demo", "--kind", "dungeon", "--size", "8", "--seed", "3", "-o", "dungeon"}).exit,
              0);
    for (const char* gate : {"ownership", "planes", "depth"}) {
        const ProgramRun run = runner.run(
            {"check", "--dat", "dungeon", "--views", "12", "--size", "48x27", "--json", "--gate", gate});
        EXPECT_EQ(run.exit, 0) << run.out << run.err;
        EXPECT_EQ(nlohmann::json::parse(run.out)["disagreeing_pixels"], 0);
    }
    const ProgramRun wrong = runner.run({"check", "--gate", "plane"});
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_THAT(wrong.err, HasSubstr("Did you mean 'planes'?"));
}

TEST(Check, followsATourMadeFromTheRecords) {
    const ProgramRunner runner;
    ASSERT_EQ(runner.run({"demo", "town", "--kind", "town", "--size", "4", "--seed", "3"}).exit, 0);
    const auto pictures = [&] {
        const ProgramRun run = runner.run(
            {"check", "--dat", "town", "--kinds", "path", "--views", "6", "--size", "48x27", "--json"});
        EXPECT_EQ(run.exit, 0) << run.out << run.err;
        return nlohmann::json::parse(run.out)["pictures_hash"].get<std::string>();
    };
    const std::string made = pictures();
    const std::filesystem::path file = runner.work() / "town" / "world.json";
    auto world = nlohmann::json::parse(getText(file));
    const auto rewrite = [&](const nlohmann::json& tour) {
        world["tour"] = tour;
        putText(file, world.dump());
    };
    const engine::WorldSource source = engine::openWorldSource((runner.work() / "town").string()).value();
    nlohmann::json tour = nlohmann::json::array();
    const std::vector<world::Place> found = engine::tourOf(source).value();
    for (const world::Place& point : found)
        tour.push_back({{"eye", {point.eye.x, point.eye.y, point.eye.z}},
                        {"yaw", point.yaw},
                        {"pitch", point.pitch},
                        {"cell", dat::idText(point.cell)}});
    ASSERT_GT(tour.size(), 10u);
    rewrite(tour);
    EXPECT_EQ(pictures(), made);
    rewrite({tour[0], tour[1]});
    EXPECT_NE(pictures(), made) << "another tour has other views";
}

TEST(Check, continuesFromItsStateAndRefusesAnothers) {
    const ProgramRunner runner;
    const std::vector<std::string> arguments{"check",   "--views", "4",      "--size",   "32x18",
                                             "--kinds", "random",  "--json", "--resume", "state.json"};
    const ProgramRun first = runner.run(arguments);
    ASSERT_EQ(first.exit, 0) << first.err;
    auto state = nlohmann::json::parse(getText(runner.work() / "state.json"));
    EXPECT_EQ(state["totals"]["kinds"][0]["views"], 4);
    state["totals"]["kinds"][0]["counts"][7] = 3; // as if the finished part had found three wrong ids
    putText(runner.work() / "state.json", state.dump());
    const ProgramRun second = runner.run(arguments);
    EXPECT_EQ(second.exit, 1) << "findings from before the stop count";
    EXPECT_EQ(nlohmann::json::parse(second.out)["disagreeing_pixels"], 3);
    EXPECT_EQ(nlohmann::json::parse(second.out)["views"], 4);
    std::vector<std::string> other = arguments;
    other[2] = "5";
    const ProgramRun refused = runner.run(other);
    EXPECT_EQ(refused.exit, 2);
    EXPECT_EQ(refused.errorLines(), 1u);
    EXPECT_THAT(refused.err, HasSubstr("state.json"));
}

TEST(Check, saysInOneLineWhatItCannotDo) {
    const ProgramRunner runner;
    putText(runner.work() / "text", "no state");
    for (const auto& [arguments, word] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"check", "--kinds", "random,sideways"}, "sideways"},
             {{"check", "--views", "0"}, "--views"},
             {{"check", "--size", "12"}, "--size"},
             {{"check", "--block", "0101"}, "0101"},
             {{"check", "--block", "A9B40100"}, "four"},
             {{"check", "--resume", "text"}, "text"},
             {{"check", "--dat", "nowhere"}, "nowhere"}}) {
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 2) << run.err;
        EXPECT_EQ(run.errorLines(), 1u) << run.err;
        EXPECT_THAT(run.err, HasSubstr(word));
        EXPECT_EQ(run.out, "");
    }
}

} // namespace
} // namespace limen::cli
