#include "cli/ProgramRunner.h"

#include <gmock/gmock.h>

namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using testing::HasSubstr;

/// Width and height in a PNG's header.
std::pair<unsigned, unsigned> pngSize(const std::filesystem::path& path) {
    const std::string bytes = getText(path);
    if (bytes.size() < 24)
        return {0, 0};
    const auto number = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = at; i < at + 4; ++i)
            value = value * 256 + static_cast<unsigned char>(bytes[i]);
        return value;
    };
    return {number(16), number(20)};
}

TEST(Map, writesTheLandscapeAndSaysWhatItWrote) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"map"});
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("map.png: "));
    const auto [width, height] = pngSize(runner.work() / "map.png");
    EXPECT_GE(width, 40u) << "five landblocks or more";
    EXPECT_GE(height, 40u);
    EXPECT_EQ(width % 8, 0u);
    const ProgramRun large = runner.run({"map", "--scale", "24", "--labels", "-o", "large.png"});
    EXPECT_EQ(large.exit, 0) << large.err;
    EXPECT_EQ(pngSize(runner.work() / "large.png"), (std::pair{width * 3, height * 3}));
    const ProgramRun small = runner.run({"map", "--size", "20x200", "-o", "small.png"});
    EXPECT_EQ(small.exit, 0) << small.err;
    EXPECT_LE(pngSize(runner.work() / "small.png").first, 20u);
    EXPECT_EQ(runner.work().entryCount(), 3u);
}

TEST(Map, wrongUsesAreRefusedInALine) {
    const ProgramRunner runner;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"map", "--scale", "7"},
                                                      {"map", "--size", "20"},
                                                      {"map", "--dat", "none"},
                                                      {"map", "-o", "none/map.png"}}) {
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 2) << arguments[1];
        EXPECT_EQ(run.errorLines(), 1u) << run.err;
    }
    EXPECT_EQ(runner.work().entryCount(), 0u);
}

TEST(Shot, supersamplingIsRefusedWhereItMeansNothing) {
    const ProgramRunner runner;
    const auto refused = [&](const std::vector<std::string>& more, const char* says) {
        std::vector<std::string> arguments{"shot", "--at", "hill", "--supersample", "4"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramRun run = runner.run(arguments);
        EXPECT_EQ(run.exit, 2);
        EXPECT_EQ(run.errorLines(), 1u) << run.err;
        EXPECT_THAT(run.err, HasSubstr(says));
    };
    refused({"--ids", "i.npy"}, "one value a pixel");
    refused({"--depth", "d.npy"}, "one value a pixel");
    refused({"--reference", "-o", "a.png"}, "--reference");
    refused({"--size", "8192x8192", "-o", "a.png"}, "use supersampling of 2");
    EXPECT_EQ(runner.work().entryCount(), 0u);
}

} // namespace
} // namespace limen::cli
