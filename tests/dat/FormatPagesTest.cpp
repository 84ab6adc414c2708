#include "dat/File.h"
#include "dat/Hex.h"
#include "dat/RecordTypes.h"
#include "dat/Writer.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

// The worked examples of docs/formats/README.md#worked-examples: every record there decodes and is encoded to the same
// bytes, every type has an example, and the example file is the one that the writer makes.
namespace limen::dat {
namespace {

/// A fenced example: the words behind its three back quotes, and its lines.
struct Example {
    std::string page;
    std::vector<std::string> words;
    std::string text;
};

std::vector<std::string> wordsOf(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

std::vector<Example> examplesIn(std::istream& in, const std::string& page) {
    std::vector<Example> examples;
    bool inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("```")) {
            if (!inside)
                examples.push_back({page, wordsOf(line.substr(3)), {}});
            inside = !inside;
        } else if (inside) {
            examples.back().text += line + '\n';
        }
    }
    return examples;
}

std::vector<Example> allExamples() {
    std::vector<Example> all;
    for (const auto& entry : std::filesystem::directory_iterator(LIMEN_FORMAT_PAGES)) {
        std::ifstream in(entry.path());
        const auto some = examplesIn(in, entry.path().filename());
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// Removes comments and carries out repetitions: `FF x3` a byte, `(00 01) x3` a group.
std::string expanded(const std::string& text) {
    std::string out;
    std::string last; ///< the byte or group that a repetition would repeat
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream in(line.substr(0, line.find('#')));
        for (std::string word; in >> word;) {
            if (word.starts_with('x')) {
                const int times = std::stoi(word.substr(1));
                for (int i = 1; i < times; ++i)
                    out += last;
            } else if (word.starts_with('(')) {
                std::string group = word.substr(1);
                while (!group.ends_with(')') && in >> word)
                    group += ' ' + word;
                last = group.substr(0, group.find(')')) + ' ';
                out += last;
            } else {
                last = word + ' ';
                out += last;
            }
        }
    }
    return out;
}

std::optional<RecordKind> kindNamed(const std::string& name) {
    for (int i = 0; i <= static_cast<int>(RecordKind::Other); ++i)
        if (name == nameOf(static_cast<RecordKind>(i)))
            return static_cast<RecordKind>(i);
    return std::nullopt;
}

/// An error if the payload is no record of that kind, or is encoded to other bytes.
std::string fault(RecordKind kind, RecordId id, const Bytes& bytes) {
    std::string error = "Limen decodes no such type";
    visitKind(kind, [&]<class Record>(std::type_identity<Record>) {
        const Result<Record> record = decode<Record>(id, bytes);
        if (!record)
            error = record.error().message();
        else if (*encode(*record) != bytes)
            error = "it is encoded to other bytes";
        else
            error.clear();
    });
    return error;
}

TEST(FormatPages, everyExampleRecordIsDecodedAndEncodedToTheSameBytes) {
    std::set<RecordKind> shown;
    for (const Example& example : allExamples()) {
        if (example.words.empty() || example.words[0] != "hex")
            continue;
        ASSERT_EQ(example.words.size(), 3u) << example.page;
        const std::optional<RecordKind> kind = kindNamed(example.words[1]);
        const auto id = static_cast<RecordId>(std::stoul(example.words[2], nullptr, 16));
        ASSERT_TRUE(kind) << example.page << ": no type is called " << example.words[1];
        const FileRole role = isOfCells(*kind) ? FileRole::Cell : FileRole::Portal;
        EXPECT_EQ(kindOf(role, id), *kind) << example.page << ": " << example.words[2];
        EXPECT_EQ(fault(*kind, id, hex(expanded(example.text))), "")
            << example.page << ": " << example.words[1];
        shown.insert(*kind);
    }
    for (int i = 0; i < static_cast<int>(RecordKind::Iteration); ++i)
        EXPECT_TRUE(shown.contains(static_cast<RecordKind>(i)))
            << nameOf(static_cast<RecordKind>(i)) << " has no example in docs/formats";
}

TEST(FormatPages, theSmallestFileIsTheOneThatTheWriterMakes) {
    int count = 0;
    for (const Example& example : allExamples()) {
        if (example.words.empty() || example.words[0] != "hex-at")
            continue;
        ++count;
        ASSERT_EQ(example.words.size(), 3u) << example.page;
        ASSERT_EQ(example.words[1], "portal");
        Bytes file(std::stoul(example.words[2], nullptr, 16));
        std::istringstream lines(example.text);
        for (std::string line; std::getline(lines, line);) {
            const std::size_t colon = line.find(':');
            ASSERT_NE(colon, std::string::npos) << line;
            const std::size_t at = std::stoul(line.substr(0, colon), nullptr, 16);
            const Bytes part = hex(expanded(line.substr(colon + 1)));
            ASSERT_LE(at + part.size(), file.size()) << line;
            std::copy(part.begin(), part.end(), file.begin() + static_cast<std::ptrdiff_t>(at));
        }
        const Bytes made = *Writer(FileTraits::portal()).build();
        ASSERT_EQ(made.size(), file.size());
        const auto [one, other] = std::mismatch(made.begin(), made.end(), file.begin());
        EXPECT_TRUE(one == made.end()) << "they differ at offset " << (one - made.begin());
        EXPECT_TRUE(File::fromBytes(file, "page.dat")) << example.page;
    }
    EXPECT_EQ(count, 1);
}

TEST(FormatPages, theNotationOfExamplesRepeatsBytesAndGroups) {
    EXPECT_EQ(toHex(hex(expanded("01 (02 03) x2  # 44\n05 x3"))), "01 02 03 02 03 05 05 05 ");
    EXPECT_NE(fault(RecordKind::Palette, 0x04000001, hex("01 00 00 04  02 00 00 00")), "");
    std::istringstream page("text\n```hex Palette 0x04000001\n01\n```\n    ```hex\n");
    const auto examples = examplesIn(page, "page");
    ASSERT_EQ(examples.size(), 1u);
    EXPECT_EQ(examples[0].words.at(1), "Palette");
    EXPECT_EQ(examples[0].text, "01\n");
}

} // namespace
} // namespace limen::dat
