#include "cli/ProgramRunner.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;
using testing::Not;

/// Asserts the form of a refusal: exit code 2, one line on standard error, nothing on standard output.
void expectRefusal(const ProgramRunner& runner, const std::vector<std::string>& arguments,
                   const std::string& inMessage = "") {
    const ProgramRun run = runner.run(arguments);
    const std::string line = testing::PrintToString(arguments);
    EXPECT_EQ(run.exit, 2) << line << "\n" << run.err;
    EXPECT_EQ(run.errorLines(), 1u) << line << "\n" << run.err;
    EXPECT_EQ(run.out, "") << line;
    EXPECT_THAT(run.err, testing::StartsWith("limen: ")) << line;
    EXPECT_THAT(run.err, HasSubstr(inMessage)) << line;
}

TEST(Program, helpIsDataAndExitsWithZero) {
    const ProgramRunner runner;
    for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{{},
                                                                                      {"view"},
                                                                                      {"shot"},
                                                                                      {"tour"},
                                                                                      {"probe"},
                                                                                      {"walk"},
                                                                                      {"dat"},
                                                                                      {"dat", "ls"},
                                                                                      {"dat", "show"},
                                                                                      {"dat", "verify"},
                                                                                      {"demo"},
                                                                                      {"bench"},
                                                                                      {"help"},
                                                                                      {"man"},
                                                                                      {"completions"}}) {
        std::vector<std::string> arguments = verb;
        arguments.emplace_back("--help");
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 0) << testing::PrintToString(arguments);
        EXPECT_EQ(run.err, "");
        EXPECT_THAT(run.out, HasSubstr("Usage"));
    }
    EXPECT_THAT(runner.run({"--version"}).out, HasSubstr("limen "));
}

TEST(Program, withoutAVerbPrintsHelpIfThereIsNoDisplay) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({});
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, runner.run({"help"}).out);
}

TEST(Program, helpExplainsVerbsAtEveryLevel) {
    const ProgramRunner runner;
    EXPECT_THAT(runner.run({"help", "shot"}).out, HasSubstr("limen shot"));
    EXPECT_THAT(runner.run({"help", "dat", "ls"}).out, HasSubstr("--type TYPE"));
    expectRefusal(runner, {"help", "shto"}, "Did you mean 'shot'?");
    expectRefusal(runner, {"help", "dat", "sl"}, "Did you mean 'ls'?");
    expectRefusal(runner, {"help", "shot", "ls"}, "no verbs of its own");
}

TEST(Program, suggestsTheNearestName) {
    const ProgramRunner runner;
    using Words = std::vector<std::string>;
    for (const auto& [arguments, nearest] : std::vector<std::pair<Words, std::string>>{
             {{"shto"}, "'shot'"},
             {{"dat", "shwo"}, "'show'"},
             {{"shot", "--at", "hill", "--szie", "9x9"}, "'--size'"},
             {{"shot", "--at", "hill", "--day", "Snwo", "-o", "a.png"}, "'Snow'"},
             {{"shot", "--at", "hill", "--quality", "hihg"}, "'high'"},
             {{"check", "--kinds", "swepe"}, "'sweep'"},
             {{"dat", "ls", "--type", "EnvCel"}, "'EnvCell'"},
             {{"demo", "--kind", "twon", "x"}, "'town'"},
             {{"bench", "flodo"}, "'flood'"}})
        expectRefusal(runner, arguments, "Did you mean " + nearest);
}

// Needs no driver.
TEST(Program, probeTellsTheWayIntoAHouse) {
    const ProgramRunner runner;
    putText(runner.work() / "path", "--at cottage.front\n--at cottage.room\n");
    const ProgramRun run = runner.run({"probe", "--path", "path", "--frames", "40"});
    ASSERT_EQ(run.exit, 0) << run.err;
    std::istringstream lines(run.out);
    std::vector<std::string> roots;
    std::size_t visits = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto event = nlohmann::json::parse(line);
        if (event["event"] == "root")
            roots.push_back(event["root"]);
        visits += event["event"] == "visits" ? 1 : 0;
    }
    EXPECT_THAT(roots, testing::ElementsAre("outside", "0xA9B40100"));
    EXPECT_GT(visits, 1u);
    EXPECT_LT(visits, 40u);
}

