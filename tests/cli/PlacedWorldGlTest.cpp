#include "cli/ProgramRunner.h"

#include <cmath>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

// The built-in world's doors and people as rows of a database: exported, imported, drawn and checked.
namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

void expectFinished(const ProgramRun& run) {
    ASSERT_EQ(run.exit, 0) << run.err;
}

/// The built-in world with its people standing: by world.json in "json", by world.db in "rows".
class PlacedWorld : public testing::Test {
protected:
    static void SetUpTestSuite() {
        runner_.emplace();
        expectFinished(runner_->run({"demo", "json"}));
        Json world = Json::parse(getText(work() / "json/world.json"));
        for (Json& person : world["villagers"]) {
            person["speed"] = 0.0;
            person["start"] = 0.0; // at a point of the route, whose cell the file names
            person.erase("play");
            if (!person.contains("clothing"))
                continue;
            for (Json& garment : person["clothing"])
                if (garment.contains("shade") && garment["shade"].is_array())
                    garment["shade"] =
                        garment["shade"][0].get<double>(); // rows have one shade for each garment
        }
        for (Json& door : world["doors"])
            door["open"] = door["open"].get<double>() > 0.5 ? 1.0 : 0.0; // rows know shut and open
        world["emitters"] = Json::array();                               // some are attached to people
        putText(work() / "json/world.json", world.dump());

        expectFinished(runner_->run({"world", "export", "--dat", "json", "-o", "sql"}));
        std::filesystem::copy(work() / "json", work() / "rows");
        Json rest = world;
        rest["villagers"] = Json::array();
        rest["doors"] = Json::array();
        for (const Json& door : world["doors"])
            if (!door["opaque"].get<bool>())
                rest["doors"].push_back(door); // panes
        putText(work() / "rows/world.json", rest.dump());
        expectFinished(runner_->run({"world", "import", "sql", "--dat", "rows"}));
    }
    static void TearDownTestSuite() { runner_.reset(); }
    static const test::TemporaryDirectory& work() { return runner_->work(); }

    static std::optional<ProgramRunner> runner_; ///< the tests change nothing in "json" and "rows"
};
std::optional<ProgramRunner> PlacedWorld::runner_;

TEST_F(PlacedWorld, looksTheSameByEitherWay) {
    std::string views;
    for (const char* place :
         {"lane", "hill", "cottage.front", "cottage.room", "inn.hall", "inn.balcony", "neighbour.room"})
        for (const char* doors : {"rest", "closed", "half", "open"})
            views += std::string("--at ") + place + " --doors " + doors + " --seconds 3\n";
    putText(work() / "views", views);
    for (const char* directory : {"json", "rows"})
        expectFinished(runner_->run({"shot", "--dat", directory, "--views", "views", "--size", "320x180",
                                     "-o", std::string(directory) + "-pictures"}));
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(work() / "json-pictures")) {
        if (entry.path().extension() != ".png")
            continue;
        ++pictures;
        const std::filesystem::path other = work() / "rows-pictures" / entry.path().filename();
        EXPECT_TRUE(getText(entry.path()) == getText(other)) << entry.path().filename();
    }
    EXPECT_EQ(pictures, 28u);
}

TEST_F(PlacedWorld, passesTheCheckInEveryStateOfItsDoors) {
    std::set<std::string> hashes;
    for (const char* doors : {"rest", "closed", "half", "open"}) {
        const ProgramRun run =
            runner_->run({"check", "--dat", "rows", "--block", "A9B4", "--views", "48", "--kinds",
                          "random,outside,path,sweep", "--doors", doors, "--size", "96x54", "--seed", "7"});
        EXPECT_EQ(run.exit, 0) << doors << ": " << run.out << run.err;
        const std::size_t hash = run.out.rfind("pictures ");
        ASSERT_NE(hash, std::string::npos) << run.out;
        hashes.insert(run.out.substr(hash));
    }
    EXPECT_GE(hashes.size(), 3u) << "the doors are in the pictures";
}

TEST_F(PlacedWorld, namesItsDoors) {
    const ProgramRun list = runner_->run({"world", "list", "--dat", "rows", "--type", "door", "--json"});
    ASSERT_EQ(list.exit, 0) << list.err;
    const Json first = Json::parse(list.out.substr(0, list.out.find('\n')));
    const std::string name =
        first["name"].get<std::string>() + " " + first["id"].get<std::string>().substr(2);
    expectFinished(runner_->run({"shot", "--dat", "rows", "--at", "lane", "--door", name + "=0.5", "--size",
                                 "64x36", "-o", "a.png"}));
    const ProgramRun unknown = runner_->run(
        {"shot", "--dat", "rows", "--at", "lane", "--door", "nothing=1", "--size", "64x36", "-o", "b.png"});
    EXPECT_EQ(unknown.exit, 2);
}

