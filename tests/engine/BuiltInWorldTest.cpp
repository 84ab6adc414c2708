#include "engine/BuiltInWorld.h"

#include "support/TemporaryDirectory.h"

#include <atomic>
#include <thread>

namespace limen::engine {
namespace {

using test::getText;
using test::putText;
using test::TemporaryDirectory;

/// Writes three small files and counts its calls.
struct CountingWriter {
    std::shared_ptr<std::atomic<int>> calls = std::make_shared<std::atomic<int>>(0);
    Result<void> operator()(const std::filesystem::path& directory) const {
        ++*calls;
        for (const char* name : {"client_portal.dat", "client_cell_1.dat", "world.json"})
            putText(directory / name, "content");
        return {};
    }
};

TEST(BuiltInWorld, isWrittenOnceAndFoundAgain) {
    const TemporaryDirectory cache;
    const CountingWriter writer;
    const auto first = openBuiltInWorld(cache / "limen", "key1", writer);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->directory(), cache / "limen/key1");
    EXPECT_FALSE(first->temporary());
    EXPECT_EQ(getText(first->directory() / "world.json"), "content");
    ASSERT_TRUE(openBuiltInWorld(cache / "limen", "key1", writer));
    EXPECT_EQ(*writer.calls, 1);
}

TEST(BuiltInWorld, isRebuiltWhenTheProgramChangesOrAFileIsGone) {
    const TemporaryDirectory cache;
    const CountingWriter writer;
    ASSERT_TRUE(openBuiltInWorld(cache.path(), "key1", writer));
    ASSERT_TRUE(openBuiltInWorld(cache.path(), "key2", writer));
    EXPECT_EQ(*writer.calls, 2);
    std::filesystem::remove(cache / "key2/client_cell_1.dat");
    ASSERT_TRUE(openBuiltInWorld(cache.path(), "key2", writer));
    EXPECT_EQ(*writer.calls, 3);
    EXPECT_TRUE(std::filesystem::exists(cache / "key2/client_cell_1.dat"));
    discardBuiltInWorld(*openBuiltInWorld(cache.path(), "key2", writer));
    ASSERT_TRUE(openBuiltInWorld(cache.path(), "key2", writer));
    EXPECT_EQ(*writer.calls, 4);
}

TEST(BuiltInWorld, aWriterThatFailsLeavesNothingBehind) {
    const TemporaryDirectory cache;
    const auto result =
        openBuiltInWorld(cache.path(), "key", [](const std::filesystem::path& directory) -> Result<void> {
            putText(directory / "client_portal.dat", "half");
            return fail(ErrorCode::Unreadable, "disk", "full");
        });
    ASSERT_FALSE(result);
    EXPECT_EQ(cache.entryCount(), 0u);
}

TEST(BuiltInWorld, oldWorldsAreRemoved) {
    const TemporaryDirectory cache;
    const CountingWriter writer;
    for (int i = 0; i < 12; ++i)
        ASSERT_TRUE(openBuiltInWorld(cache.path(), "key" + std::to_string(i), writer));
    EXPECT_LE(cache.entryCount(), 6u);
    EXPECT_TRUE(std::filesystem::exists(cache / "key11"));
}

TEST(BuiltInWorld, withoutACacheItIsBorrowedAndGivenBack) {
    const CountingWriter writer;
    std::filesystem::path directory;
    {
        const auto world = openBuiltInWorld("/proc/no/such/place", "key", writer);
        ASSERT_TRUE(world);
        EXPECT_TRUE(world->temporary());
        directory = world->directory();
        EXPECT_TRUE(std::filesystem::exists(directory / "world.json"));
    }
    EXPECT_FALSE(std::filesystem::exists(directory));
    EXPECT_TRUE(openBuiltInWorld("", "key", writer));
}

TEST(BuiltInWorld, programKeyIsTheSameTwice) {
    EXPECT_EQ(programKey().size(), 16u);
    EXPECT_EQ(programKey(), programKey());
}

} // namespace
} // namespace limen::engine
