#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

// docs/evidence.md names the test of every part of the file of expected values. ReferencesHoldTest.cpp finds names of tests
// and files that do not exist.
namespace {

/// The table of the page: the reader of each part.
std::map<std::string, std::string> rows() {
    std::map<std::string, std::string> found;
    std::ifstream in(std::string(LIMEN_SOURCE_DIR) + "/docs/evidence.md");
    for (std::string line; std::getline(in, line);) {
        const std::size_t middle = line.find(" | "), end = line.rfind(" |");
        if (!line.starts_with("| ") || middle == std::string::npos || middle >= end ||
            line.starts_with("| part |"))
            continue;
        const std::string part = line.substr(2, middle - 2);
        EXPECT_FALSE(found.contains(part)) << part << " has two rows";
        found[part] = line.substr(middle + 3, end - middle - 3);
    }
    return found;
}

/// The parts of a file of expected values: the members of its sets, or a set that has none.
std::set<std::string> partsOf(const nlohmann::json& file) {
    std::set<std::string> parts;
    for (const auto& [set, content] : file.at("sets").items()) {
        if (!content.is_object()) {
            parts.insert(set);
            continue;
        }
        for (const auto& [part, values] : content.items())
            if (part != "src")
                parts.insert(set + "." + part);
    }
    return parts;
}

TEST(Vectors, haveAReaderOrAReason) {
    EXPECT_GT(rows().size(), 100u);
    for (const auto& [part, reader] : rows())
        EXPECT_TRUE(reader.starts_with('`') || reader.starts_with("None: ")) << part << ": " << reader;
}

TEST(Vectors, haveARowForEveryPart) {
    const std::map<std::string, std::string> listed = rows();
    const nlohmann::json sample = nlohmann::json::parse(
        R"({"sets": {"water": {"src": "", "cases": []}, "motionKeyNote": "", "novel": {"a": 1}}})");
    EXPECT_EQ(partsOf(sample), (std::set<std::string>{"water.cases", "motionKeyNote", "novel.a"}));
    EXPECT_FALSE(listed.contains("novel.a"));
    const char* const path = std::getenv("LIMEN_VECTORS");
    if (path == nullptr)
        GTEST_SKIP() << "LIMEN_VECTORS names no file";
    std::ifstream in(path);
    ASSERT_TRUE(in) << path;
    const std::set<std::string> parts = partsOf(nlohmann::json::parse(in));
    for (const std::string& part : parts)
        EXPECT_TRUE(listed.contains(part)) << part << " has no row in docs/evidence.md";
    for (const auto& [part, reader] : listed)
        EXPECT_TRUE(parts.contains(part)) << part << " is no part of the file";
}

} // namespace
