#include "core/platform/Environment.h"
#include "core/platform/FileView.h"
#include "core/platform/Files.h"
#include "core/platform/Process.h"
#include "core/platform/posix/MemInfo.h"

#include <cerrno>
#include <fstream>
#include <gtest/gtest.h>
#include <span>
#include <string>
#include <vector>

namespace limen::platform {
namespace {

namespace fs = std::filesystem;

/// A directory whose name has a space and letters outside of ASCII. It is removed with its files.
class OddDirectory {
public:
    OddDirectory() : path_(makeTemporaryDirectory().value()) { fs::create_directory(path_ / kName); }
    ~OddDirectory() { fs::remove_all(path_); }
    OddDirectory(const OddDirectory&) = delete;
    OddDirectory& operator=(const OddDirectory&) = delete;
    [[nodiscard]] fs::path operator/(const char* name) const { return path_ / kName / name; }

private:
    static constexpr const char* kName = "t\xC3\xBCr \xD0\xBE\xD0\xBA\xD0\xBD\xD0\xBE";
    fs::path path_;
};

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

std::string textOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(PlatformFiles, writeCutAndContinue) {
    const OddDirectory directory;
    const fs::path path = directory / "lines";
    const int file = createFile(path);
    ASSERT_GE(file, 0);
    EXPECT_EQ(writeSome(file, bytesOf("one\ntwo\nthr")), 11);
    EXPECT_TRUE(cutFile(file, 8));
    EXPECT_EQ(writeSome(file, bytesOf("three\n")), 6);
    EXPECT_TRUE(closeFile(file));
    EXPECT_EQ(textOf(path), "one\ntwo\nthree\n") << "no line end is translated";
    EXPECT_TRUE(flushToDisk(path));
    EXPECT_FALSE(flushToDisk(directory / "missing"));
}

TEST(PlatformFiles, replaceAFileThatIsThere) {
    const OddDirectory directory;
    std::ofstream(directory / "old") << "old";
    std::ofstream(directory / "new") << "new";
    EXPECT_TRUE(replaceFile(directory / "new", directory / "old"));
    EXPECT_EQ(textOf(directory / "old"), "new");
    EXPECT_FALSE(replaceFile(directory / "new", directory / "old"));
    EXPECT_EQ(errno, ENOENT);
}

TEST(PlatformFiles, anExclusiveFileIsMadeOnce) {
    const OddDirectory directory;
    std::FILE* file = openFile(directory / "once", "wbx");
    ASSERT_NE(file, nullptr);
    std::fclose(file);
    EXPECT_EQ(openFile(directory / "once", "wbx"), nullptr);
    EXPECT_EQ(errno, EEXIST);
}

TEST(PlatformFiles, temporaryDirectoriesDiffer) {
    const fs::path one = makeTemporaryDirectory().value(), two = makeTemporaryDirectory().value();
    EXPECT_NE(one, two);
    EXPECT_TRUE(fs::is_directory(one) && fs::is_directory(two));
    EXPECT_EQ(writeProblem(one), "");
    EXPECT_TRUE(fs::is_empty(one)) << "no file is left";
    fs::remove(one);
    fs::remove(two);
    EXPECT_NE(writeProblem(one), "");
}

TEST(FileView, hasTheBytesOfTheFile) {
    const OddDirectory directory;
    const std::string text(100'000, 'x');
    std::ofstream(directory / "file", std::ios::binary) << text;
    const FileView view = mapFile(directory / "file").value();
    ASSERT_EQ(view.size, text.size());
    letPagesGo(view);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(view.data), view.size), text);
    unmapFile(view);
}

TEST(FileView, ofAnEmptyFileIsEmpty) {
    const OddDirectory directory;
    std::ofstream(directory / "file").flush();
    const FileView view = mapFile(directory / "file").value();
    EXPECT_EQ(view.size, 0u);
    letPagesGo(view);
    unmapFile(view);
}

TEST(FileView, refusesMissingFilesAndDirectories) {
    const OddDirectory directory;
    const Result<FileView> missing = mapFile(directory / "missing");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::NotFound);
    const Result<FileView> folder = mapFile(directory / ".");
    ASSERT_FALSE(folder);
    EXPECT_EQ(folder.error().code, ErrorCode::Unreadable);
}

TEST(Environment, findsThisProgramInItsDirectory) {
    const fs::path program = programPath();
    EXPECT_TRUE(isProgram(program));
    EXPECT_TRUE(fs::equivalent(programBytes(), program));
    EXPECT_FALSE(isProgram(program.parent_path())) << "a directory is no program";
}

TEST(Environment, unsetVariablesAreEmpty) {
    EXPECT_EQ(environmentVariable("LIMEN_NO_SUCH_VARIABLE"), "");
    EXPECT_NE(environmentVariable("PATH"), "");
}

TEST(Environment, searchPathsHaveAbsoluteDirectories) {
    EXPECT_EQ(directoriesOf("/usr/bin::relative:/bin"), (std::vector<fs::path>{"/usr/bin", "/bin"}));
    EXPECT_TRUE(directoriesOf("").empty());
}

TEST(MemInfo, hasTheBytesOfALine) {
    constexpr const char* kAvailable = "MemAvailable:";
    EXPECT_EQ(memoryIn("MemTotal:  100 kB\nMemAvailable:     2048 kB\n", kAvailable), 2048u * 1024u);
    for (const char* text : {"", "MemTotal: 5 kB", "MemAvailable:", "MemAvailable: x kB",
                             "MemAvailable: 99999999999999999999999 kB"})
        EXPECT_EQ(memoryIn(text, kAvailable), std::nullopt) << text;
}

TEST(SystemMemory, isKnown) {
    const Memory memory = systemMemory();
    ASSERT_TRUE(memory.total && memory.available);
    EXPECT_LE(*memory.available, *memory.total);
}

} // namespace
} // namespace limen::platform
