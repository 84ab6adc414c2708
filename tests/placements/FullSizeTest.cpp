#include "SqlTestFiles.h"
#include "placements/Import.h"
#include "placements/Standing.h"
#include "placements/WorldDb.h"

#include <chrono>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

// A world of the size of the published one: 365,000 placed objects, 304,000 links, 44,000 templates.
namespace {

using namespace limen;
using namespace limen::test;
using placements::Content;

constexpr std::uint32_t kLandblocks = 4'520, kTemplates = 44'000, kObjects = 365'183, kLinks = 304'351;

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double processorSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peakMiB() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

placements::Template templateOf(std::uint32_t id) {
    placements::Template of;
    of.id = id;
    of.className = fmt::format("class-{}", id);
    of.type = id % 3 == 0 ? 19 : id % 3 == 1 ? 10 : 1;
    of.name = fmt::format("Object of kind {}", id);
    of.setup = 0x02000000 + id % 5000;
    of.motionTable = 0x09000001;
    of.physicsState = 1032;
    of.scale = 1.0 + id % 7 * 0.125;
    of.open = false;
    if (id % 3 == 1)
        of.items = {{2, id % 900, 7, 0.33f}, {2, id % 901, 8, 0.67f}, {2, id % 902, 18, 1.0f}};
    return of;
}

Content fullContent() {
    Content content;
    for (std::uint32_t id = 1; id <= kTemplates; ++id)
        content.templates.emplace_hint(content.templates.end(), id, templateOf(id));
    std::uint32_t made = 0, linked = 0;
    for (std::uint32_t i = 0; i < kLandblocks; ++i) {
        const std::uint32_t id = 0x0A0A + (i / 68) * 0x0100 + i % 68;
        placements::Landblock& landblock = content.landblocks[id];
        const std::uint32_t end = static_cast<std::uint32_t>(std::uint64_t{kObjects} * (i + 1) / kLandblocks);
        const std::uint32_t linkEnd =
            static_cast<std::uint32_t>(std::uint64_t{kLinks} * (i + 1) / kLandblocks);
        for (std::uint32_t n = 0; made < end; ++made, ++n) {
            const float at = static_cast<float>(made % 19200) * 0.01f;
            landblock.placements.push_back(
                {0x70000000 | id << 12 | n,
                 1 + made * 7919 % kTemplates,
                 {id << 16 | (0x0100 + n % 64), {at, 192.0f - at, 0.5f}, {0.5f, 0.0f, 0.0f, 0.866025f}},
                 n > 0});
        }
        for (std::uint32_t n = 1; linked < linkEnd; ++linked, ++n)
            landblock.links.push_back({landblock.placements[0].guid, landblock.placements[n].guid});
    }
    return content;
}

/// Rows of tables that Limen does not read, as published files have them: two thirds of their text.
std::string otherRows(std::uint32_t id) {
    std::string rows;
    for (int i = 0; i < 40; ++i)
        rows += fmt::format(
            "INSERT INTO `weenie_properties_emote_action` (`emote_Id`, `order`, `type`, `delay`, `message`)\n"
            "VALUES (@parent_id,  {}, 10 /* Tell */, 0, 'It''s a text; {} of them');\n\n",
            i, id);
    return rows;
}

TEST(FullSizeWorld, isImportedWithinTwoMinutes) {
    const TemporaryDirectory directory;
    const Content content = fullContent();
    ASSERT_EQ(placements::countPlacements(content), kObjects);
    for (const auto& [id, landblock] : content.landblocks)
        putSql(directory / "sql", placements::sqlOf(id, landblock));
    std::size_t bytes = 0;
    for (const auto& [id, of] : content.templates) {
        placements::SqlText file = placements::sqlOf(of);
        file.text += otherRows(id);
        bytes += file.text.size();
        putSql(directory / "sql", file);
    }
    Result<Content> read;
    const double before = processorSeconds();
    const double reading = secondsOf([&] { read = placements::importSqlFiles({directory / "sql"}); });
    ASSERT_TRUE(read.has_value()) << read.error().message();
    EXPECT_TRUE(*read == content);
    const std::filesystem::path path = directory / "world.db";
    const auto write = [&] {
        EXPECT_TRUE(placements::writeWorldDb(path, *read, {"test", "now"}).has_value());
    };
    const double writing = secondsOf(write);
    read->landblocks.begin()->second.placements[0].spot.origin[2] += 1.0f;
    const double update = secondsOf(write);
    const double used = processorSeconds() - before;
    fmt::print("{} MiB of templates; read {:.1f} s, written {:.1f} s, updated {:.1f} s, {:.1f} s of "
               "processor time, file {:.1f} MiB, peak "
               "{:.0f} MiB\n",
               bytes >> 20, reading, writing, update, used,
               static_cast<double>(std::filesystem::file_size(path)) / 1048576.0, peakMiB());
    const Result<placements::WorldDb> file = placements::WorldDb::open(path);
    ASSERT_TRUE(file.has_value());
    std::size_t standing = 0;
    const double beforeBlocks = processorSeconds();
    for (const auto& [id, landblock] : content.landblocks) {
        const Result<placements::Landblock> block = file->landblock(id);
        ASSERT_TRUE(block.has_value());
        standing += standingIn(*block, [&](std::uint32_t of) { return &content.templates.at(of); }).size();
    }
    const double aBlock = (processorSeconds() - beforeBlocks) / kLandblocks;
    fmt::print("{} objects stand; {:.3f} ms of processor time to read one landblock\n", standing,
               aBlock * 1e3);
    EXPECT_EQ(standing, kLandblocks + kLinks) << "one parent for each landblock, and its children";
    EXPECT_LT(aBlock, 0.005) << "a flight at 50 m/s crosses a row of 9 landblocks in 3.8 s";
    // Processor time, because other programs run beside the test. The import has one thread.
    const auto searchSeconds = [&](const std::string& name, std::optional<std::int32_t> type) {
        const double beforeSearch = processorSeconds();
        const auto found = file->search(name, type, 100'000);
        EXPECT_TRUE(found && !found->empty()) << name;
        return processorSeconds() - beforeSearch;
    };
    const double rare = searchSeconds("KIND 4321", {});
    std::size_t doors = 0;
    const double beforeDoors = processorSeconds();
    EXPECT_TRUE(file->eachOfType(19, [&](const placements::Spot&) { return ++doors > 0; }));
    const double all = processorSeconds() - beforeDoors;
    fmt::print("search of one name {:.0f} ms, places of all {} doors {:.0f} ms\n", rare * 1e3, doors,
               all * 1e3);
    EXPECT_GT(doors, kObjects / 4);
    EXPECT_LT(rare, 0.25) << "a search for each letter that is typed";
    EXPECT_LT(all, 0.5) << "once for each world whose map is opened, on a thread of its own";
    EXPECT_LT(used, 120.0);
}

} // namespace
