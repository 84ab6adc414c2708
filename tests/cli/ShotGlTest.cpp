#include "cli/ProgramRunner.h"

#include "engine/ViewRequest.h"
#include "engine/WorldSource.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <numeric>
#include <png.h>
#include <set>

namespace limen::cli {
namespace {

using test::getText;
using test::ProgramRun;
using test::ProgramRunner;
using test::putText;
using testing::HasSubstr;

/// A parsed NumPy file: its header and the bytes of its elements.
struct Npy {
    std::string header, data;
    template <class T>
    [[nodiscard]] std::vector<T> values() const {
        std::vector<T> result(data.size() / sizeof(T));
        std::memcpy(result.data(), data.data(), result.size() * sizeof(T));
        return result;
    }
};

Npy readNpy(const std::filesystem::path& path) {
    const std::string bytes = getText(path);
    EXPECT_GT(bytes.size(), 10u) << path;
    if (bytes.size() < 10)
        return {};
    const std::size_t length =
        static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
    return {bytes.substr(10, length), bytes.substr(10 + length)};
}

void expectDone(const ProgramRun& run) {
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.out, "");
}

TEST(Shot, writesWhatItIsAskedForAndNothingElse) {
    const ProgramRunner runner;
    const ProgramRun none = runner.run({"shot", "--at", "hill", "--size", "64x36"});
    EXPECT_EQ(none.exit, 2);
    EXPECT_THAT(none.err, HasSubstr("no output given"));
    EXPECT_EQ(runner.work().entryCount(), 0u);
    expectDone(runner.run({"shot", "--at", "hill", "--size", "64x36", "-o", "a.png"}));
    EXPECT_EQ(runner.work().entryCount(), 1u);
}

TEST(Shot, withoutAViewpointShowsTheWorldsStart) {
    const ProgramRunner runner;
    expectDone(runner.run({"demo", "--bare", "--kind", "town", "--size", "3", "town"}));
    std::filesystem::remove(runner.work() / "town" / "world.json");
    expectDone(runner.run({"shot", "--dat", "town", "--size", "64x36", "-o", "a.png", "--json", "a.json"}));
    const auto frame = nlohmann::json::parse(getText(runner.work() / "a.json"));
    const engine::WorldSource source = engine::openWorldSource((runner.work() / "town").string()).value();
    const world::Place* start = engine::firstPlace(source.file);
    ASSERT_NE(start, nullptr);
    EXPECT_EQ(frame["eye"], (nlohmann::json{start->eye.x, start->eye.y, start->eye.z}));
}

TEST(Shot, supersamplingSmoothsAndKeepsTheSize) {
    const ProgramRunner runner;
    expectDone(runner.run({"shot", "--at", "hill", "--size", "64x36", "-o", "a.png"}));
    expectDone(runner.run({"shot", "--at", "hill", "--size", "64x36", "--supersample", "2", "-o", "b.png"}));
    const std::string one = getText(runner.work() / "a.png"), four = getText(runner.work() / "b.png");
    EXPECT_EQ(one.substr(0, 29), four.substr(0, 29)) << "the header: the same size";
    EXPECT_NE(one, four);
}

TEST(Shot, idsDepthAndJsonAgree) {
    const ProgramRunner runner;
    expectDone(runner.run({"shot", "--at", "cottage.room", "--size", "96x54", "--ids", "i.npy", "--depth",
                           "d.npy", "--json", "f.json"}));
    const Npy ids = readNpy(runner.work() / "i.npy"), depth = readNpy(runner.work() / "d.npy");
    EXPECT_THAT(ids.header, testing::AllOf(HasSubstr("'<u4'"), HasSubstr("(54, 96)")));
    EXPECT_THAT(depth.header, testing::AllOf(HasSubstr("'<f4'"), HasSubstr("(54, 96)")));
    const auto idValues = ids.values<std::uint32_t>();
    const auto depthValues = depth.values<float>();
    ASSERT_EQ(idValues.size(), 96u * 54u);
    ASSERT_EQ(depthValues.size(), idValues.size());
    for (std::size_t i = 0; i < idValues.size(); ++i)
        if (idValues[i] == 0)
            EXPECT_TRUE(std::isnan(depthValues[i]));
        else if (idValues[i] == 1)
            EXPECT_TRUE(std::isinf(depthValues[i]) && depthValues[i] > 0);
        else
            EXPECT_TRUE(std::isfinite(depthValues[i]) && depthValues[i] > 0) << depthValues[i];
    const auto json = nlohmann::json::parse(getText(runner.work() / "f.json"));
    const std::set<std::uint32_t> distinct(idValues.begin(), idValues.end());
    EXPECT_EQ(json["ids"].size(), distinct.size());
    for (const std::uint32_t id : distinct)
        EXPECT_TRUE(json["ids"].contains(std::to_string(id))) << id;
    EXPECT_EQ(json["visits"][0]["parent"], -1);
    EXPECT_THAT(json["root"].get<std::string>(), testing::StartsWith("0x"));
    EXPECT_LE(json["gl_calls"].get<int>(), 40);
    EXPECT_EQ(json["stages"].size(), 5u);
    for (const auto& [id, meaning] : json["ids"].items())
        EXPECT_NE(meaning["kind"], "unknown") << id;
}

TEST(Shot, theReproductionCommandDrawsTheSamePicture) {
    const ProgramRunner runner;
    expectDone(runner.run(
        {"shot", "--at", "cottage.front", "--size", "96x54", "--ids", "a.npy", "--json", "a.json"}));
    const std::string command = nlohmann::json::parse(getText(runner.work() / "a.json"))["command"];
    EXPECT_THAT(command, HasSubstr("--root="));
    std::istringstream words(command);
    std::vector<std::string> arguments;
    for (std::string word; words >> word;)
        arguments.push_back(word);
    arguments.erase(arguments.begin()); // the program's name
    for (const char* more : {"--ids", "b.npy"})
        arguments.emplace_back(more);
    expectDone(runner.run(arguments));
    EXPECT_EQ(getText(runner.work() / "a.npy"), getText(runner.work() / "b.npy"));
}

TEST(Shot, readingsChangeThePicture_theirDefaultsDoNot) {
    const ProgramRunner runner;
    const auto pictureBy = [&](const std::string& readings) {
        std::vector<std::string> arguments{"shot",  "--at", "hill",  "--pitch", "20",    "--size",
                                           "96x54", "-o",   "a.png", "--json",  "a.json"};
        if (!readings.empty())
            arguments.insert(arguments.end(), {"--readings", readings});
        expectDone(runner.run(arguments));
        return getText(runner.work() / "a.png");
    };
    const std::string usual = pictureBy("");
    EXPECT_THAT(getText(runner.work() / "a.json"), testing::Not(HasSubstr("readings")));
    EXPECT_EQ(pictureBy("sky-place=eye,sky-particles=around,cell-fog=world,wall-emission=added,"
                        "surface-diffuse=none,wall-grey=1,normals=unit,details=on,grain=lit,level-bias=1"),
              usual);
    EXPECT_NE(pictureBy("sky-place=block"), usual) << "domes are elsewhere";
    EXPECT_THAT(getText(runner.work() / "a.json"), HasSubstr("--readings=sky-place=block"));
    const ProgramRun refused =
        runner.run({"shot", "--at", "hill", "--readings", "sky-place=moon", "-o", "a.png"});
    EXPECT_EQ(refused.exit, 2);
    EXPECT_THAT(refused.err, HasSubstr("'moon' is not a value of sky-place; choose from eye, block, cell"));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1);
}

