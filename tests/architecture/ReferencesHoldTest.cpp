#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Every file, heading and test that code or documents cite exists. The forms of a citation are:
//   docs/formats/cells.md#portals      in code: the page from the root; the heading as in a link on GitHub
//   [text](PAGE#tolerances)           in Markdown: PAGE relative to the page; #heading: the same page
//   `src/dat/File.h`, `src/dat/`       in Markdown: a file or folder; `src/dat/File` for header and source
//   world/World.h, `World.h`           in comments and Markdown: a source file whose path ends so
//   `Suite.test`, `Suite.test…`        in Markdown: a test, or the beginning of its name
// Placeholders are written in capitals: NAME.cpp, NAMETest.cpp, SUITE.test; and room/Header.h.
// Limits: fences are not checked; text outside of back quotes is checked for links only.
namespace limen::references {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 14> kRoots{"src/",     "worlds/",    "shaders/", "tests/",    "bench/",
                                                  "fuzz/",    "tools/",     "docs/",    "examples/", "cmake/",
                                                  ".github/", "packaging/", "library/", "python/"};
constexpr std::array<std::string_view, 7> kSourceEndings{".h",    ".c",    ".cpp", ".glsl",
                                                         ".vert", ".frag", ".comp"};

template <std::size_t N>
bool startsWithAny(std::string_view text, const std::array<std::string_view, N>& parts) {
    return std::any_of(parts.begin(), parts.end(), [&](std::string_view p) { return text.starts_with(p); });
}
template <std::size_t N>
bool endsWithAny(std::string_view text, const std::array<std::string_view, N>& parts) {
    return std::any_of(parts.begin(), parts.end(), [&](std::string_view p) { return text.ends_with(p); });
}

bool isWordByte(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

/// The lines of a Markdown page. Lines inside fences are empty, so that line numbers stay.
std::vector<std::string> proseLines(std::string_view text) {
    std::vector<std::string> lines = linesOf(text);
    bool inFence = false;
    for (std::string& line : lines) {
        const std::size_t indent = line.find_first_not_of(' ');
        const bool isFence = indent != std::string::npos && indent < 4 && line.compare(indent, 3, "```") == 0;
        if (isFence || inFence)
            line.clear();
        inFence = inFence != isFence;
    }
    return lines;
}

/// The anchor of a heading as GitHub makes it: the text of links, letters lowered, punctuation dropped,
/// spaces as hyphens.
std::string anchorOf(std::string_view heading) {
    std::string text;
    for (std::size_t i = 0; i < heading.size(); ++i)
        if (heading[i] == ']' && i + 1 < heading.size() && heading[i + 1] == '(')
            i = std::min(heading.find(')', i), heading.size() - 1);
        else
            text += heading[i];
    std::string anchor;
    for (const char c : text)
        if (isWordByte(c) || c == '-' || static_cast<unsigned char>(c) >= 0x80)
            anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ')
            anchor += '-';
    return anchor;
}

struct Heading {
    std::string text;
    std::string anchor;
};

std::vector<Heading> headingsOf(std::string_view markdown) {
    std::vector<Heading> headings;
    std::map<std::string, int> seen;
    for (const std::string& line : proseLines(markdown)) {
        const std::size_t level = line.find_first_not_of('#');
        if (level == 0 || level == std::string::npos || level > 6 || line[level] != ' ')
            continue;
        const std::string text = line.substr(line.find_first_not_of(' ', level));
        std::string anchor = anchorOf(text);
        if (const int before = seen[anchor]++; before > 0)
            anchor += "-" + std::to_string(before);
        headings.push_back({text, anchor});
    }
    return headings;
}

/// The names of a test program's tests: TEST(Suite, name), TEST_F, TEST_P, RC_GTEST_PROP and the like.
std::vector<std::string> testsIn(std::string_view source) {
    std::vector<std::string> tests;
    for (const std::string_view macro : {"TEST(", "TEST_F(", "TEST_P(", "TYPED_TEST(", "PROP(", "PROP_F("}) {
        for (std::size_t at = source.find(macro); at != std::string_view::npos;
             at = source.find(macro, at + 1)) {
            std::vector<std::string> words(1);
            for (std::size_t i = at + macro.size(); i < source.size() && words.size() < 3 && source[i] != ')';
                 ++i)
                if (source[i] == ',')
                    words.emplace_back();
                else if (isWordByte(source[i]))
                    words.back() += source[i];
            if (words.size() >= 2)
                tests.push_back(words[0] + "." + words[1]);
        }
    }
    return tests;
}

/// The files that may be cited.
class Repository {
public:
    void add(const std::string& path, std::string text) {
        for (fs::path folder = fs::path(path).parent_path(); !folder.empty(); folder = folder.parent_path())
            folders_.insert(folder.string());
        if (path.ends_with(".md"))
            headings_[path] = headingsOf(text);
        if (path.ends_with(".cpp"))
            for (std::string& test : testsIn(text))
                tests_.insert(std::move(test));
        files_[path] = std::move(text);
    }

    [[nodiscard]] const std::map<std::string, std::string>& files() const { return files_; }
    [[nodiscard]] bool hasFile(const std::string& path) const { return files_.contains(path); }
    [[nodiscard]] bool has(std::string path) const {
        while (path.ends_with('/'))
            path.pop_back();
        return hasFile(path) || folders_.contains(path);
    }
    /// Whether the path of some file starts so. `src/world/Zones.` cites the header and source of a concept.
    [[nodiscard]] bool hasStart(const std::string& start) const {
        const auto found = files_.lower_bound(start);
        return found != files_.end() && found->first.starts_with(start);
    }
    /// Users include a public header as limen/room/Header.h; limen/version.h is made from a template.
    [[nodiscard]] bool hasEnding(std::string_view ending) const {
        if (ending.starts_with("limen/"))
            return hasEnding(ending.substr(6)) || hasEnding(std::string(ending.substr(6)) + ".in");
        return std::any_of(files_.begin(), files_.end(), [&](const auto& file) {
            const std::string& path = file.first;
            return path.ends_with(ending) &&
                   (path.size() == ending.size() || path[path.size() - ending.size() - 1] == '/');
        });
    }
    [[nodiscard]] bool hasTest(const std::string& start, bool whole) const {
        const auto found = tests_.lower_bound(start);
        return found != tests_.end() && (whole ? *found == start : found->starts_with(start));
    }
    [[nodiscard]] const std::vector<Heading>& headings(const std::string& page) const {
        static const std::vector<Heading> kNone;
        const auto found = headings_.find(page);
        return found == headings_.end() ? kNone : found->second;
    }
    [[nodiscard]] bool hasAnchor(const std::string& page, std::string_view anchor) const {
        const std::vector<Heading>& all = headings(page);
        return std::any_of(all.begin(), all.end(), [&](const Heading& h) { return h.anchor == anchor; });
    }

private:
    std::map<std::string, std::string> files_; ///< path from the root, text
    std::set<std::string> folders_;
    std::map<std::string, std::vector<Heading>> headings_; ///< by page
    std::set<std::string> tests_;                          ///< Suite.name
};

/// Collects faults of one file, with their lines.
class Faults {
public:
    explicit Faults(std::string path) : path_(std::move(path)) {}
    void add(std::size_t line, const std::string& cited, const std::string& reason) {
        all_.push_back(path_ + ":" + std::to_string(line + 1) + ": " + cited + ": " + reason);
    }
    [[nodiscard]] std::vector<std::string> take() { return std::move(all_); }

private:
    std::string path_;
    std::vector<std::string> all_;
};

/// A word of a line that may be a path: letters, digits and _ . / - #, without full stops at its end.
struct Token {
    std::string text;
    std::size_t end = 0; ///< position after the word in the line
};

std::vector<Token> tokensOf(std::string_view line) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() &&
               (isWordByte(line[end]) || std::string_view("./-#").find(line[end]) != line.npos))
            ++end;
        std::size_t last = end;
        while (last > at && (line[last - 1] == '.' || line[last - 1] == '-'))
            --last;
        if (last > at)
            tokens.push_back({std::string(line.substr(at, last - at)), last});
        at = end + 1;
    }
    return tokens;
}

