#include "cli/ProgramRunner.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

// Pictures, films and turn-tables of `limen tour`, run as a process. Reports: tests/browser.
namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using testing::HasSubstr;
using testing::StartsWith;

bool hasFfmpeg() {
    return std::system("command -v ffmpeg >/dev/null") == 0;
}

TEST(TourOutputs, picturesHaveTheChosenFormat) {
    const ProgramRunner runner;
    const ProgramRun run =
        runner.run({"tour", "-o", "t", "--frames", "2", "--size", "64x36", "--format", "webp"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(getText(runner.work() / "t/frame-00001.webp").substr(8, 4), "WEBP");
    EXPECT_EQ(getText(runner.work() / "t/contact.webp").substr(8, 4), "WEBP");
    ASSERT_EQ(runner.run({"shot", "--at", "lane", "--size", "64x36", "-o", "a.JPG"}).exit, 0);
    EXPECT_THAT(getText(runner.work() / "a.JPG"), StartsWith("\xFF\xD8\xFF"));
}

TEST(TourOutputs, aTurnTableBecomesAFilm) {
    if (!hasFfmpeg())
        GTEST_SKIP() << "ffmpeg is not installed";
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"tour", "--turn-table", "--at", "lane", "--frames", "6", "--size",
                                       "64x36", "--film", "lane.gif", "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("6 frames (0.2 s at 30 a second)"));
    EXPECT_THAT(getText(runner.work() / "lane.gif"), StartsWith("GIF89a"));
    EXPECT_EQ(runner.work().entryCount(), 1u) << "the film alone";
    std::istringstream lines(run.out);
    std::set<std::string> eyes;
    for (std::string line; std::getline(lines, line);) {
        const std::string command = nlohmann::json::parse(line)["command"];
        eyes.insert(command.substr(0, command.find(" --yaw")));
    }
    EXPECT_EQ(eyes.size(), 6u) << "the camera moves";
}

TEST(TourOutputs, aWalkBecomesAFilmAtItsOwnPace) {
    if (!hasFfmpeg())
        GTEST_SKIP() << "ffmpeg is not installed";
    const ProgramRunner runner;
    test::putText(runner.work() / "path", "--at cottage.front\n--eye=32535.2,34654.4,31.7\n");
    ASSERT_EQ(runner.run({"walk", "--path", "path", "-o", "walk", "--size", "48x28"}).exit, 0);
    const ProgramRun run = runner.run({"tour", "--walk", "walk", "--film", "w.webp", "--report", "report"});
    ASSERT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(getText(runner.work() / "w.webp").substr(8, 4), "WEBP");
    EXPECT_THAT(getText(runner.work() / "report/index.html"), HasSubstr("No finding"));
}

} // namespace
} // namespace limen::cli
