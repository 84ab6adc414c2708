#include "cli/ProgramRunner.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

// `limen world`: each of its verbs, and one line for each wrong use.
namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;

const char* const kRows = "INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`, `last_Modified`) VALUES "
                          "(5, 'gate', 19, '2020-01-01'), (6, 'it', 10, '2020-01-01');\n"
                          "INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`) VALUES (5, "
                          "1, 'Old Gate'), (6, 1, 'A \x1B[31m name');\n"
                          "INSERT INTO `landblock_instance` (`guid`, `weenie_Class_Id`, `obj_Cell_Id`, "
                          "`origin_X`, `origin_Y`, `origin_Z`, `angles_W`, "
                          "`angles_X`, `angles_Y`, `angles_Z`, `is_Link_Child`, `last_Modified`) VALUES\n"
                          "(0x7C000001, 5, 0xC0010100, 12.5, 3, 0.25, 1, 0, 0, 0, False, '2020-01-02'),\n"
                          "(0x7C000002, 6, 0xC0010000, 1, 2, 3, 1, 0, 0, 0, False, '2020-01-02');\n";

TEST(WorldVerb, importsListsShowsAndCounts) {
    const ProgramRunner runner;
    putText(runner.work() / "rows.sql", kRows);
    ProgramRun run = runner.run({"world", "import", "rows.sql"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("world.db: 2 placed objects, 2 templates"));
    run = runner.run({"world", "import", "rows.sql", "-o", "world.db"});
    EXPECT_THAT(run.err, HasSubstr("is up to date"));

    run = runner.run({"world", "list", "--dat", "world.db"});
    EXPECT_THAT(run.out, HasSubstr("0x7C000001"));
    EXPECT_THAT(run.out, HasSubstr("Old Gate"));
    EXPECT_EQ(run.out.find('\x1B'), std::string::npos) << "no control character reaches the terminal";
    run = runner.run({"world", "list", "--dat", "world.db", "--name", "gate", "--json"});
    const auto gate = nlohmann::json::parse(run.out);
    EXPECT_EQ(gate["cell"], "0xC0010100");
    EXPECT_EQ(gate["position"][0], 0xC0 * 192.0 + 12.5);
    EXPECT_EQ(runner.run({"world", "list", "--dat", "world.db", "--block", "C002"}).out, "");

    run = runner.run({"world", "show", "0x7C000001", "--dat", "world.db"});
    EXPECT_EQ(nlohmann::json::parse(run.out)["template"]["name"], "Old Gate");
    run = runner.run({"world", "show", "6", "--dat", "world.db"});
    EXPECT_EQ(nlohmann::json::parse(run.out)["type"], "creature");
    run = runner.run({"world", "stats", "--dat", "world.db", "--json"});
    EXPECT_EQ(nlohmann::json::parse(run.out)["objects"]["door"], 1);
}

TEST(WorldVerb, exportsRowsThatImportGivesAgain) {
    const ProgramRunner runner;
    putText(runner.work() / "rows.sql", kRows);
    ASSERT_EQ(runner.run({"world", "import", "rows.sql"}).exit, 0);
    ASSERT_EQ(runner.run({"world", "export", "--dat", "world.db", "-o", "out"}).exit, 0);
    EXPECT_TRUE(std::filesystem::exists(runner.work() / "out/6 LandBlockExtendedData/C001.sql"));
    const ProgramRun again = runner.run({"world", "import", "out"});
    EXPECT_THAT(again.err, HasSubstr("is up to date"));
    ASSERT_EQ(runner.run({"world", "export", "--dat", "world.db", "--as", "json", "-o", "all.json"}).exit, 0);
    EXPECT_EQ(nlohmann::json::parse(getText(runner.work() / "all.json")).size(), 2u);
}

TEST(WorldVerb, readsTheWorldFileOfTheBuiltInWorld) {
    const ProgramRunner runner;
    const ProgramRun doors = runner.run({"world", "list", "--type", "door", "--json"});
    EXPECT_EQ(doors.exit, 0) << doors.err;
    EXPECT_GT(std::count(doors.out.begin(), doors.out.end(), '\n'), 20);
    EXPECT_THAT(runner.run({"world", "show", "inn.front"}).out, HasSubstr("\"door\""));
    EXPECT_THAT(runner.run({"world", "stats"}).out, HasSubstr("villager"));
}

TEST(WorldVerb, wrongUseIsOneLineAndWritesNothing) {
    const ProgramRunner runner;
    putText(runner.work() / "cut.sql", "INSERT INTO `weenie` (`class_Id`");
    putText(runner.work() / "precious", "precious");
    const auto expectRefused = [&](const std::vector<std::string>& arguments, const char* reason) {
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 2) << run.err;
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(run.errorLines(), 1u) << run.err;
        EXPECT_THAT(run.err, HasSubstr(reason));
    };
    expectRefused({"world", "import", "cut.sql"}, "cut.sql:1: the file ends within a statement");
    expectRefused({"world", "import", "absent"}, "no such file or directory");
    expectRefused({"world", "import", "mariadb://a:b@c/d"}, "MYSQL_PWD");
    expectRefused({"world", "import", "mariadb://root@/d?socket=/nowhere/s"}, "connect");
    expectRefused({"world", "import", "cut.sql", "mariadb://a@c/d"}, "one URL, or paths");
    expectRefused({"world", "import", "cut.sql", "-o", "absent/world.db"}, "absent");
    expectRefused({"world", "import"}, "SOURCE");
    expectRefused({"view", "--import", "cut.sql"}, "--import: writes a world.db beside your dat files");
    expectRefused({"view", "--dat", "absent", "--import", "cut.sql"}, "there is no such directory");
    expectRefused({"world", "list", "--dat", "precious"}, "precious");
    expectRefused({"world", "show", "0x1", "--dat", "precious"}, "precious");
    expectRefused({"world", "list", "--block", "nowhere"}, "--block");
    expectRefused({"world", "export", "--as", "xml"}, "xml");
    EXPECT_EQ(runner.work().entryCount(), 2u) << "no world.db, and nothing beside it";
    putText(runner.work() / "rows.sql", kRows);
    expectRefused({"world", "import", "rows.sql", "-o", "precious"}, "another file has this name");
    EXPECT_EQ(getText(runner.work() / "precious"), "precious");
}

} // namespace
} // namespace limen::cli