/// Whether the text after a page cites a heading in words: in quotes, by number, or as one of `headings`.
bool namesHeading(std::string_view rest, const std::vector<Heading>& headings) {
    const std::size_t first = std::min(rest.find_first_not_of(" ,("), rest.size());
    std::string_view start = rest.substr(first);
    if (start.starts_with("\xC2\xA7") || start.starts_with("section ")) // the paragraph sign
        return true;
    if (start.starts_with('"'))
        return rest.substr(0, first).find(',') != std::string_view::npos;
    return std::any_of(headings.begin(), headings.end(), [&](const Heading& h) {
        return start.starts_with(h.text) &&
               (start.size() == h.text.size() || !isWordByte(start[h.text.size()]));
    });
}

/// `rest`, with the line below appended if a citation continues there.
std::string withNext(std::string_view rest, std::string_view next) {
    if (rest != "," && rest != ", ")
        return std::string(rest);
    return std::string(rest) + ' ' +
           std::string(next.substr(std::min(next.find_first_not_of("/*# "), next.size())));
}

void checkPage(const Token& token, std::string_view rest, std::size_t number, const Repository& repository,
               Faults& faults) {
    const std::size_t hash = token.text.find('#');
    const std::string page = token.text.substr(0, hash);
    if (!repository.hasFile(page))
        faults.add(number, token.text, "no such page; pages are cited by their paths from the root");
    else if (hash == std::string::npos && namesHeading(rest, repository.headings(page)))
        faults.add(number, token.text, "headings are cited as page.md#heading");
    else if (hash != std::string::npos && !repository.hasAnchor(page, token.text.substr(hash + 1)))
        faults.add(number, token.text, "the page has no such heading");
}

