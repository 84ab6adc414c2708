#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

// Each row of docs/retail.md and docs/uncertain.md names its tests in the last column, as `Suite.test`.
// ReferencesHoldTest.cpp checks that they exist.
namespace {

std::string contentOf(const std::string& file) {
    std::ifstream in(LIMEN_SOURCE_DIR "/" + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The last cell of each row of the tables whose last column is "test".
std::vector<std::string> testCells(const std::string& text) {
    std::vector<std::string> cells;
    bool isInTable = false;
    std::string line;
    for (std::size_t begin = 0; begin < text.size(); begin += line.size() + 1) {
        line = text.substr(begin, text.find('\n', begin) - begin);
        if (!line.starts_with('|')) {
            isInTable = false;
            continue;
        }
        const std::size_t last = line.rfind('|', line.rfind('|') - 1);
        const std::string cell = last == std::string::npos ? "" : line.substr(last + 1);
        if (isInTable && cell.find("---") == std::string::npos)
            cells.push_back(cell);
        isInTable |= cell == " test |";
    }
    return cells;
}

bool namesTestsOnly(const std::string& cell) {
    static const std::regex kTests(R"( `[A-Z]\w*\.[a-z]\w*`(, `[A-Z]\w*\.[a-z]\w*`)* \|)");
    return std::regex_match(cell, kTests);
}

TEST(NamedTests, areReadFromTheLastColumnOfTables) {
    EXPECT_EQ(testCells("| `a` | test |\n|---|---|\n| `b` | `C.d` |\n\n| a | b |\n|---|---|\n| c | `e` |\n"),
              std::vector<std::string>{" `C.d` |"});
    for (const char* good : {" `C.d` |", " `C.d`, `E.f_g` |"})
        EXPECT_TRUE(namesTestsOnly(good)) << good;
    for (const char* bad : {" – |", " `C` |", " `C.d`, `e` |", " C.d |", " `C.d` and more |"})
        EXPECT_FALSE(namesTestsOnly(bad)) << bad;
}

TEST(NamedTests, areInEachRowOfThePagesOnTheOriginal) {
    for (const char* page : {"docs/retail.md", "docs/uncertain.md"}) {
        const std::vector<std::string> cells = testCells(contentOf(page));
        EXPECT_GT(cells.size(), 5u) << page;
        for (const std::string& cell : cells)
            EXPECT_TRUE(namesTestsOnly(cell)) << page << ":" << cell;
    }
}

} // namespace
