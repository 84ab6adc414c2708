#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

// Two rules for files, because the program runs on Windows, too.
//
// A path reaches the system as a path (decisions 183 and 187). A function of C that takes a name as narrow letters decodes it
// by the code page on Windows, and the cross-build does not notice a path that was made text before.
//
// std::filesystem reports failures by an error code. The functions without one throw, and they throw for other paths on each
// system: std::filesystem::absolute("") throws on Windows alone.
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

/// The calls of functions of std::filesystem in a text that have no std::error_code. `status` of a file does not throw.
std::vector<std::string> throwingCalls(const std::string& text) {
    static const std::set<std::string> kThrowing{"absolute",
                                                 "canonical",
                                                 "copy",
                                                 "copy_file",
                                                 "create_directories",
                                                 "create_directory",
                                                 "current_path",
                                                 "equivalent",
                                                 "exists",
                                                 "file_size",
                                                 "is_directory",
                                                 "is_empty",
                                                 "is_regular_file",
                                                 "last_write_time",
                                                 "read_symlink",
                                                 "relative",
                                                 "remove",
                                                 "remove_all",
                                                 "rename",
                                                 "space",
                                                 "status",
                                                 "temp_directory_path",
                                                 "weakly_canonical"};
    static const std::set<std::string> kNames{"error", "ignored", "status", "failed"};
    std::vector<std::string> found;
    for (const std::string space : {"fs::", "filesystem::"})
        for (std::size_t at = text.find(space); at != std::string::npos; at = text.find(space, at + 1)) {
            std::size_t end = at + space.size();
            while (end < text.size() && isOfWord(text[end]))
                ++end;
            if (end == text.size() || text[end] != '(' ||
                !kThrowing.contains(text.substr(at + space.size(), end - at - space.size())))
                continue;
            std::string last; // the last word of the arguments
            int depth = 0;
            do {
                depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
                if (isOfWord(text[end]))
                    last += text[end];
                else if (text[end] != ')')
                    last.clear();
            } while (++end < text.size() && depth > 0);
            if (!kNames.contains(last))
                found.push_back(text.substr(at, end - at));
        }
    return found;
}

TEST(ThrowingCalls, areFound) {
    EXPECT_EQ(throwingCalls("fs::absolute(path)"), std::vector<std::string>{"fs::absolute(path)"});
    EXPECT_EQ(throwingCalls("std::filesystem::exists(a(error, b))").size(), 1u);
    EXPECT_EQ(throwingCalls("fs::rename(from, to); fs::remove(\n    file)").size(), 2u);
    EXPECT_TRUE(throwingCalls("fs::rename(f(from), to, error); fs::exists(status); fs::path(text)").empty());
    EXPECT_TRUE(throwingCalls("is(std::filesystem::exists(a / b(), ignored)); offs_absolute(path)").empty());
}

/// All sources that are also compiled for Windows, by their path below the root.
std::map<std::string, std::string> sharedSources() {
    std::map<std::string, std::string> found;
    for (const char* folder : {"src", "worlds", "library"})
        for (const auto& entry : fs::recursive_directory_iterator(kSourceFolder / folder)) {
            const fs::path& path = entry.path();
            if ((path.extension() != ".cpp" && path.extension() != ".h") ||
                path.parent_path().filename() == "posix")
                continue;
            std::ifstream in(path);
            found[fs::relative(path, kSourceFolder).string()] = {std::istreambuf_iterator<char>(in),
                                                                 std::istreambuf_iterator<char>()};
        }
    return found;
}

TEST(SharedSources, haveNoNarrowNamesAndNoThrowingCalls) {
    const std::map<std::string, std::string> sources = sharedSources();
    EXPECT_GT(sources.size(), 500u);
    for (const auto& [file, text] : sources) {
        for (const std::string& found : narrowNames(text))
            ADD_FAILURE() << file << ": " << found;
        for (const std::string& found : throwingCalls(text))
            ADD_FAILURE() << file << ": " << found;
    }
}

} // namespace
