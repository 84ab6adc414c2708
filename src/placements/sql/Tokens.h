#pragma once

#include "core/Error.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limen::placements {

/// Reads the next bytes of a text into a buffer, at most as many as fit. 0: the end.
using ReadBytes = std::function<Result<std::size_t>(std::span<char>)>;

/// One token of SQL.
struct Token {
    enum class Kind : std::uint8_t {
        End,        ///< of the text
        Word,       ///< a key word or a bare name
        QuotedName, ///< between back quotes
        String,     ///< with escapes resolved
        Number,     ///< without sign, as it is written: decimal, or hexadecimal with 0x
        Variable,   ///< a name with one or two @
        Symbol      ///< one character
    };
    Kind kind = Kind::End;
    std::string_view text; ///< valid until the next call
    [[nodiscard]] bool isSymbol(char c) const { return kind == Kind::Symbol && text[0] == c; }
};

/// Splits the SQL of MySQL into tokens, in a buffer of constant size. Comments are skipped, those with
/// instructions for servers, too. Ref: MySQL 8 reference manual, "Lexical Structure" and "String Literals".
class Tokens {
public:
    /// `name`: of the text, for error messages.
    Tokens(ReadBytes read, std::string name);

    /// Errors: those of `read`; the text ends within a token; a token of more than 1 MiB; a NUL byte outside
    /// of a string.
    [[nodiscard]] Result<Token> next();
    /// Skips all up to and including the next semicolon outside of strings and comments, or up to the end.
    /// False if the text ended first. Errors: as next().
    [[nodiscard]] Result<bool> skipStatement();

    /// The line of the current position, from 1.
    [[nodiscard]] std::size_t line();
    /// An error in that line of the text.
    [[nodiscard]] Failure faultAt(std::size_t line, std::string what) const;
    [[nodiscard]] Failure fault(std::string what) { return faultAt(line(), std::move(what)); }
    /// Bytes of the text that were read.
    [[nodiscard]] std::size_t position() const { return discarded_ + at_; }

private:
    static constexpr int kEnd = -1;
    [[nodiscard]] int peek();
    [[nodiscard]] int peekAfter(); ///< the character after the one that peek() gives
    void skip() { ++at_; }
    bool refill();

    [[nodiscard]] Result<void> skipBlanks();
    void skipLine();
    [[nodiscard]] Result<void> skipComment();
    [[nodiscard]] Result<void> skipQuoted(char quote);
    [[nodiscard]] Result<Token> readQuoted(Token::Kind kind, char quote);
    [[nodiscard]] Result<Token> readWhile(Token::Kind kind, bool (*belongs)(int));
    [[nodiscard]] Result<Token> readNumber();
    void addEscaped(int c);
    [[nodiscard]] Failure endsWithin(std::size_t line, const char* part) const;

    ReadBytes read_;
    std::string name_;
    std::vector<char> buffer_;
    std::size_t at_ = 0, end_ = 0;
    std::size_t discarded_ = 0;          ///< bytes before the buffer
    std::size_t line_ = 1, counted_ = 0; ///< the line of buffer_[counted_]
    bool isAtEnd_ = false;
    Result<void> broken_; ///< an error of read_
    std::string text_;    ///< of the current token
};

} // namespace limen::placements