TEST(Shot, manyViewsGiveTheSameAsOneByOne) {
    const ProgramRunner runner;
    putText(
        runner.work() / "views",
        "--at hill -o hill.png --ids hill.npy\n# a comment\n--at cottage.room --ids room.npy\n--at lane\n");
    expectDone(runner.run({"shot", "--views", "views", "-o", "out", "--size", "64x36"}));
    EXPECT_TRUE(std::filesystem::exists(runner.work() / "out/hill.png"));
    EXPECT_TRUE(std::filesystem::exists(runner.work() / "out/0002.png"));
    expectDone(runner.run({"shot", "--at", "cottage.room", "--size", "64x36", "--ids", "room.npy"}));
    EXPECT_EQ(readNpy(runner.work() / "room.npy").data.size(), 64u * 36u * 4u);
    EXPECT_EQ(getText(runner.work() / "room.npy"), getText(runner.work() / "out/room.npy"));
}

TEST(Shot, refusesADepthImageOfTheDepthGate) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"shot", "--at", "hill", "--gate", "depth", "--depth", "d.npy"});
    EXPECT_EQ(run.exit, 2);
    EXPECT_NE(run.err.find("the depth gate overwrites depth"), std::string::npos) << run.err;
    EXPECT_EQ(runner.work().entryCount(), 0u);
}

TEST(Shot, refusesACellThatIsNotThere) {
    const ProgramRunner runner;
    const ProgramRun run =
        runner.run({"shot", "--at", "cottage.room", "--root", "0xA9B4FFF0", "-o", "a.png"});
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(run.errorLines(), 1u) << run.err;
    EXPECT_EQ(runner.work().entryCount(), 0u);
}

TEST(Shot, drawsTheOverlayOfTheVisits) {
    const ProgramRunner runner;
    expectDone(runner.run(
        {"shot", "--at", "cottage.front", "--size", "160x90", "-o", "a.png", "--overlay", "b.png"}));
    EXPECT_NE(getText(runner.work() / "a.png"), getText(runner.work() / "b.png"));
}

