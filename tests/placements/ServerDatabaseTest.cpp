#include "MariaDbServer.h"
#include "SampleContent.h"
#include "ServerSchema.h"
#include "SqlTestFiles.h"
#include "placements/Import.h"
#include "placements/WorldDb.h"

#include <gtest/gtest.h>
#include <optional>

// Import from a real server, compared with the import of the same rows from files.
namespace {

using namespace limen;
using namespace limen::test;
using placements::Content;

class ServerDatabase : public testing::Test {
protected:
    static void SetUpTestSuite() { server_.emplace(); }
    static void TearDownTestSuite() { server_.reset(); }

    void SetUp() override { ASSERT_TRUE(server_->isReady()); }

    static void make(const std::string& database, const std::string& tables) {
        ASSERT_EQ(server_->run("CREATE DATABASE `" + database + "` CHARACTER SET utf8mb4"), "");
        ASSERT_EQ(server_->run(tables, database), "");
    }
    /// Executes files of SQL as the published ones are executed.
    static void load(const std::string& database, const std::filesystem::path& directory) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(directory))
            if (entry.path().extension() == ".sql")
                files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const auto& file : files)
            ASSERT_EQ(server_->run(getText(file), database), "") << file;
    }
    static std::string url(const std::string& database, const std::string& user = "root") {
        return "mariadb://" + user + "@/" + database + "?socket=" + server_->socket();
    }
    static Result<Content> import(const std::string& database) {
        return placements::importServer({url(database), "", {}});
    }
    static std::string faultOf(const placements::ServerAccess& access) {
        const Result<Content> content = placements::importServer(access);
        return content ? "none" : content.error().message();
    }

    static std::optional<MariaDbServer> server_;
};
std::optional<MariaDbServer> ServerDatabase::server_;

TEST_F(ServerDatabase, equalRowsGiveEqualFiles) {
    make("equal", serverSchema());
    const TemporaryDirectory directory;
    const Content content = SampleContent(42).make(40, 150);
    putContent(directory / "sql", content);
    load("equal", directory / "sql");

    const Result<Content> fromServer = import("equal");
    ASSERT_TRUE(fromServer.has_value()) << fromServer.error().message();
    const Result<Content> fromFiles = placements::importSqlFiles({directory / "sql"});
    ASSERT_TRUE(fromFiles.has_value()) << fromFiles.error().message();
    EXPECT_TRUE(*fromServer == content);
    EXPECT_TRUE(*fromFiles == content);

    const placements::Origin origin{"x", "y"};
    ASSERT_TRUE(placements::writeWorldDb(directory / "server.db", *fromServer, origin).has_value());
    ASSERT_TRUE(placements::writeWorldDb(directory / "files.db", *fromFiles, origin).has_value());
    EXPECT_TRUE(getText(directory / "server.db") == getText(directory / "files.db")) << "byte for byte";
}

TEST_F(ServerDatabase, rowsThatWereTypedByHandAreEqual) {
    make("typed", serverSchema());
    const TemporaryDirectory directory;
    putText(directory / "1.sql",
            "DELETE FROM `weenie` WHERE `class_Id` = 5;\n"
            "INSERT INTO `weenie` (`class_Id`, `class_Name`, `type`, `last_Modified`)\n"
            "VALUES (5, 'gate', 19, '2020-01-01 00:00:00') /* Door */;\n"
            "INSERT INTO `weenie_properties_float` (`object_Id`, `type`, `value`)\nVALUES (5,  12,  0.33) , "
            "(5, 39, 1e-7);\n"
            "INSERT INTO `weenie_properties_bool` (`object_Id`, `type`, `value`)\nVALUES (5,   2, True ), "
            "(5, 34, False);\n"
            "INSERT INTO `weenie_properties_string` (`object_Id`, `type`, `value`)\n"
            "VALUES (5, 1, 'Mar\u00EDa''s \\\"gate\\\" \\\\ \U0001F6AA;');\n"
            "INSERT INTO `landblock_instance` (`guid`, `weenie_Class_Id`, `obj_Cell_Id`, `origin_X`, "
            "`origin_Y`, `origin_Z`, "
            "`angles_W`, `angles_X`, `angles_Y`, `angles_Z`, `is_Link_Child`, `last_Modified`)\n"
            "VALUES (0x7C000001, 5, 0xC0010100, 84.1029, 16777217, 0.1, -0.707107, -0, -0.0, 1e-40, True, "
            "'2020-01-02');\n");
    load("typed", directory.path());
    const Result<Content> fromServer = import("typed");
    const Result<Content> fromFiles = placements::importSqlFiles({directory.path()});
    ASSERT_TRUE(fromServer.has_value()) << fromServer.error().message();
    ASSERT_TRUE(fromFiles.has_value()) << fromFiles.error().message();
    EXPECT_TRUE(*fromServer == *fromFiles);
    EXPECT_EQ(fromServer->templates.at(5).name, "Mar\u00EDa's \"gate\" \\ \U0001F6AA;");
    EXPECT_EQ(fromServer->landblocks.at(0xC001).placements[0].spot.origin[1], 16777216.0f);
}

