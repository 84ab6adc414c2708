#include "placements/WorldDb.h"
#include "SampleContent.h"
#include "support/TemporaryDirectory.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

// world.db: written and read, changed, refused and damaged.
namespace {

using namespace limen;
using namespace limen::test;
using placements::Content;
using placements::WorldDb;

const placements::Origin kOrigin{"the test", "2026-01-02T03:04:05Z"};

Content readAt(const std::filesystem::path& path) {
    const Result<WorldDb> file = WorldDb::open(path);
    if (!file) {
        ADD_FAILURE() << file.error().message();
        return {};
    }
    Result<Content> content = file->readAll();
    EXPECT_TRUE(content.has_value());
    return content.value_or(Content());
}

TEST(WorldDb, holdsAContent) {
    const TemporaryDirectory directory;
    const Content content = SampleContent(11).make(20, 60);
    const auto counts = placements::writeWorldDb(directory / "world.db", content, kOrigin);
    ASSERT_TRUE(counts.has_value()) << counts.error().message();
    EXPECT_EQ(counts->landblocksWritten, content.landblocks.size());
    EXPECT_EQ(counts->templatesWritten, content.templates.size());
    EXPECT_EQ(counts->placements, placements::countPlacements(content));
    EXPECT_TRUE(readAt(directory / "world.db") == content);
    EXPECT_EQ(directory.entryCount(), 1u) << "nothing is left beside the file";
    const Result<WorldDb> file = WorldDb::open(directory / "world.db");
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->origin()->source, "the test");
    EXPECT_EQ(file->origin()->time, "2026-01-02T03:04:05Z");
    const auto& [id, landblock] = *content.landblocks.begin();
    EXPECT_TRUE(*file->landblock(id) == landblock);
    EXPECT_TRUE(file->landblock(0xFFFF)->placements.empty());
    const auto& [number, of] = *content.templates.begin();
    EXPECT_TRUE(*file->findTemplate(number) == of);
    EXPECT_EQ(*file->findTemplate(3), std::nullopt);
    EXPECT_EQ(*file->findPlacement(landblock.placements[0].guid), landblock.placements[0]);
    EXPECT_EQ(*file->findPlacement(1), std::nullopt);
}

TEST(WorldDb, aSecondWriteChangesOnlyTheDifferences) {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "world.db";
    Content content = SampleContent(12).make(20, 60);
    ASSERT_TRUE(placements::writeWorldDb(path, content, kOrigin).has_value());

    const auto before = std::filesystem::last_write_time(path);
    auto counts = placements::writeWorldDb(path, content, {"elsewhere", "later"});
    ASSERT_TRUE(counts.has_value());
    EXPECT_TRUE(counts->isUnchanged());
    EXPECT_EQ(std::filesystem::last_write_time(path), before);
    EXPECT_EQ(WorldDb::open(path)->origin()->source, "the test") << "the file was not touched";

    content.landblocks.begin()->second.placements[0].spot.origin[2] += 1.0f;
    content.landblocks.erase(std::prev(content.landblocks.end()));
    content.templates.begin()->second.name += "!";
    content.templates.erase(std::prev(content.templates.end()));
    placements::Template added;
    added.id = 9999;
    content.templates.emplace(9999, added);
    counts = placements::writeWorldDb(path, content, {"elsewhere", "later"});
    ASSERT_TRUE(counts.has_value()) << counts.error().message();
    EXPECT_EQ(counts->landblocksWritten, 1u);
    EXPECT_EQ(counts->landblocksRemoved, 1u);
    EXPECT_EQ(counts->templatesWritten, 2u);
    EXPECT_EQ(counts->templatesRemoved, 1u);
    EXPECT_TRUE(readAt(path) == content);
    EXPECT_EQ(WorldDb::open(path)->origin()->source, "elsewhere");
}

/// Each member of a content counts as a difference.
TEST(WorldDb, everyMemberOfATemplateIsCompared) {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "world.db";
    for (unsigned seed = 1; seed < 40; ++seed) {
        Content content = SampleContent(seed).make(2, 1);
        ASSERT_TRUE(placements::writeWorldDb(path, content, kOrigin).has_value());
        EXPECT_TRUE(readAt(path) == content) << seed;
    }
}