/// Writes a path into the cottage and out again.
void putRoundTrip(const ProgramRunner& runner) {
    putText(runner.work() / "path", "--at cottage.front\n--eye=32532.1,34664,31.9\n--eye=32532.1,34668,32\n"
                                    "--eye=32532.1,34664,31.9\n--at cottage.front\n");
}

TEST(Program, overADungeonsBlockTheLandStays) {
    const ProgramRunner runner;
    putText(runner.work() / "path", "--at cottage.front\n--eye=283.5,3166,50\n"); // over dungeon.sealed
    const ProgramRun run = runner.run({"probe", "--path", "path", "--frames", "5", "--size", "64x36"});
    ASSERT_EQ(run.exit, 0) << run.err;
    std::istringstream lines(run.out);
    std::vector<std::string> loaded;
    for (std::string line; std::getline(lines, line);) {
        const auto event = nlohmann::json::parse(line);
        if (event["event"] == "loaded")
            loaded.push_back(event["blocks"]);
    }
    EXPECT_THAT(loaded, testing::ElementsAre("25 blocks from 0xA7B2FFFF to 0xABB6FFFF"));
}

/// The roots along a walk, as printed by probe.
std::vector<std::string> rootsAlong(const ProgramRunner& runner, const std::string& walk) {
    const ProgramRun run = runner.run({"probe", "--walk", walk});
    EXPECT_EQ(run.exit, 0) << run.err;
    std::vector<std::string> roots;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) {
        const auto event = nlohmann::json::parse(line);
        if (event["event"] == "root")
            roots.push_back(event["root"]);
    }
    return roots;
}

// Needs no driver.
TEST(Program, walksOnFootAndWalksAgain) {
    const ProgramRunner runner;
    putRoundTrip(runner);
    for (const bool chase : {false, true}) {
        SCOPED_TRACE(chase);
        std::vector<std::string> arguments{"walk", "--path", "path", "-o", "walk"};
        if (chase)
            arguments.emplace_back("--chase");
        const ProgramRun walked = runner.run(arguments);
        ASSERT_EQ(walked.exit, 0) << walked.err;
        EXPECT_THAT(walked.err, Not(HasSubstr("not reached")));
        EXPECT_THAT(rootsAlong(runner, "walk"), testing::ElementsAre("outside", "0xA9B40100", "outside"))
            << "exit 1 would mean a frame that differs from the recording";
    }
}

TEST(Program, saysWhenAWalkComesOutOtherwise) {
    const ProgramRunner runner;
    putRoundTrip(runner);
    ASSERT_EQ(runner.run({"walk", "--path", "path", "-o", "walk"}).exit, 0);
    std::string text = getText(runner.work() / "walk");
    const std::size_t forward = text.find("\"forward\":1", text.size() / 2);
    ASSERT_NE(forward, std::string::npos);
    text.replace(forward, 11, "\"forward\":0");
    putText(runner.work() / "walk", text);
    const ProgramRun run = runner.run({"probe", "--walk", "walk"});
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("differs from the recording"));
}

TEST(Program, refusesWalksThatAreNone) {
    const ProgramRunner runner;
    putText(runner.work() / "text", "hello\n");
    putText(runner.work() / "short", R"({"format":"limen walk","version":1,"start":"--eye=1,2,3"})"
                                     "\n");
    putText(runner.work() / "nowhere", R"({"format":"limen walk","version":1,"start":"--at nowhere"})"
                                       "\n{}\n");
    for (const char* walk : {"text", "short", "nowhere", "missing"}) {
        expectRefusal(runner, {"probe", "--walk", walk});
        expectRefusal(runner, {"probe", "--walk", walk, "--size", "0x0"});
    }
    expectRefusal(runner, {"probe", "--walk", "text", "--path", "text"}, "--path");
    expectRefusal(runner, {"check", "--walk", "text", "--views", "5"}, "--views");
    expectRefusal(runner, {"walk"}, "--output");
    expectRefusal(runner, {"walk", "-o", "missing/walk"}, "missing");
    expectRefusal(runner, {"walk", "-o", "walk", "--fps", "0"}, "--fps");
}