TEST_F(PlacedWorld, goesToAnObjectByItsName) {
    const ProgramRun list = runner_->run({"world", "list", "--dat", "rows", "--name", "elder", "--json"});
    ASSERT_EQ(list.exit, 0) << list.err;
    const Json elder = Json::parse(list.out.substr(0, list.out.find('\n')));
    const std::string exact = "elder " + elder["id"].get<std::string>().substr(2);
    for (const std::string& name : {std::string("ELDER"), std::string("elde"), exact}) {
        expectFinished(
            runner_->run({"shot", "--dat", "rows", "--at", name, "--size", "64x36", "--json", "elder.json"}));
        const Json frame = Json::parse(getText(work() / "elder.json"));
        const double x = frame["eye"][0].get<double>() - elder["position"][0].get<double>(),
                     y = frame["eye"][1].get<double>() - elder["position"][1].get<double>();
        EXPECT_NEAR(std::hypot(x, y), elder["cell"] == "outside" ? 3.0 : 1.5, 0.01) << name;
    }
    const ProgramRun unknown =
        runner_->run({"shot", "--dat", "rows", "--at", "nobody", "--size", "64x36", "-o", "b.png"});
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.err, HasSubstr("unknown place 'nobody'"));
}

TEST_F(PlacedWorld, isComparedWithTheDatFiles) {
    const ProgramRun run = runner_->run({"world", "stats", "--dat", "rows", "--resolve", "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    const Json compared = Json::parse(run.out)["compared"];
    EXPECT_EQ(compared["drawn"], 20);
    EXPECT_EQ(compared["doors"], 13);
    EXPECT_EQ(compared["doors_in_an_opening"], 13);
    EXPECT_TRUE(compared["unresolved"].empty()) << compared;
    putText(
        work() / "odd.sql",
        "INSERT INTO weenie VALUES (1, 'a', 19, ''), (2, 'b', 10, ''), (3, 'axe', 6, ''), (4, 'c', 10, '');\n"
        "INSERT INTO weenie_properties_int VALUES (1, 3, 9, 1048576);\n"
        "INSERT INTO weenie_properties_create_list VALUES (1, 4, 2, 3, 0, 0, 0, False);\n"
        "INSERT INTO weenie_properties_d_i_d VALUES (1, 1, 1, 0x02000150), (2, 2, 1, 0x0200FFFF), (3, 2, "
        "2, 0x0900FFFF), (4, 3, 1, 0x0200FFFE), (5, 4, 1, 0x02000150), (6, 4, 22, 0x3400FFFF), (7, 4, 30, "
        "5);\n"
        "INSERT INTO landblock_instance VALUES (1, 1, 0xA9B40001, 1, 1, 50, 1, 0, 0, 0, False, ''), "
        "(2, 2, 0xA9B4FF00, 1, 1, 50, 1, 0, 0, 0, False, ''), (3, 4, 0xA9B40001, 1, 1, 50, 1, 0, 0, 0, "
        "False, '');\n");
    std::filesystem::copy(work() / "rows", work() / "odd");
    expectFinished(runner_->run({"world", "import", "odd.sql", "--dat", "odd"}));
    const ProgramRun odd = runner_->run({"world", "stats", "--dat", "odd", "--resolve"});
    for (const char* reason : {"1  its Setup is not", "1  its MotionTable is not", "1  its cell is not",
                               "1  the door stands before no opening", "1  the Setup of a held item is not",
                               "1  its PhysicsScriptTable is not"})
        EXPECT_THAT(odd.out, HasSubstr(reason));
}

TEST_F(PlacedWorld, aDamagedDatabaseIsOneLine) {
    putText(work() / "rows/world.db", "SQLite format 3 and then nothing");
    const ProgramRun run =
        runner_->run({"shot", "--dat", "rows", "--at", "lane", "--size", "64x36", "-o", "a.png"});
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(run.errorLines(), 1u) << run.err;
    EXPECT_THAT(run.err, HasSubstr("world.db"));
}

} // namespace
} // namespace limen::cli