TEST_F(ServerDatabase, theImportWritesNothing) {
    make("unchanged", serverSchema());
    const TemporaryDirectory directory;
    putContent(directory / "sql", SampleContent(7).make(3, 3));
    load("unchanged", directory / "sql");
    ASSERT_EQ(server_->run("CREATE USER reader@localhost IDENTIFIED BY 'right'; GRANT SELECT ON unchanged.* "
                           "TO reader@localhost"),
              "");
    const Result<Content> content = placements::importServer({url("unchanged", "reader"), "right", {}});
    ASSERT_TRUE(content.has_value()) << content.error().message();
    EXPECT_TRUE(*content == SampleContent(7).make(3, 3)) << "a user who may only read is enough";

    putText(directory / "options", "[client]\nuser=reader\npassword=right\n");
    const Result<Content> byFile = placements::importServer(
        {"mariadb:///unchanged?socket=" + server_->socket(), "", directory / "options"});
    ASSERT_TRUE(byFile.has_value()) << byFile.error().message();
    EXPECT_TRUE(*byFile == *content);

    const std::string fault = faultOf({url("unchanged", "reader"), "wrong", {}});
    EXPECT_NE(fault.find("Access denied"), std::string::npos) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos);
    EXPECT_EQ(fault.find("wrong"), std::string::npos);
}

TEST_F(ServerDatabase, faultsAreOneLine) {
    const std::string absent = faultOf({"mariadb://root@/x?socket=/nowhere/s", "", {}});
    EXPECT_NE(absent.find("connect"), std::string::npos) << absent;
    EXPECT_EQ(absent.find('\n'), std::string::npos);
    EXPECT_NE(faultOf({url("absent"), "", {}}).find("Unknown database"), std::string::npos);
    make("foreign", "CREATE TABLE `x` (`y` int)");
    EXPECT_NE(faultOf({url("foreign"), "", {}}).find("not a world database"), std::string::npos);
    for (const placements::Table& table : placements::tables()) {
        make("lacks", serverSchema(std::string(table.name)));
        const std::string fault = faultOf({url("lacks"), "", {}});
        EXPECT_NE(fault.find(table.name), std::string::npos) << fault;
        ASSERT_EQ(server_->run("DROP DATABASE `lacks`"), "");
    }
    make("column", serverSchema("weenie_properties_palette.offset"));
    EXPECT_NE(faultOf({url("column"), "", {}}).find("offset"), std::string::npos)
        << faultOf({url("column"), "", {}});
    make("type", serverSchema());
    ASSERT_EQ(server_->run("ALTER TABLE weenie MODIFY `type` varchar(20)", "type"), "");
    EXPECT_NE(faultOf({url("type"), "", {}}).find("column type of weenie has another type"),
              std::string::npos)
        << faultOf({url("type"), "", {}});
    make("empty", serverSchema());
    EXPECT_NE(faultOf({url("empty"), "", {}}).find("no placed objects"), std::string::npos);
}

TEST_F(ServerDatabase, progressCancels) {
    make("large", serverSchema());
    std::string rows = "INSERT INTO `weenie` VALUES (1, 'a', 1, NULL)";
    for (int i = 2; i < 10'000; ++i)
        rows += ", (" + std::to_string(i) + ", 'a" + std::to_string(i) + "', 1, NULL)";
    ASSERT_EQ(server_->run(rows, "large"), "");
    const Result<Content> cancelled =
        placements::importServer({url("large"), "", {}}, [](std::size_t, std::size_t) { return false; });
    ASSERT_FALSE(cancelled.has_value());
    EXPECT_NE(cancelled.error().message().find("cancelled"), std::string::npos);
    std::size_t last = 0, total = 0;
    ASSERT_TRUE(placements::importServer({url("large"), "", {}}, [&](std::size_t done, std::size_t of) {
                    EXPECT_LE(done, of);
                    last = done;
                    total = of;
                    return true;
                }).has_value());
    EXPECT_GT(last, 0u);
    EXPECT_EQ(total, 9'999u);
}

} // namespace