/// The number of visible polygons of the player's body in a small view.
std::size_t bodyPolygonsSeen(const ProgramRunner& runner) {
    const ProgramRun run =
        runner.run({"shot", "--dat", "world", "--reference", "--size", "64x36", "--eye=32535.6,34653.6,31.6",
                    "--yaw", "340", "--body", "32534.6,34656.6,29.95", "--ids", "ids", "--json", "json"});
    EXPECT_EQ(run.exit, 0) << run.err;
    std::size_t seen = 0;
    const auto json = nlohmann::json::parse(getText(runner.work() / "json"));
    for (const auto& [id, meaning] : json["ids"].items())
        seen += meaning["object"] == "F400000000000000" ? 1 : 0;
    return seen;
}

// Original game files have no world.json; there the player's body is setup 0x02000001.
TEST(Program, aWorldWithoutAWorldFileIsWalkedByASetupOfItsOwn) {
    const ProgramRunner runner;
    ASSERT_EQ(runner.run({"demo", "-o", "world"}).exit, 0);
    const std::filesystem::path file = runner.work() / "world" / "world.json";
    const std::string named = nlohmann::json::parse(getText(file))["player"]["model"];
    EXPECT_GT(bodyPolygonsSeen(runner), 0u) << "world.json names a body";
    std::filesystem::remove(file);
    EXPECT_EQ(bodyPolygonsSeen(runner), 0u) << "the default setup is missing";

    ASSERT_EQ(runner.run({"dat", "export", named, "--dat", "world", "--as", "raw", "-o", "records"}).exit, 0);
    std::string setup = getText(runner.work() / "records" / (named.substr(2) + ".bin"));
    setup.replace(0, 4, std::string("\x01\x00\x00\x02", 4)); // the record contains its id, too
    putText(runner.work() / "02000001.bin", setup);
    const std::string portal = "world/client_portal.dat";
    ASSERT_EQ(runner.run({"dat", "pack", "02000001.bin", "--base", portal, "-o", portal}).exit, 0);
    EXPECT_GT(bodyPolygonsSeen(runner), 0u);
    putText(file, R"({"format":"limen world","version":1})");
    EXPECT_EQ(bodyPolygonsSeen(runner), 0u) << "world.json names no body";
}

TEST(Program, refusesBadUsageWithOneLine) {
    const ProgramRunner runner;
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"fly"},
                                               {"--dat", "x"},
                                               {"shot"},
                                               {"shot", "--wrong"},
                                               {"shot", "stray"},
                                               {"shot", "--eye"},
                                               {"shot", "--eye", "1,2"},
                                               {"shot", "--eye", "nan,0,0"},
                                               {"shot", "--eye=0,inf,0"},
                                               {"shot", "--eye", "a,b,c"},
                                               {"shot", "--eye", "1,2,3", "--at", "hill"},
                                               {"shot", "--eye", "1,2,3", "--yaw", "north"},
                                               {"shot", "--eye", "1,2,3", "--pitch", "91"},
                                               {"shot", "--eye", "1,2,3", "--fov", "0"},
                                               {"shot", "--eye", "1,2,3", "--fov", "nan"},
                                               {"shot", "--eye", "1,2,3", "--size", "0x0"},
                                               {"shot", "--eye", "1,2,3", "--size", "100000x100000"},
                                               {"shot", "--eye", "1,2,3", "--size", "big"},
                                               {"shot", "--eye", "1,2,3", "--root", "kitchen"},
                                               {"shot", "--eye", "1,2,3", "--player", "1"},
                                               {"shot", "--eye", "1,2,3", "--time", "2"},
                                               {"shot", "--eye", "1,2,3", "--weather", "hail"},
                                               {"shot", "--eye", "1,2,3", "--zones", "some"},
                                               {"shot", "--eye", "1,2,3", "--dat", ""},
                                               {"shot", "--eye", "1,2,3", "--eye", "1,2,3"},
                                               {"tour"},
                                               {"tour", "-o", "t", "--frames", "0"},
                                               {"tour", "-o", "t", "--frames", "1.5"},
                                               {"tour", "-o", "t", "--frames", "10", "--fps", "5"},
                                               {"tour", "-o", "t", "--size", "-1x5"},
                                               {"tour", "-o", "t", "--path", "missing.txt"},
                                               {"probe", "--frames", "0"},
                                               {"probe", "--fps", "x"},
                                               {"probe", "--path", "missing.txt"},
                                               {"dat"},
                                               {"dat", "show"},
                                               {"dat", "show", "zebra"},
                                               {"dat", "show", "0x123456789"},
                                               {"dat", "show", "0x01000001", "--in", "attic"},
                                               {"dat", "ls", "--type", "Castle"},
                                               {"demo"},
                                               {"bench", "nonsense"},
                                               {"view", "--frames", "0"},
                                               {"view", "--screenshot", "a.png"}})
        expectRefusal(runner, arguments);
}