bool isPage(const std::string& token) {
    return (token.ends_with(".md") && token.size() > 3) || token.find(".md#") != std::string::npos;
}
bool isSource(const std::string& token) {
    return endsWithAny(token, kSourceEndings) && isWordByte(token.front()) &&
           isWordByte(token[token.rfind('.') - 1]) && token.find('#') == std::string::npos;
}

bool isOfALibrary(const std::string& header) {
    return header.starts_with("GLFW/");
}

/// Whether a name is a placeholder: NAME.cpp, src/cli/NAMEVerb.cpp, room/Header.h, SUITE.test.
bool isPlaceholder(const std::string& name) {
    const std::string stem = fs::path(name).stem().string();
    const auto isIn = [&](int (*kind)(int)) {
        return std::any_of(stem.begin(), stem.end(), [&](unsigned char c) { return kind(c) != 0; });
    };
    return name.find("NAME") != std::string::npos || stem == "Header" ||
           (isIn(std::isupper) && !isIn(std::islower));
}

/// A source file's text in which everything except comments and line ends is replaced by spaces. Scripts and
/// CMake files have # comments, other files those of C++.
std::string onlyComments(std::string_view text, bool isScript) {
    std::string out(text.size(), ' ');
    enum class In { Code, Line, Block, String, Character, Raw } in = In::Code;
    std::string rawEnd;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view rest = text.substr(i);
        if (text[i] == '\n') {
            out[i] = '\n';
            if (in == In::Line || in == In::Character || (in == In::String && !isScript))
                in = In::Code;
        } else if (in == In::Line || in == In::Block) {
            out[i] = text[i];
            if (in == In::Block && rest.starts_with("*/")) {
                out[++i] = '/';
                in = In::Code;
            }
        } else if (in == In::String || in == In::Character) {
            if (text[i] == '\\')
                ++i;
            else if (text[i] == (in == In::String ? '"' : '\''))
                in = In::Code;
        } else if (in == In::Raw) {
            if (rest.starts_with(rawEnd))
                in = In::Code;
        } else if (isScript) {
            const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '\n';
            in = text[i] == '#' && begins ? In::Line : In::Code;
            out[i] = in == In::Line ? '#' : ' ';
        } else if (rest.starts_with("//") || rest.starts_with("/*")) {
            in = rest[1] == '/' ? In::Line : In::Block;
            out[i] = '/';
            ++i;
            out[i] = text[i];
        } else if (rest.starts_with("R\"")) {
            const std::size_t open = std::min(rest.find('('), rest.size());
            rawEnd = ")" + std::string(rest.substr(2, open < 2 ? 0 : open - 2)) + "\"";
            in = In::Raw;
        } else if (text[i] == '"') {
            in = In::String;
        } else if (text[i] == '\'' && (i == 0 || !isWordByte(text[i - 1]))) { // not in 1'000
            in = In::Character;
        }
    }
    return out;
}

