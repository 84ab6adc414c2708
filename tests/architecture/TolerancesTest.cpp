#include <cctype>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <vector>

// shaders/include/Tolerances.h is the one place of the tolerances that several parts must agree on. C++ and GLSL read the
// same file; these tests find tolerances that stand somewhere else as well.
namespace {

namespace fs = std::filesystem;

const fs::path kSourceRoot = LIMEN_SOURCE_DIR;
const fs::path kHeader = kSourceRoot / "shaders" / "include" / "Tolerances.h";

/// A file without its line comments: they may name anything.
std::string textOf(const fs::path& file) {
    std::ifstream in(file);
    std::string text, line;
    while (std::getline(in, line))
        text += line.substr(0, line.find("//")) + "\n";
    return text;
}

bool isOfName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool names(const std::string& text, const std::string& name) {
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !isOfName(text[at - 1])) && (end == text.size() || !isOfName(text[end])))
            return true;
    }
    return false;
}

/// All C++ and GLSL files of the program but the header itself, by their path below the root.
std::map<std::string, std::string> readSources() {
    static const std::set<std::string> kExtensions{".h", ".cpp", ".glsl", ".vert", ".frag", ".comp"};
    std::map<std::string, std::string> found;
    for (const char* folder : {"src", "worlds", "shaders"})
        for (const auto& entry : fs::recursive_directory_iterator(kSourceRoot / folder))
            if (entry.is_regular_file() && kExtensions.contains(entry.path().extension()) &&
                entry.path() != kHeader)
                found[fs::relative(entry.path(), kSourceRoot).string()] = textOf(entry.path());
    return found;
}

const std::map<std::string, std::string>& sources() {
    static const std::map<std::string, std::string> kSources = readSources();
    return kSources;
}

/// Names and values, as they are written.
std::map<std::string, std::string> tolerances() {
    static const std::regex kDefinition(R"(LIMEN_TOLERANCE (k\w+) = ([^;]+);)");
    const std::string text = textOf(kHeader);
    std::map<std::string, std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), kDefinition), end; it != end; ++it)
        found[(*it)[1]] = (*it)[2];
    return found;
}

struct Definition {
    std::string file, name, value;
};
std::vector<Definition> constants() {
    static const std::regex kConstant(R"((?:const|constexpr) (?:double|float) (k\w+)\s*=\s*([^;,]+)[;,])");
    std::vector<Definition> found;
    for (const auto& [file, text] : sources()) {
        // Each search begins at the word: std::regex is slow on long texts.
        for (std::size_t at = text.find("const"); at != std::string::npos; at = text.find("const", at + 1)) {
            const std::string here = text.substr(at, text.find_first_of(";,", at) - at + 1);
            std::smatch match;
            if (std::regex_search(here, match, kConstant, std::regex_constants::match_continuous))
                found.push_back({file, match[1], match[2]});
        }
    }
    return found;
}

/// The value of a constant's text, if that is a literal or one literal divided by another.
std::optional<double> valueOf(const std::string& text) {
    static const std::regex kQuotient(R"(\s*(-?\d[-+.\deE]*)f?\s*(?:/\s*(\d[-+.\deE]*)f?\s*)?)");
    std::smatch match;
    if (!std::regex_match(text, match, kQuotient))
        return std::nullopt;
    return std::stod(match[1]) / (match[2].matched ? std::stod(match[2]) : 1.0);
}

TEST(Tolerances, theHeaderIsRead) {
    EXPECT_GE(tolerances().size(), 10u);
    EXPECT_EQ(valueOf(tolerances().at("kInPlaneTolerance")), 0.0002);
    EXPECT_EQ(valueOf(tolerances().at("kSnapTolerance")), 1.0 / 128.0);
}

TEST(Tolerances, eachIsSharedByTwoFilesAtLeast) {
    const auto& files = sources();
    for (const auto& [name, value] : tolerances()) {
        int users = 0;
        for (const auto& [file, text] : files)
            users += names(text, name) ? 1 : 0;
        EXPECT_GE(users, 2) << name << ": a tolerance of one file belongs into that file";
    }
}

TEST(Tolerances, noFileDefinesOneAgain) {
    const auto shared = tolerances();
    const std::vector<Definition> all = constants();
    EXPECT_GT(all.size(), 100u) << "too few constants found for the test to mean anything";
    for (const Definition& constant : all)
        EXPECT_FALSE(shared.contains(constant.name)) << constant.file << " defines " << constant.name;
}

/// Values that are rare enough to identify a tolerance.
TEST(Tolerances, noFileSpellsOutACharacteristicValue) {
    const std::set<std::string> unrelated{
        "src/motion/Particles.cpp kNoDirection",               // length of a vector
        "shaders/include/onpolygon.glsl kFlat",                // share of a depth
        "src/doctor/retail/Hooks.h kImmediatePause",           // seconds
        "src/world/records/EmitterStarts.cpp kLeastPause",     // seconds
        "src/world/records/Records.cpp kLeastTranslucency",    // a share of full opacity
        "worlds/builtin/buildings/MeetingHall.cpp kApseLower", // metres that a wall is lower
    };
    const auto shared = tolerances();
    std::set<double> values;
    for (const char* name : {"kInPlaneTolerance", "kEyeInPlaneTolerance", "kSnapTolerance"})
        values.insert(valueOf(shared.at(name)).value());
    for (const Definition& constant : constants()) {
        const bool isUnrelated = unrelated.contains(constant.file + " " + constant.name);
        const std::optional<double> value = valueOf(constant.value);
        EXPECT_TRUE(isUnrelated || !value || !values.contains(*value))
            << constant.file << ": " << constant.name << " = " << constant.value
            << " stands in shaders/include/Tolerances.h";
    }
}

} // namespace