TEST(Program, refusesDirectoriesThatHoldNoWorld) {
    const ProgramRunner runner;
    std::filesystem::create_directory(runner.work() / "empty");
    putText(runner.work() / "file", "hello");
    for (const char* dat : {"missing", "empty", "file", "/proc"})
        expectRefusal(runner, {"shot", "--dat", dat, "--eye", "1,2,3", "-o", "a.png"});
    expectRefusal(runner, {"dat", "ls", "missing"}, "missing");
    expectRefusal(runner, {"dat", "ls", "empty"});
    expectRefusal(runner, {"dat", "ls", "file"});
}

/// Writes the built-in world to a directory, for damage by a test.
void writeWorld(const ProgramRunner& runner, const std::string& name) {
    const ProgramRun run = runner.run({"demo", name});
    ASSERT_EQ(run.exit, 0) << run.err;
}

TEST(Program, refusesDamagedFilesByName) {
    const ProgramRunner runner;
    writeWorld(runner, "world");
    const auto damage = [&](const char* file, const std::string& bytes) {
        std::filesystem::remove_all(runner.work() / "bad");
        std::filesystem::copy(runner.work() / "world", runner.work() / "bad");
        putText(runner.work() / ("bad/" + std::string(file)), bytes);
        expectRefusal(runner, {"shot", "--dat", "bad", "--eye", "1,2,3", "-o", "a.png"}, file);
    };
    for (const char* file : {"client_portal.dat", "client_cell_1.dat"}) {
        const std::string good = getText(runner.work() / ("world/" + std::string(file)));
        damage(file, "");
        damage(file, "this is a text file, nothing else\n");
        damage(file, std::string(100000, '\0'));
        damage(file, good.substr(0, 200));
        damage(file, good.substr(0, good.size() / 2));
    }
    damage("world.json", "{ \"places\": [");
    // The two files are swapped.
    std::filesystem::remove_all(runner.work() / "bad");
    std::filesystem::create_directory(runner.work() / "bad");
    std::filesystem::copy(runner.work() / "world/client_cell_1.dat", runner.work() / "bad/client_portal.dat");
    std::filesystem::copy(runner.work() / "world/client_portal.dat", runner.work() / "bad/client_cell_1.dat");
    expectRefusal(runner, {"shot", "--dat", "bad", "--eye", "1,2,3", "-o", "a.png"});
}

TEST(Program, refusesOutputsThatCannotBeWrittenBeforeItDraws) {
    const ProgramRunner runner;
    const auto before = runner.work().entryCount();
    for (const char* option : {"-o", "--ids", "--depth", "--json", "--overlay"}) {
        expectRefusal(runner, {"shot", "--at", "hill", option, "missing/out"}, "missing/out");
        expectRefusal(runner, {"shot", "--at", "hill", option, "/proc/out"});
        expectRefusal(runner, {"shot", "--at", "hill", option, "."});
        expectRefusal(runner, {"shot", "--at", "hill", option, ""});
    }
    expectRefusal(runner, {"shot", "--at", "hill", "-o", "a", "--ids", "./a"});
    for (const char* option : {"-o", "--overlay"}) {
        expectRefusal(runner, {"shot", "--at", "hill", option, "picture.bmp"}, ".webp");
        expectRefusal(runner, {"shot", "--at", "hill", option, "picture"}, ".jpeg");
    }
    expectRefusal(runner, {"tour", "-o", "/proc/tour"});
    expectRefusal(runner, {"tour", "--report", "/proc/tour"});
    expectRefusal(runner, {"check", "--report", "/proc/check"});
    expectRefusal(runner, {"tour"}, "--report");
    expectRefusal(runner, {"tour", "--film", "film.avi"}, ".webm");
    expectRefusal(runner, {"tour", "-o", "t", "--at", "lane"}, "--turn-table");
    expectRefusal(runner, {"tour", "-o", "t", "--format", "bmp"}, "bmp");
    expectRefusal(runner, {"demo", "/proc/demo"});
    EXPECT_EQ(runner.work().entryCount(), before);
}