TEST(WorldDb, anotherFileIsNotReplaced) {
    const TemporaryDirectory directory;
    putText(directory / "a", "precious");
    auto counts = placements::writeWorldDb(directory / "a", SampleContent(1).make(1, 1), kOrigin);
    ASSERT_FALSE(counts.has_value());
    EXPECT_NE(counts.error().message().find("another file has this name"), std::string::npos);
    EXPECT_EQ(getText(directory / "a"), "precious");
    sqlite3* other = nullptr;
    sqlite3_open((directory / "b").c_str(), &other);
    sqlite3_exec(other, "CREATE TABLE x(y)", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    counts = placements::writeWorldDb(directory / "b", SampleContent(1).make(1, 1), kOrigin);
    ASSERT_FALSE(counts.has_value());
    EXPECT_EQ(directory.entryCount(), 2u);
}

TEST(WorldDb, aCancelledOrFailedWriteKeepsTheOldFile) {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "world.db";
    const Content old = SampleContent(1).make(3, 3);
    ASSERT_TRUE(placements::writeWorldDb(path, old, kOrigin).has_value());
    int calls = 0;
    const auto cancelled =
        placements::writeWorldDb(path, SampleContent(2).make(9, 9), kOrigin, [&] { return ++calls < 4; });
    ASSERT_FALSE(cancelled.has_value());
    EXPECT_TRUE(readAt(path) == old);
    EXPECT_EQ(directory.entryCount(), 1u);
    const auto nowhere = placements::writeWorldDb(directory / "absent/world.db", old, kOrigin);
    ASSERT_FALSE(nowhere.has_value());
}

TEST(WorldDb, aFileOfAnotherVersionIsRefusedAndWrittenAgain) {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "world.db";
    const Content content = SampleContent(5).make(3, 3);
    ASSERT_TRUE(placements::writeWorldDb(path, content, kOrigin).has_value());
    sqlite3* file = nullptr;
    sqlite3_open(path.c_str(), &file);
    sqlite3_exec(file, "PRAGMA user_version=99", nullptr, nullptr, nullptr);
    sqlite3_close(file);
    const Result<WorldDb> opened = WorldDb::open(path);
    ASSERT_FALSE(opened.has_value());
    EXPECT_NE(opened.error().message().find("has version 99"), std::string::npos);
    ASSERT_TRUE(placements::writeWorldDb(path, content, kOrigin).has_value());
    EXPECT_TRUE(readAt(path) == content);
}

TEST(WorldDb, aDamagedFileIsAnErrorOrAContentButNoCrash) {
    const TemporaryDirectory directory;
    const std::filesystem::path path = directory / "world.db";
    ASSERT_TRUE(placements::writeWorldDb(path, SampleContent(5).make(30, 30), kOrigin).has_value());
    const std::string good = getText(path);
    std::mt19937 random(1);
    int errors = 0;
    for (int i = 0; i < 200; ++i) {
        std::string bad = good;
        for (int k = 0; k < 30; ++k)
            bad[random() % bad.size()] = static_cast<char>(random());
        if (i % 4 == 0)
            bad.resize(random() % bad.size());
        putText(path, bad);
        const Result<WorldDb> file = WorldDb::open(path);
        const bool isRead =
            file && file->readAll() && file->search("a", std::nullopt, 10) && file->landblock(0x0100);
        errors += isRead ? 0 : 1;
    }
    EXPECT_GT(errors, 50);
    putText(path, "");
    EXPECT_FALSE(WorldDb::open(path).has_value());
    EXPECT_FALSE(WorldDb::open(directory / "absent").has_value());
}

TEST(WorldDb, searchesByNameAndType) {
    const TemporaryDirectory directory;
    Content content;
    for (const auto& [id, type, name] :
         {std::tuple{1u, 19, "Door"}, {2u, 10, "Old doorkeeper"}, {3u, 7, "Town 100%"}}) {
        placements::Template of;
        of.id = id;
        of.type = type;
        of.name = name;
        content.templates.emplace(id, of);
    }
    content.landblocks[0x0101].placements = {{10, 1, {0x01010100, {}, {}}, false},
                                             {11, 2, {0x01010001, {}, {}}, false}};
    content.landblocks[0x0202].placements = {{5, 1, {0x02020100, {}, {}}, false},
                                             {6, 3, {0x02020100, {}, {}}, false},
                                             {7, 99, {0x02020100, {}, {}}, false}};
    ASSERT_TRUE(placements::writeWorldDb(directory / "world.db", content, kOrigin).has_value());
    const Result<WorldDb> file = WorldDb::open(directory / "world.db");
    ASSERT_TRUE(file.has_value());
    const auto guids = [&](const char* name, std::optional<std::int32_t> type, std::size_t limit) {
        std::vector<std::uint32_t> found;
        const auto result = file->search(name, type, limit);
        EXPECT_TRUE(result.has_value());
        for (const placements::Found& one : *result)
            found.push_back(one.placement.guid);
        return found;
    };
    EXPECT_EQ(guids("DOOR", std::nullopt, 10), (std::vector<std::uint32_t>{5, 10, 11}));
    EXPECT_EQ(guids("door", 10, 10), (std::vector<std::uint32_t>{11}));
    EXPECT_EQ(guids("%", std::nullopt, 10), (std::vector<std::uint32_t>{6})) << "no pattern, but a text";
    EXPECT_EQ(guids("", 19, 10), (std::vector<std::uint32_t>{5, 10}));
    EXPECT_EQ(guids("", std::nullopt, 10).size(), 5u);
    EXPECT_EQ(guids("", std::nullopt, 2).size(), 2u);
    EXPECT_EQ(guids("'; DROP TABLE placement; --", std::nullopt, 10).size(), 0u);
}

} // namespace
