#include "cli/ProgramRunner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

// `limen doctor` and `limen dat verify --retail`, as a user runs them.
namespace {

using limen::test::getText;
using limen::test::ProgramRun;
using limen::test::putText;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class DoctorProgram : public testing::Test {
protected:
    limen::test::ProgramRunner runner;

    /// A directory with copies of the built-in world's dat files.
    [[nodiscard]] std::filesystem::path copiedWorld() const {
        const std::filesystem::path directory = runner.work() / "world";
        EXPECT_EQ(runner.run({"demo", directory.string()}).exit, 0);
        return directory;
    }
    /// The result of a check in the JSON of a run.
    [[nodiscard]] static std::string resultOf(const nlohmann::json& report, const std::string& check) {
        for (const auto& row : report["checks"])
            if (row["check"] == check)
                return row["result"];
        return "no such check";
    }
};

TEST_F(DoctorProgram, findsTheBuiltInWorldWhole) {
    const ProgramRun run = runner.run({"doctor", "--json"});
    const auto report = nlohmann::json::parse(run.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded()) << run.out << run.err;
    for (const char* check :
         {"portal", "portal index", "cell", "cell index", "region", "shapes", "ground", "sample"})
        EXPECT_EQ(resultOf(report, check), "ok") << check;
    EXPECT_EQ(resultOf(report, "display"), "warning") << "this runner has no display";
}

TEST_F(DoctorProgram, tableFitsIntoEightyColumns) {
    const ProgramRun run = runner.run({"doctor"});
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    EXPECT_THAT(run.out, HasSubstr("portal index     ok"));
}

TEST_F(DoctorProgram, emptyDirectoryIsAFindingAndNoDirectoryIsAnError) {
    std::filesystem::create_directory(runner.work() / "empty");
    const ProgramRun empty = runner.run({"doctor", "empty"});
    EXPECT_EQ(empty.exit, 1);
    EXPECT_THAT(empty.out, HasSubstr("client_portal.dat"));
    const ProgramRun none = runner.run({"doctor", "nothing"});
    EXPECT_EQ(none.exit, 2);
    EXPECT_THAT(none.out, IsEmpty());
    EXPECT_EQ(none.errorLines(), 1u);
}

TEST_F(DoctorProgram, damagedFileIsNamedAndTheOtherIsStillExamined) {
    const std::filesystem::path world = copiedWorld();
    std::string bytes = getText(world / "client_portal.dat");
    putText(world / "client_portal.dat", bytes.substr(0, bytes.size() / 3));
    const ProgramRun run = runner.run({"doctor", world.string(), "--json"});
    EXPECT_EQ(run.exit, 1);
    const auto report = nlohmann::json::parse(run.out);
    EXPECT_EQ(resultOf(report, "portal"), "failed");
    EXPECT_EQ(resultOf(report, "cell"), "ok");
    EXPECT_EQ(report["ready"], false);
}

TEST_F(DoctorProgram, flippedBytesNeverCrash) {
    const std::filesystem::path world = copiedWorld();
    const std::string bytes = getText(world / "client_cell_1.dat");
    for (std::size_t at = 0x140; at < bytes.size(); at += bytes.size() / 6 + 37) {
        std::string damaged = bytes;
        for (std::size_t i = at; i < std::min(at + 8, damaged.size()); ++i)
            damaged[i] = static_cast<char>(~damaged[i]);
        putText(world / "client_cell_1.dat", damaged);
        EXPECT_THAT(runner.run({"doctor", world.string(), "--thorough"}).exit, testing::AnyOf(0, 1)) << at;
    }
}

TEST_F(DoctorProgram, retailSaysThatTheseAreOtherFilesAndWritesAReport) {
    const ProgramRun run = runner.run({"dat", "verify", "--retail", "--report", "report.json"});
    EXPECT_EQ(run.exit, 1) << "facts about other files are wrong here";
    EXPECT_THAT(run.err, HasSubstr("not the original files"));
    EXPECT_THAT(run.err, HasSubstr("wrote report.json"));
    EXPECT_THAT(run.out, HasSubstr("not there"));
    const auto report = nlohmann::json::parse(getText(runner.work() / "report.json"));
    EXPECT_EQ(report["format"], "limen-retail-report");
    EXPECT_EQ(report["release"], "unknown release");
    EXPECT_EQ(report["areas"]["rule"]["wrong"], 0);
    EXPECT_EQ(report.dump().find(runner.work().path().string()), std::string::npos) << "no path";
}

TEST_F(DoctorProgram, retailOptionsNeedRetail) {
    EXPECT_EQ(runner.run({"dat", "verify", "--report", "x.json"}).exit, 2);
    EXPECT_EQ(runner.run({"dat", "verify", "--retail", "--report", "none/x.json"}).exit, 2);
}

} // namespace