TEST(Program, namesThePlacesItKnowsWhenOneIsUnknown) {
    const ProgramRunner runner;
    expectRefusal(runner, {"shot", "--at", "castle.attic", "-o", "a.png"}, "hill");
}

TEST(Program, namesTheKindsOfDayItKnowsWhenOneIsUnknown) {
    const ProgramRunner runner;
    expectRefusal(runner, {"shot", "--at", "hill", "--day", "dreary", "-o", "a.png"}, "Fair, Snow, Rain");
    expectRefusal(runner, {"shot", "--at", "hill", "--day", "3", "-o", "a.png"}, "Fair, Snow, Rain");
    expectRefusal(runner, {"shot", "--at", "hill", "--date", "116-13-1", "-o", "a.png"}, "Seedsow 24, 116");
    expectRefusal(runner, {"check", "--views", "1", "--day", "dreary"}, "Fair, Snow, Rain");
}

TEST(Program, sayThereIsNoDisplayForTheWindow) {
    const ProgramRunner runner;
    expectRefusal(runner, {"view"}, "display");
}

TEST(Program, demoWritesTheSameBytesTwice) {
    const ProgramRunner runner;
    writeWorld(runner, "one");
    writeWorld(runner, "two");
    for (const char* file : {"client_portal.dat", "client_cell_1.dat", "world.json"}) {
        const std::string bytes = getText(runner.work() / ("one/" + std::string(file)));
        EXPECT_FALSE(bytes.empty());
        EXPECT_EQ(bytes, getText(runner.work() / ("two/" + std::string(file)))) << file;
    }
}

TEST(Program, demoGeneratesAWorldOfAKind) {
    const ProgramRunner runner;
    const ProgramRun written =
        runner.run({"demo", "--kind", "town", "--size", "2", "--seed", "3", "-o", "town"});
    ASSERT_EQ(written.exit, 0) << written.err;
    const ProgramRun list = runner.run({"dat", "ls", "town", "--type", "LandBlockInfo"});
    EXPECT_EQ(list.exit, 0) << list.err;
    EXPECT_FALSE(list.out.empty());
}

TEST(Program, demoRefusesWhatItCannotGenerate) {
    const ProgramRunner runner;
    expectRefusal(runner, {"demo", "--kind", "castle", "-o", "x"}, "castle");
    expectRefusal(runner, {"demo", "--kind", "town", "--size", "0", "-o", "x"}, "size");
    expectRefusal(runner, {"demo", "--size", "9", "x"}, "--kind");
    expectRefusal(runner, {"demo", "one", "-o", "two"}, "one directory");
}

TEST(Program, datListsAndShowsRecords) {
    const ProgramRunner runner;
    const ProgramRun list = runner.run({"dat", "ls", "--type", "Region", "--json"});
    ASSERT_EQ(list.exit, 0) << list.err;
    const auto entry = nlohmann::json::parse(list.out);
    EXPECT_EQ(entry["id"], "0x13000000");
    EXPECT_EQ(entry["type"], "Region");
    const ProgramRun show = runner.run({"dat", "show", "0x13000000"});
    EXPECT_EQ(show.exit, 0) << show.err;
    EXPECT_TRUE(nlohmann::json::accept(show.out));
    const ProgramRun cells = runner.run({"dat", "ls", "--type", "envcell"});
    EXPECT_GT(std::count(cells.out.begin(), cells.out.end(), '\n'), 3);
    expectRefusal(runner, {"dat", "show", "0x01FFFFFF"}, "0x01FFFFFF");
}

