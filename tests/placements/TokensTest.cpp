#include "placements/sql/Tokens.h"
#include "placements/sql/Text.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

// Tokens of SQL, read in pieces of every size.
namespace {

using namespace limen;
using namespace limen::placements;
using Kind = Token::Kind;

/// Reads a text in pieces of `step` bytes.
ReadBytes piecesOf(std::string text, std::size_t step) {
    return [text = std::move(text), step,
            at = std::size_t{0}](std::span<char> out) mutable -> Result<std::size_t> {
        const std::size_t count = std::min({step, out.size(), text.size() - at});
        std::memcpy(out.data(), text.data() + at, count);
        at += count;
        return count;
    };
}

/// The tokens of a text as "kind:text", or the message of the error.
std::vector<std::string> tokensOf(const std::string& text, std::size_t step = 1000) {
    Tokens tokens(piecesOf(text, step), "t.sql");
    std::vector<std::string> found;
    for (;;) {
        const Result<Token> token = tokens.next();
        if (!token) {
            found.push_back(token.error().message());
            return found;
        }
        if (token->kind == Kind::End)
            return found;
        found.push_back(std::to_string(static_cast<int>(token->kind)) + ":" + std::string(token->text));
    }
}

std::string one(Kind kind, const std::string& text) {
    return std::to_string(static_cast<int>(kind)) + ":" + text;
}

TEST(Tokens, knowsEachKind) {
    EXPECT_EQ(tokensOf("INSERT `a``b` 'it''s' \"q\" 0xA9B4 -1.5e-3 @id @@sql_mode (,)"),
              (std::vector<std::string>{
                  one(Kind::Word, "INSERT"), one(Kind::QuotedName, "a`b"), one(Kind::String, "it's"),
                  one(Kind::String, "q"), one(Kind::Number, "0xA9B4"), one(Kind::Symbol, "-"),
                  one(Kind::Number, "1.5e-3"), one(Kind::Variable, "@id"), one(Kind::Variable, "@@sql_mode"),
                  one(Kind::Symbol, "("), one(Kind::Symbol, ","), one(Kind::Symbol, ")")}));
}

TEST(Tokens, aHexadecimalNumberEndsBeforeASign) {
    EXPECT_EQ(tokensOf("0x1E+2"), (std::vector<std::string>{one(Kind::Number, "0x1E"), one(Kind::Symbol, "+"),
                                                            one(Kind::Number, "2")}));
}

TEST(Tokens, resolvesEscapes) {
    const std::vector<std::string> expected{one(Kind::String, std::string("a\n\t\0\\\x1A'\"\\%x", 11))};
    EXPECT_EQ(tokensOf(R"('a\n\t\0\\\Z\'\"\%\x')"), expected);
}

TEST(Tokens, skipsCommentsOfAllKinds) {
    EXPECT_EQ(tokensOf("a -- b\nc # d\ne /* f ; ' */ g /*! h */ i"),
              (std::vector<std::string>{one(Kind::Word, "a"), one(Kind::Word, "c"), one(Kind::Word, "e"),
                                        one(Kind::Word, "g"), one(Kind::Word, "i")}));
}

TEST(Tokens, skipsAByteOrderMark) {
    for (const std::size_t step : {1, 2, 3, 1000})
        EXPECT_EQ(tokensOf("\xEF\xBB\xBFx", step), (std::vector<std::string>{one(Kind::Word, "x")})) << step;
}

TEST(Tokens, theSizeOfThePiecesDoesNotMatter) {
    std::string text = "INSERT INTO `t` VALUES ('it''s', 0x1F, -2.5e3) /* ** */ -- x\n; ";
    for (int i = 0; i < 3; ++i)
        text += text;
    const std::vector<std::string> whole = tokensOf(text);
    for (const std::size_t step : {1, 2, 3, 5, 7, 11})
        EXPECT_EQ(tokensOf(text, step), whole) << step;
}

TEST(Tokens, aTokenMayBeLongerThanTheBuffer) {
    const std::string text(700'000, 'x');
    EXPECT_EQ(tokensOf("'" + text + "' y", 5000),
              (std::vector<std::string>{one(Kind::String, text), one(Kind::Word, "y")}));
}

TEST(Tokens, namesTheLineOfAFault) {
    EXPECT_EQ(tokensOf("a\nb\n'c\nd").back(),
              "t.sql:3: the file ends within the string that begins here; it is not complete");
    EXPECT_EQ(tokensOf("a\n/* b\n").back(),
              "t.sql:2: the file ends within the comment that begins here; it is not complete");
    EXPECT_EQ(tokensOf(std::string("a\n\0b", 4)).back(),
              "t.sql:2: a byte 0 outside of a string: the file is damaged");
    EXPECT_EQ(tokensOf("\n'" + std::string(1'100'000, 'x') + "'").back(),
              "t.sql:2: a string of more than 1 MiB");
}

TEST(Tokens, countsLinesBeyondTheBuffer) {
    std::string text;
    for (int i = 0; i < 50'000; ++i)
        text += "word 'a'\n";
    EXPECT_EQ(tokensOf(text + "'").back(),
              "t.sql:50001: the file ends within the string that begins here; it is not complete");
}

TEST(Tokens, skipsAStatementWithItsStringsAndComments) {
    for (const std::size_t step : {1, 3, 1000}) {
        Tokens tokens(piecesOf("a ';' \"\\\";\" `;` /* ; */ -- ;\n # ;\n x-y / z; next", step), "t.sql");
        const Result<bool> skipped = tokens.skipStatement();
        ASSERT_TRUE(skipped.has_value());
        EXPECT_TRUE(*skipped);
        const Result<Token> token = tokens.next();
        ASSERT_TRUE(token.has_value());
        EXPECT_EQ(token->text, "next");
    }
}

TEST(Tokens, reportsTheErrorOfItsSource) {
    Tokens tokens(
        [](std::span<char>) -> Result<std::size_t> { return fail(ErrorCode::Unreadable, "disk", "gone"); },
        "t.sql");
    const Result<Token> token = tokens.next();
    ASSERT_FALSE(token.has_value());
    EXPECT_EQ(token.error().message(), "disk: gone");
}

TEST(SqlText, replacesBytesThatAreNoUtf8) {
    EXPECT_EQ(validUtf8("a\u00E9\u20AC\U0001F6AA"), "a\u00E9\u20AC\U0001F6AA");
    EXPECT_EQ(validUtf8("a\xFFz"), "a\uFFFDz");
    EXPECT_EQ(validUtf8("\xC3"), "\uFFFD");                     // ends early
    EXPECT_EQ(validUtf8("\xE0\x80\x80"), "\uFFFD\uFFFD\uFFFD"); // longer than needed
    EXPECT_EQ(validUtf8("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD"); // half of a surrogate pair
    EXPECT_EQ(printable("a\nb\x7F"), "a b ");
}

} // namespace