/// The faults of a source file, a script or a CMake file.
std::vector<std::string> faultsOfCode(const std::string& path, std::string_view text,
                                      const Repository& repository) {
    const bool isScript = !endsWithAny(path, kSourceEndings) &&
                          path.find(".rc") == std::string::npos; // as C: resources of Windows
    const std::vector<std::string> lines = linesOf(text);
    const std::vector<std::string> comments = linesOf(onlyComments(text, isScript));
    const auto behind = [](const std::vector<std::string>& all, std::size_t i, const Token& token) {
        return withNext(std::string_view(all[i]).substr(token.end),
                        i + 1 < all.size() ? all[i + 1] : std::string());
    };
    Faults faults(path);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Token& token : tokensOf(comments[i]))
            if (isPage(token.text))
                checkPage(token, behind(comments, i, token), i, repository, faults);
            else if (isSource(token.text) && !isPlaceholder(token.text) && !isOfALibrary(token.text) &&
                     !repository.hasEnding(token.text))
                faults.add(i, token.text, "no source file has this name");
        for (const Token& token : tokensOf(lines[i])) // messages cite pages, too
            if (token.text.starts_with("docs/") && isPage(token.text) &&
                comments[i].find(token.text) == std::string::npos)
                checkPage(token, "", i, repository, faults);
    }
    return faults.take();
}

/// Splits a Markdown line into the contents of back quotes and the rest.
void splitQuotes(std::string_view line, std::vector<std::string>& quoted, std::string& rest) {
    bool inside = false;
    std::string part;
    for (const char c : line) {
        if (c != '`') {
            (inside ? part : rest) += c;
            continue;
        }
        if (inside)
            quoted.push_back(std::exchange(part, {}));
        inside = !inside;
        rest += '`';
    }
}

void checkQuoted(const std::string& quoted, std::size_t line, const Repository& repository, Faults& faults) {
    constexpr std::string_view kEllipsis = "\xE2\x80\xA6";
    std::string name = quoted.substr(0, quoted.find(' '));
    const bool isStart = name.ends_with(kEllipsis) || name.ends_with("*");
    if (name.ends_with(kEllipsis))
        name.resize(name.size() - kEllipsis.size());
    if (name.ends_with("*"))
        name.pop_back();
    const bool isPath = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return isWordByte(c) || std::string_view("./-").find(c) != std::string_view::npos;
    });
    if (!isPath || (isPlaceholder(name) && !name.ends_with(".md")))
        return;
    const std::size_t dot = name.find('.');
    const bool hasOneDot =
        dot != std::string::npos && dot == name.rfind('.') && name.find('/') == std::string::npos;
    if (startsWithAny(name, kRoots)) {
        if (isStart ? !repository.hasStart(name) : !repository.has(name) && !repository.hasStart(name + '.'))
            faults.add(line, quoted, "no such file or folder");
    } else if (isSource(name)) {
        if (!repository.hasEnding(name))
            faults.add(line, quoted, "no source file has this name");
    } else if (hasOneDot && std::isupper(static_cast<unsigned char>(name[0])) != 0 &&
               (dot + 1 == name.size() ? isStart
                                       : std::islower(static_cast<unsigned char>(name[dot + 1])) != 0) &&
               !name.ends_with(".md") && !name.ends_with(".txt") && !name.ends_with(".json")) {
        if (!repository.hasTest(name, !isStart))
            faults.add(line, quoted, "no such test");
    }
}

void checkLink(const std::string& target, std::size_t line, const std::string& page,
               const Repository& repository, Faults& faults) {
    if (target.find("://") != std::string::npos || target.starts_with("mailto:"))
        return;
    const std::size_t hash = target.find('#');
    const std::string file = target.substr(0, hash);
    const std::string path =
        file.empty() ? page : (fs::path(page).parent_path() / file).lexically_normal().generic_string();
    if (!repository.has(path))
        faults.add(line, target, "the link leads nowhere");
    else if (hash != std::string::npos && !repository.hasAnchor(path, target.substr(hash + 1)))
        faults.add(line, target, "the page has no such heading");
}

/// The faults of a Markdown page.
std::vector<std::string> faultsOfMarkdown(const std::string& path, std::string_view text,
                                          const Repository& repository) {
    Faults faults(path);
    const std::vector<std::string> lines = proseLines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<std::string> quoted;
        std::string rest;
        splitQuotes(lines[i], quoted, rest);
        for (const std::string& one : quoted)
            checkQuoted(one, i, repository, faults);
        // Links may break behind their text, but "](" stays together.
        for (std::size_t at = rest.find("]("); at != std::string::npos; at = rest.find("](", at + 2)) {
            const std::size_t end = rest.find_first_of(") ", at + 2);
            if (end != std::string::npos)
                checkLink(rest.substr(at + 2, end - at - 2), i, path, repository, faults);
        }
    }
    return faults.take();
}