TEST(Program, datExportWritesEachRecordInItsOwnWay) {
    const ProgramRunner runner;
    const auto idOf = [&](const char* type) {
        const ProgramRun list = runner.run({"dat", "ls", "--type", type, "--json"});
        return nlohmann::json::parse(list.out.substr(0, list.out.find('\n')))["id"].get<std::string>();
    };
    const auto written = [&](const std::string& id, const char* extension) {
        return getText(runner.work() / "exported" / (id.substr(2) + extension));
    };
    const std::string picture = idOf("RenderSurface"), model = idOf("GfxObj"), cell = idOf("EnvCell");
    const ProgramRun run =
        runner.run({"dat", "export", picture, model, cell, "0x13000000", "-o", "exported"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(written(picture, ".png").substr(1, 3), "PNG");
    for (const std::string& id : {model, cell})
        EXPECT_EQ(written(id, ".glb").substr(0, 4), "glTF");
    EXPECT_TRUE(nlohmann::json::accept(written("0x13000000", ".json")));
    EXPECT_EQ(runner.run({"dat", "export", model, "--as", "json", "-o", "exported"}).exit, 0);
    EXPECT_TRUE(nlohmann::json::accept(written(model, ".json")));
    expectRefusal(runner, {"dat", "export", "0x13000000", "--as", "png"}, "0x13000000");
    expectRefusal(runner, {"dat", "export", "0x13000000", "--as", "gltf"}, "Region");
    expectRefusal(runner, {"dat", "export", "0x01FFFFFF"}, "0x01FFFFFF");
}

// Exported and packed records are equal to the originals, byte for byte.
TEST(Program, datPackWritesWhatExportTookOut) {
    const ProgramRunner runner;
    const std::filesystem::path& work = runner.work().path();
    ASSERT_EQ(runner.run({"demo", "-o", "world"}).exit, 0);
    const std::string portal = getText(work / "world/client_portal.dat");
    ASSERT_EQ(runner.run({"dat", "pack", "--base", "world/client_portal.dat", "-o", "same.dat"}).exit, 0);
    EXPECT_TRUE(getText(work / "same.dat") == portal);

    const ProgramRun list = runner.run({"dat", "ls", "world/client_portal.dat", "--json"});
    std::istringstream lines(list.out);
    std::vector<std::string> exported{"dat", "export", "--dat", "world", "--as", "raw", "-o", "records"};
    for (std::string line; std::getline(lines, line);)
        exported.push_back(nlohmann::json::parse(line)["id"].get<std::string>());
    ASSERT_EQ(runner.run(exported).exit, 0);
    const ProgramRun packed = runner.run({"dat", "pack", "records", "--role", "portal", "-o", "made.dat"});
    ASSERT_EQ(packed.exit, 0) << packed.err;
    EXPECT_TRUE(getText(work / "made.dat") == portal);

    // One record replaced, one omitted.
    const std::string region = "13000000.bin";
    ASSERT_EQ(runner
                  .run({"dat", "pack", "records/" + region, "--base", "made.dat", "--without", exported[8],
                        "-o", "made.dat"})
                  .exit,
              0);
    const ProgramRun less = runner.run({"dat", "ls", "made.dat"});
    EXPECT_EQ(std::count(less.out.begin(), less.out.end(), '\n'),
              std::count(list.out.begin(), list.out.end(), '\n') - 1);
}

TEST(Program, datPackRefusesWhatIsNoRecord) {
    const ProgramRunner runner;
    putText(runner.work() / "13000000.bin", "short");
    putText(runner.work() / "notes.txt", "x");
    expectRefusal(runner, {"dat", "pack", "13000000.bin", "--role", "portal", "-o", "a.dat"}, "13000000.bin");
    expectRefusal(runner, {"dat", "pack", "notes.txt", "--role", "portal", "-o", "a.dat"}, "notes.txt");
    expectRefusal(runner, {"dat", "pack", "0100001A.bin", "--role", "portal", "-o", "a.dat"}, "0100001A.bin");
    expectRefusal(runner, {"dat", "pack", ".", "-o", "a.dat"}, "--role");
    expectRefusal(runner, {"dat", "pack", ".", "--role", "portal", "--without", "13000000", "-o", "a.dat"},
                  "--base");
    expectRefusal(runner, {"dat", "pack", "--base", "missing.dat", "-o", "a.dat"}, "missing.dat");
    EXPECT_FALSE(std::filesystem::exists(runner.work() / "a.dat"));
}

TEST(Program, datVerifyFindsTheBuiltInWorldWhole) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"dat", "verify", "--json"});
    EXPECT_EQ(run.exit, 0) << run.err;
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_GT(report["kinds"]["EnvCell"]["records"], 100);
    EXPECT_TRUE(report["faults"].empty());
    EXPECT_EQ(report["unresolved"], 0);
    EXPECT_THAT(runner.run({"dat", "verify"}).out, HasSubstr("0 unreadable, 0 changed, 0 unresolved"));
    expectRefusal(runner, {"dat", "verify", "missing"}, "missing");
}

