#include "viewer/Screenshots.h"

#include "support/TemporaryDirectory.h"

#include <gtest/gtest.h>

namespace limen::viewer {
namespace {

std::string contents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Screenshots, areNumberedAndSayHowToDrawThemAgain) {
    const test::TemporaryDirectory directory;
    for (const std::string number : {"0001", "0002"}) {
        const Result<std::filesystem::path> kept =
            keepScreenshot(directory.path(), output::Picture(3, 2), "limen shot --eye 1,2,3");
        ASSERT_TRUE(kept) << kept.error().message();
        EXPECT_EQ(*kept, directory / ("limen-" + number + ".png"));
        EXPECT_EQ(contents(*kept).substr(1, 3), "PNG");
        EXPECT_EQ(contents(directory / ("limen-" + number + ".txt")),
                  "limen shot --eye 1,2,3 -o limen-" + number + "-again.png\n");
    }
    EXPECT_EQ(directory.entryCount(), 4u);
}

TEST(Screenshots, nothingIsWrittenOver) {
    const test::TemporaryDirectory directory;
    for (const char* name : {"limen-0007.txt", "limen-12000.png", "limen-old.png", "other-99999.png"})
        std::ofstream(directory / name) << "mine";
    const Result<std::filesystem::path> kept =
        keepScreenshot(directory.path(), output::Picture(1, 1), "limen shot");
    ASSERT_TRUE(kept);
    EXPECT_EQ(*kept, directory / "limen-12001.png") << "after the largest number of any kind of file";
    EXPECT_EQ(contents(directory / "limen-0007.txt"), "mine");
    EXPECT_EQ(contents(directory / "limen-12000.png"), "mine");
}

TEST(Screenshots, aDirectoryThatIsMissingIsSaidAndNothingIsLeft) {
    const test::TemporaryDirectory directory;
    const Result<std::filesystem::path> kept =
        keepScreenshot(directory / "none", output::Picture(1, 1), "limen shot");
    ASSERT_FALSE(kept);
    EXPECT_NE(kept.error().message().find("none"), std::string::npos);
    EXPECT_FALSE(keepScreenshot(directory.path(), output::Picture(), "limen shot")) << "an empty picture";
    EXPECT_EQ(directory.entryCount(), 0u);
}

} // namespace
} // namespace limen::viewer