std::vector<std::string> faultsOf(const std::string& path, std::string_view text,
                                  const Repository& repository) {
    return path.ends_with(".md") ? faultsOfMarkdown(path, text, repository)
                                 : faultsOfCode(path, text, repository);
}

std::string textOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The source tree. Binary files have empty texts; they are listed because links cite pictures.
Repository readRepository() {
    const fs::path root = LIMEN_SOURCE_DIR;
    Repository repository;
    const auto add = [&](const fs::path& file) {
        const std::string text = textOf(file);
        const bool isText = text.find('\0') == std::string::npos;
        repository.add(fs::relative(file, root).generic_string(), isText ? text : std::string());
    };
    for (const auto& entry : fs::directory_iterator(root))
        if (entry.is_regular_file())
            add(entry.path());
    for (const std::string_view folder : kRoots) {
        if (!fs::exists(root / folder))
            continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.is_regular_file() && entry.path().string().find("__pycache__") == std::string::npos)
                add(entry.path());
    }
    return repository;
}

TEST(ReferencesHold, everyCitedFileHeadingAndTestExists) {
    const Repository repository = readRepository();
    EXPECT_GT(repository.files().size(), 500u) << "too few files found for the test to mean anything";
    for (const auto& [path, text] : repository.files())
        for (const std::string& fault : faultsOf(path, text, repository))
            ADD_FAILURE() << fault;
}

/// A small tree to test the scanner. Its citations have @ for docs/, so that this file itself contains no
/// citation.
class ReferencesScanner : public testing::Test {
protected:
    ReferencesScanner() {
        add("@rule.md", "# The rule\n## Zones, and more\ntext\n## `limen check`\n## Zones, and more\n"
                        "```\n# no heading\n```\n## [A link](x.md) here\n");
        add("@formats/cells.md", "# Cells\n## Point in cell\n");
        add("src/world/Zones.h", "");
        add("tests/world/ZonesTest.cpp", "TEST(Zones, areMerged) {}\nTEST_F(Mesh,\n  isFlat) {}\n");
    }
    static std::string at(std::string text) {
        for (std::size_t i = text.find('@'); i != std::string::npos; i = text.find('@', i))
            text.replace(i, 1, "docs/");
        return text;
    }
    void add(const std::string& path, const std::string& text) { repository.add(at(path), at(text)); }
    [[nodiscard]] std::vector<std::string> code(const std::string& text) const {
        return faultsOf("src/x.cpp", at(text), repository);
    }
    [[nodiscard]] std::vector<std::string> script(const std::string& text) const {
        return faultsOf("tools/x", at(text), repository);
    }
    [[nodiscard]] std::vector<std::string> page(const std::string& text) const {
        Repository withPage = repository;
        withPage.add(at("@formats/x.md"), at(text));
        return faultsOf(at("@formats/x.md"), at(text), withPage);
    }
    Repository repository;
};

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(ReferencesScanner, knowsTheFoldersOfLibrariesAndPackages) {
    for (const char* folder : {"library", "packaging", "python"}) {
        EXPECT_THAT(page("`" + std::string(folder) + "/Missing.cmake`\n"),
                    ElementsAre(HasSubstr("Missing.cmake")));
        EXPECT_THAT(script("# " + std::string(folder) + "/Missing.cpp\n"),
                    ElementsAre(HasSubstr("Missing.cpp")));
    }
}

TEST_F(ReferencesScanner, makesAnchorsAsGitHubDoes) {
    EXPECT_EQ(anchorOf("Zones, and more"), "zones-and-more");
    EXPECT_EQ(anchorOf("`limen check` (fast)"), "limen-check-fast");
    EXPECT_EQ(anchorOf("Free-list_x"), "free-list_x");
    EXPECT_EQ(anchorOf("[A link](x.md) here"), "a-link-here");
    std::vector<std::string> anchors;
    for (const Heading& heading : repository.headings(at("@rule.md")))
        anchors.push_back(heading.anchor);
    EXPECT_THAT(anchors,
                ElementsAre("the-rule", "zones-and-more", "limen-check", "zones-and-more-1", "a-link-here"));
}