TEST(Program, benchListsItsNames) {
    const ProgramRun run = ProgramRunner().run({"bench", "--list"});
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, testing::AllOf(HasSubstr("dat"), HasSubstr("flood")));
}

TEST(Program, benchRefusesPicturesThatItCannotWrite) {
    const ProgramRunner runner;
    expectRefusal(runner, {"bench", "flood", "--pictures", "."}, "'flood' draws no pictures");
    expectRefusal(runner, {"bench", "frame", "--pictures", "missing"}, "missing");
}

TEST(Program, saysWhenStandardOutputIsFull) {
    const std::string command = std::string("XDG_CACHE_HOME='") + ProgramRunner::cache().string() + "' " +
                                LIMEN_PROGRAM + " dat ls >/dev/full 2>/dev/null";
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
}

/// During its lifetime, started programs find no OpenGL driver.
struct NoDriver {
    NoDriver() {
        for (const char* name : kNames)
            setenv(name, "/nonexistent", 1);
    }
    ~NoDriver() {
        for (const char* name : kNames)
            unsetenv(name);
    }
    static constexpr const char* kNames[] = {"__EGL_VENDOR_LIBRARY_FILENAMES", "__EGL_VENDOR_LIBRARY_DIRS"};
};

TEST(Program, tracesTheReferenceWithoutADriver) {
    const ProgramRunner runner;
    const NoDriver none;
    const std::vector<std::string> view{"shot", "--at", "cottage.room", "--size", "48x27", "--ids", "i.npy"};
    expectRefusal(runner, view, "EGL");
    std::vector<std::string> traced = view;
    for (const char* more : {"--reference", "--depth", "d.npy", "--json", "f.json", "-o", "a.png"})
        traced.emplace_back(more);
    const ProgramRun run = runner.run(traced);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(runner.work().entryCount(), 4u);
    EXPECT_EQ(getText(runner.work() / "i.npy").substr(1, 5), "NUMPY");
    EXPECT_EQ(getText(runner.work() / "a.png").substr(1, 3), "PNG");
    const auto json = nlohmann::json::parse(getText(runner.work() / "f.json"));
    EXPECT_EQ(json["driver"], "reference");
    EXPECT_EQ(json["gl_calls"], 0);
    EXPECT_TRUE(json["stages"].empty() && json["visits"].empty());
    EXPECT_FALSE(json["cells"].empty());
    EXPECT_EQ(json["void_pixels"], 0);
    EXPECT_THAT(json["command"].get<std::string>(), testing::EndsWith(" --reference"));
}

TEST(Program, refusesTheOverlayOfATracedFrame) {
    const ProgramRunner runner;
    expectRefusal(runner, {"shot", "--at", "hill", "--reference", "--overlay", "o.png"}, "--overlay");
    putText(runner.work() / "views", "--at hill --overlay o.png\n");
    expectRefusal(runner, {"shot", "--views", "views", "-o", "out", "--reference"}, "--overlay");
    EXPECT_FALSE(std::filesystem::exists(runner.work() / "out"));
}

TEST(Program, tracesManyViewsAsOneByOne) {
    const ProgramRunner runner;
    putText(runner.work() / "views", "--at hill --ids hill.npy\n--at cottage.room --ids room.npy\n");
    EXPECT_EQ(runner.run({"shot", "--views", "views", "-o", "out", "--size", "48x27", "--reference"}).exit,
              0);
    for (const auto& [place, file] : {std::pair("hill", "hill.npy"), {"cottage.room", "room.npy"}}) {
        EXPECT_EQ(
            runner.run({"shot", "--at", place, "--size", "48x27", "--reference", "--ids", "one.npy"}).exit,
            0);
        const std::string alone = getText(runner.work() / "one.npy");
        EXPECT_EQ(alone.size(), 128u + 48u * 27u * 4u);
        EXPECT_EQ(alone, getText(runner.work() / "out" / file)) << place;
    }
}

} // namespace
} // namespace limen::cli
