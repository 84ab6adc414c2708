#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

// The tables of docs/retail.md and docs/uncertain.md name a test for each row in their last column. Those tests exist.
namespace {

namespace fs = std::filesystem;
using Suites = std::map<std::string, std::set<std::string>>; // names of tests by suite

const fs::path kNamedTestsRoot = LIMEN_SOURCE_DIR;

std::string contentOf(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

void addTests(const std::string& text, Suites& suites) {
    static const std::regex kTest(
        R"((?:^|\n)(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\(\s*(\w+),\s*(\w+))");
    for (std::sregex_iterator found(text.begin(), text.end(), kTest), end; found != end; ++found)
        suites[(*found)[1]].insert((*found)[2]);
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

/// The names in back quotes that are no test: "Suite.test", "test" of the suite before it, or a suite.
std::vector<std::string> missing(const std::string& cell, const Suites& suites) {
    static const std::regex kName(R"(`(?:(\w+)\.)?(\w+)`)");
    std::vector<std::string> faults;
    std::string suite;
    for (std::sregex_iterator found(cell.begin(), cell.end(), kName), end; found != end; ++found) {
        const std::string named = (*found)[1], test = (*found)[2];
        suite = named.empty() ? suite : named;
        const auto tests = suites.find(suite);
        const bool isSuite = named.empty() && suites.contains(test);
        if (!isSuite && (tests == suites.end() || !tests->second.contains(test)))
            faults.push_back((*found)[0]);
    }
    return faults;
}

Suites allSuites() {
    Suites suites;
    for (const auto& entry : fs::recursive_directory_iterator(kNamedTestsRoot / "tests")) {
        if (entry.path().extension() != ".cpp")
            continue;
        addTests(contentOf(entry.path()), suites);
        suites[entry.path().stem().string()]; // a file of tests may be named as a whole
    }
    return suites;
}

TEST(NamedTests, areReadFromSources) {
    Suites suites;
    addTests("TEST(One, isFirst) {\n    TEST(\nTEST_F(Two,\n       isSecond_andLong) {\nRC_GTEST_PROP(Two, isThird, ()) {",
             suites);
    EXPECT_EQ(suites, (Suites{{"One", {"isFirst"}}, {"Two", {"isSecond_andLong", "isThird"}}}));
}

TEST(NamedTests, areReadFromTheLastColumnOfTables) {
    EXPECT_EQ(testCells("| `a` | test |\n|---|---|\n| `b` | `c.d` |\n\n| a | b |\n|---|---|\n| c | `e` |\n"),
              std::vector<std::string>{" `c.d` |"});
    const Suites suites{{"One", {"a", "b"}}, {"Two", {}}};
    EXPECT_TRUE(missing("`One.a`, `b`, `Two`", suites).empty());
    EXPECT_EQ(missing("`One.c`, `d`, `Three`, `Two.a`", suites),
              (std::vector<std::string>{"`One.c`", "`d`", "`Three`", "`Two.a`"}));
}

TEST(NamedTests, ofThePagesOnTheOriginalExist) {
    const Suites suites = allSuites();
    for (const char* page : {"docs/retail.md", "docs/uncertain.md"}) {
        const std::vector<std::string> cells = testCells(contentOf(kNamedTestsRoot / page));
        EXPECT_GT(cells.size(), 5u) << page;
        for (const std::string& cell : cells) {
            EXPECT_NE(cell.find('`'), std::string::npos) << page << ": a row without a test:" << cell;
            for (const std::string& name : missing(cell, suites))
                ADD_FAILURE() << page << " names " << name << ", which is no test";
        }
    }
}

} // namespace