TEST_F(ReferencesScanner, acceptsCitationsThatHold) {
    EXPECT_THAT(code("// See @rule.md.\n/// (@rule.md#zones-and-more): open.\n/* "
                     "@formats/cells.md#point-in-cell\n */"),
                IsEmpty());
    EXPECT_THAT(code("int a; // world/Zones.h, Zones.h and src/world/Zones.h\n"), IsEmpty());
    EXPECT_THAT(code("// GLFW/glfw3.h, NAME.cpp, room/Header.h, *.h, a.hpp\n"), IsEmpty());
    EXPECT_THAT(script("# after @rule.md#the-rule\nx=\"# NoSuch.h\"\n"), IsEmpty());
    EXPECT_THAT(
        page("[a](cells.md), [b](cells.md#point-in-cell), [c](../rule.md#limen-check), [d](#here)\n# Here\n"
             "`src/world/`, `src/world/Zones.h`, `Zones.h`, `src/world/Zones`, `Zones.areMerged`, "
             "`Mesh.is\xE2\x80\xA6`, "
             "`Mesh.*`\n"
             "`src/cli/NAMEVerb.cpp`, `SUITE.itHolds`\n"
             "[e](https://example.org/x.md#y) `tests/world/*`\n```\n`src/absent.h`\n```\n"),
        IsEmpty());
}

TEST_F(ReferencesScanner, findsPagesThatDoNotExist) {
    EXPECT_THAT(code("// @absent.md\n"), ElementsAre(HasSubstr("src/x.cpp:1")));
    EXPECT_THAT(code("\nconst char* a = \"read @absent.md\";\n"), ElementsAre(HasSubstr("src/x.cpp:2")));
    EXPECT_THAT(code("// formats/cells.md, rule.md\n"), testing::SizeIs(2)); // not from the root
    EXPECT_THAT(script("a # @absent.md\n"), testing::SizeIs(1));
    EXPECT_THAT(page("`@README.md`\n"), testing::SizeIs(1)); // no placeholder
    EXPECT_THAT(page("[a](absent.md)\n[b](../cells.md)\n"), testing::SizeIs(2));
}

TEST_F(ReferencesScanner, findsHeadingsThatDoNotExist) {
    EXPECT_THAT(code("// @rule.md#absent\n"), ElementsAre(HasSubstr("no such heading")));
    EXPECT_THAT(code("// @rule.md#no-heading\n"), testing::SizeIs(1)); // it is in a fence
    EXPECT_THAT(page("[a](cells.md#absent)\n"), ElementsAre(HasSubstr("no such heading")));
}

TEST_F(ReferencesScanner, findsHeadingsCitedInOtherForms) {
    EXPECT_THAT(code("// @formats/cells.md, \"Point in cell\"\n"), ElementsAre(HasSubstr("page.md#heading")));
    EXPECT_THAT(code("// @formats/cells.md, Point in cell.\n"), testing::SizeIs(1));
    EXPECT_THAT(code("// @formats/cells.md \xC2\xA7"
                     "4\n"),
                testing::SizeIs(1));
    EXPECT_THAT(code("// @formats/cells.md section 4\n"), testing::SizeIs(1));
    EXPECT_THAT(code("// @formats/cells.md,\n// \"Point in cell\"\n"), testing::SizeIs(1));
    EXPECT_THAT(code("// @formats/cells.md, the \"Point in cell\"; @rule.md \"x\"\n"), IsEmpty());
}

TEST_F(ReferencesScanner, findsSourcesAndTestsThatDoNotExist) {
    EXPECT_THAT(code("// world/Absent.h\n#include \"world/Absent.h\"\nauto a = \"Absent.h\";\n"),
                testing::SizeIs(1));
    EXPECT_THAT(code("// ones.h\n"), testing::SizeIs(1)); // the end of a name is not enough
    EXPECT_THAT(page("`src/absent/`\n`src/world/Absent.h`\n`world/Absent.h`\n"), testing::SizeIs(3));
    EXPECT_THAT(page("`Zones.areMerge`\n`Absent.isThere`\n`Zones.x\xE2\x80\xA6`\n"), testing::SizeIs(3));
}

TEST_F(ReferencesScanner, tellsCommentsFromCode) {
    EXPECT_EQ(onlyComments("a \"// b\" // c", false), "         // c");
    EXPECT_EQ(onlyComments("R\"x(// a)x\" /*b\n*/ 1'0 // c", false).find("// a"), std::string::npos);
    EXPECT_EQ(onlyComments("'\"' // c", false), "    // c");
    EXPECT_EQ(onlyComments("1'000 // c", false), "      // c");
    EXPECT_EQ(onlyComments("${a#b} # c", true), "       # c");
    EXPECT_EQ(onlyComments("/*/ a */b//c", false), "/*/ a */ //c");
}

} // namespace
} // namespace limen::references
