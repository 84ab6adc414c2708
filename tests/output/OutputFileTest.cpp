#include "output/OutputFile.h"

#include "support/TemporaryDirectory.h"

#include <unistd.h>

namespace limen::output {
namespace {

using test::getText;
using test::putText;
using test::TemporaryDirectory;

TEST(OutputFile, writesTheWholeFileAndNothingElse) {
    const TemporaryDirectory directory;
    ASSERT_TRUE(writeFile(directory / "a.txt", std::string_view("hello")));
    EXPECT_EQ(getText(directory / "a.txt"), "hello");
    ASSERT_TRUE(writeFile(directory / "a.txt", std::string_view("again")));
    EXPECT_EQ(getText(directory / "a.txt"), "again");
    EXPECT_EQ(directory.entryCount(), 1u);
}

TEST(OutputFile, checkingLeavesNoTrace) {
    const TemporaryDirectory directory;
    putText(directory / "kept", "old");
    EXPECT_TRUE(checkWritable(directory / "new"));
    EXPECT_TRUE(checkWritable(directory / "kept"));
    EXPECT_EQ(getText(directory / "kept"), "old");
    EXPECT_EQ(directory.entryCount(), 1u);
}

TEST(OutputFile, refusesWhatCannotBeAFile) {
    const TemporaryDirectory directory;
    putText(directory / "file", "x");
    EXPECT_FALSE(checkWritable(""));
    EXPECT_FALSE(checkWritable(directory.path()));
    EXPECT_FALSE(checkWritable(directory / "missing/out.png"));
    EXPECT_FALSE(checkWritable(directory / "file/out.png"));
    EXPECT_FALSE(checkWritable("/proc/limen.png"));
    EXPECT_FALSE(writeFile(directory / "missing/out.png", std::string_view("x")));
    EXPECT_EQ(directory.entryCount(), 1u);
}

TEST(OutputFile, writesIntoDevicesWithoutReplacingThem) {
    EXPECT_TRUE(checkWritable("/dev/null"));
    EXPECT_TRUE(writeFile("/dev/null", std::string_view("gone")));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_FALSE(writeFile("/dev/full", std::string_view("too much")));
}

TEST(OutputFile, writesThroughALink) {
    const TemporaryDirectory directory;
    putText(directory / "real", "old");
    std::filesystem::create_symlink(directory / "real", directory / "link");
    ASSERT_TRUE(writeFile(directory / "link", std::string_view("new")));
    EXPECT_TRUE(std::filesystem::is_symlink(directory / "link"));
    EXPECT_EQ(getText(directory / "real"), "new");
}

TEST(OutputFile, readsTextUpToALimit) {
    const TemporaryDirectory directory;
    putText(directory / "a", "12345");
    EXPECT_EQ(readTextFile(directory / "a", 5).value(), "12345");
    EXPECT_FALSE(readTextFile(directory / "a", 4));
    EXPECT_FALSE(readTextFile(directory / "none", 5));
    EXPECT_FALSE(readTextFile(directory.path(), 5));
}

TEST(OutputFile, makesDirectoriesButNotOverFiles) {
    const TemporaryDirectory directory;
    EXPECT_TRUE(makeDirectory(directory / "a/b/c"));
    EXPECT_TRUE(makeDirectory(directory / "a/b/c"));
    putText(directory / "file", "x");
    EXPECT_FALSE(makeDirectory(directory / "file"));
    EXPECT_FALSE(makeDirectory(directory / "file/deeper"));
}

} // namespace
} // namespace limen::output
