#include "cli/ProgramRunner.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limen::test {
namespace {

TEST(PlacesVerb, listsTheBuiltInWorldsOwnPlaces) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"places"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_NE(run.out.find("hill "), std::string::npos) << run.out;
}

TEST(PlacesVerb, listsAndUsesThePlacesFoundWithoutAWorldFile) {
    const ProgramRunner runner;
    ASSERT_EQ(runner.run({"demo", "town", "--kind", "town", "--size", "3"}).exit, 0);
    std::filesystem::remove(runner.work() / "town/world.json");
    const ProgramRun run = runner.run({"places", "--dat", "town", "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    const nlohmann::json json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["places"][0]["name"], json["start"]);
    EXPECT_EQ(json["places"][0]["cell"], "outside");
    for (const std::vector<std::string>& verb :
         {std::vector<std::string>{"probe", "--frames", "3"}, {"walk", "-o", "walk.txt"}}) {
        std::vector<std::string> arguments = verb;
        arguments.insert(arguments.end(), {"--dat", "town", "--radius", "1"});
        const ProgramRun made = runner.run(arguments);
        EXPECT_EQ(made.exit, 0) << verb[0] << ": " << made.err;
    }
}

} // namespace
} // namespace limen::test
