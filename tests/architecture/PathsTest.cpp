#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

// A path reaches the system as a path (decisions 183 and 187). A function of C that takes a name as narrow letters decodes it
// by the code page on Windows, and the cross-build does not notice a path that was made text before.
namespace {

namespace fs = std::filesystem;

const fs::path kSourceFolder = LIMEN_SOURCE_DIR;

bool isOfWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The places where a source hands a path to a C function, or names a file or a variable by narrow letters.
std::vector<std::string> narrowNames(const std::string& text) {
    constexpr std::array kNarrow{"string().c_str()", "string().data()", "fopen(", "freopen(",
                                 "getenv(",          "std::rename(",    "tmpnam("};
    std::vector<std::string> found;
    for (const char* const name : kNarrow)
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
            if (name[0] == 's' || at == 0 || !isOfWord(text[at - 1]))
                found.emplace_back(name);
    return found;
}

TEST(NarrowNames, areFound) {
    EXPECT_EQ(narrowNames("open(path.string().c_str())").size(), 1u);
    EXPECT_EQ(narrowNames("open(file->generic_string().data())").size(), 1u);
    EXPECT_EQ(narrowNames("std::fopen(name, mode); getenv(name)").size(), 2u);
    EXPECT_EQ(narrowNames("std::rename(a, b); fs::rename(a, b)").size(), 1u);
    EXPECT_TRUE(narrowNames("_wfopen(path.c_str()); _wgetenv(name)").empty());
}

TEST(NarrowNames, areInPosixSourcesAlone) {
    std::size_t read = 0;
    for (const char* folder : {"src", "worlds", "library"})
        for (const auto& entry : fs::recursive_directory_iterator(kSourceFolder / folder)) {
            const fs::path& path = entry.path();
            if ((path.extension() != ".cpp" && path.extension() != ".h") ||
                path.parent_path().filename() == "posix")
                continue;
            std::ifstream in(path);
            const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
            for (const std::string& found : narrowNames(text))
                ADD_FAILURE() << fs::relative(path, kSourceFolder).string() << ": " << found;
            ++read;
        }
    EXPECT_GT(read, 500u);
}

} // namespace