/// The ids of a place. Errors that a driver writes are shown if the test fails later.
std::vector<std::uint32_t> idsOf(const ProgramRunner& runner, const char* place, const char* zones) {
    const ProgramRun run =
        runner.run({"shot", "--at", place, "--size", "160x90", "--ids", "ids.npy", "--zones", zones});
    expectDone(run);
    std::printf("%s, %s: %s\n", place, zones, run.err.c_str());
    return readNpy(runner.work() / "ids.npy").values<std::uint32_t>();
}

std::ptrdiff_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    return static_cast<std::ptrdiff_t>(a.size()) - std::inner_product(a.begin(), a.end(), b.begin(),
                                                                      std::ptrdiff_t{0}, std::plus<>(),
                                                                      std::equal_to<>());
}

TEST(Shot, everyCellItsOwnZoneShowsTheSameIds) {
    const ProgramRunner runner;
    for (const char* place : {"cottage.room", "cottage.front", "cottage.stairs"}) {
        const std::vector<std::uint32_t> merged = idsOf(runner, place, "merged"),
                                         cells = idsOf(runner, place, "cells");
        ASSERT_EQ(merged.size(), 160u * 90u);
        ASSERT_EQ(cells.size(), merged.size());
        EXPECT_EQ(differing(merged, cells), 0)
            << place << "; of the merged zones' ids, drawn again, "
            << differing(merged, idsOf(runner, place, "merged")) << " differ";
    }
}

TEST(Shot, theReferenceShowsWhatIsDrawn) {
    // limen check compares strictly, neighbours included. This test only shows that both produce the same
    // picture.
    const ProgramRunner runner;
    for (const char* place : {"cottage.room", "cottage.front"}) {
        SCOPED_TRACE(place);
        const std::vector<std::string> view{"shot", "--at", place, "--size", "160x90", "--ids"};
        std::vector<std::string> drawn = view, traced = view;
        for (const char* more : {"a.npy", "--depth", "ad.npy", "--json", "a.json"})
            drawn.emplace_back(more);
        for (const char* more : {"b.npy", "--depth", "bd.npy", "--json", "b.json", "--reference"})
            traced.emplace_back(more);
        expectDone(runner.run(drawn));
        expectDone(runner.run(traced));
        EXPECT_EQ(readNpy(runner.work() / "a.npy").header, readNpy(runner.work() / "b.npy").header);
        EXPECT_EQ(readNpy(runner.work() / "ad.npy").header, readNpy(runner.work() / "bd.npy").header);
        const auto ids = readNpy(runner.work() / "a.npy").values<std::uint32_t>(),
                   others = readNpy(runner.work() / "b.npy").values<std::uint32_t>();
        const auto depth = readNpy(runner.work() / "ad.npy").values<float>(),
                   depths = readNpy(runner.work() / "bd.npy").values<float>();
        ASSERT_EQ(ids.size(), others.size());
        std::size_t differing = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            differing += ids[i] != others[i] ? 1 : 0;
            if (ids[i] == others[i] && ids[i] > 1)
                EXPECT_NEAR(depth[i], depths[i], 1e-3f * depths[i]) << i;
        }
        EXPECT_LE(differing, ids.size() / 500) << "more pixels than edges can account for by rounding";
        const auto a = nlohmann::json::parse(getText(runner.work() / "a.json")),
                   b = nlohmann::json::parse(getText(runner.work() / "b.json"));
        for (const auto& [key, value] : a.items())
            EXPECT_TRUE(b.contains(key)) << key;
        EXPECT_EQ(a["root"], b["root"]);
    }
}

TEST(Tour, writesNumberedFramesAndAContactSheet) {
    const ProgramRunner runner;
    const ProgramRun run = runner.run({"tour", "-o", "t", "--frames", "4", "--size", "64x36", "--json"});
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, HasSubstr("contact.png"));
    for (const char* file : {"frame-00000.png", "frame-00003.png", "contact.png"})
        EXPECT_TRUE(std::filesystem::exists(runner.work() / (std::string("t/") + file))) << file;
    std::istringstream lines(run.out);
    int frames = 0;
    for (std::string line; std::getline(lines, line); ++frames)
        EXPECT_EQ(nlohmann::json::parse(line)["frame"], frames);
    EXPECT_EQ(frames, 4);
}

TEST(Tour, walksAPathFromAFile) {
    const ProgramRunner runner;
    putText(runner.work() / "path", "--at cottage.front\n--at cottage.room\n");
    const ProgramRun run =
        runner.run({"tour", "-o", "t", "--path", "path", "--frames", "5", "--size", "64x36", "--json"});
    ASSERT_EQ(run.exit, 0) << run.err;
    std::istringstream lines(run.out);
    std::string first, last;
    std::getline(lines, first);
    for (std::string line; std::getline(lines, line);)
        last = line;
    EXPECT_EQ(nlohmann::json::parse(first)["root"], "outside");
    EXPECT_THAT(nlohmann::json::parse(last)["root"].get<std::string>(), testing::StartsWith("0x"));
}

} // namespace
} // namespace limen::cli
