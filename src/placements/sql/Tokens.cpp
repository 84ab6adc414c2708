#include "placements/sql/Tokens.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>

namespace limen::placements {
namespace {

constexpr std::size_t kBufferSize = std::size_t{256} << 10;
constexpr std::size_t kMostText = std::size_t{1} << 20;

bool isBlank(int c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}
bool isDigit(int c) {
    return c >= '0' && c <= '9';
}
bool isInName(int c) {
    return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '$' ||
           c >= 0x80;
}
bool isInVariable(int c) {
    return isInName(c) || c == '@' || c == '.';
}

/// The characters that matter while a statement is skipped.
constexpr std::array<bool, 256> markTable() {
    std::array<bool, 256> marks{};
    for (const char c : {';', '\'', '"', '`', '/', '-', '#', '\0'})
        marks[static_cast<unsigned char>(c)] = true;
    return marks;
}
constexpr std::array<bool, 256> kIsMark = markTable();

} // namespace

Tokens::Tokens(ReadBytes read, std::string name)
    : read_(std::move(read)), name_(std::move(name)), buffer_(kBufferSize) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    while (end_ < kByteOrderMark.size() && refill()) { // a read may give one byte
    }
    if (std::string_view(buffer_.data(), end_).starts_with(kByteOrderMark))
        at_ = kByteOrderMark.size();
}

/// Keeps the current character if there is one, so that peekAfter() needs no third buffer.
bool Tokens::refill() {
    if (isAtEnd_ || !broken_)
        return false;
    const std::size_t kept = end_ - at_;
    (void)line(); // counts the lines that leave the buffer
    counted_ = 0;
    discarded_ += at_;
    std::memmove(buffer_.data(), buffer_.data() + at_, kept);
    at_ = 0;
    end_ = kept;
    const Result<std::size_t> more = read_(std::span(buffer_).subspan(kept));
    if (!more) {
        broken_ = Failure(more.error());
        return false;
    }
    end_ += *more;
    isAtEnd_ = *more == 0;
    return *more > 0;
}

int Tokens::peek() {
    if (at_ == end_ && !refill())
        return kEnd;
    return static_cast<unsigned char>(buffer_[at_]);
}

int Tokens::peekAfter() {
    if (end_ - at_ < 2 && !refill())
        return kEnd;
    return end_ - at_ < 2 ? kEnd : static_cast<unsigned char>(buffer_[at_ + 1]);
}

std::size_t Tokens::line() {
    const char* const text = buffer_.data();
    line_ += static_cast<std::size_t>(std::count(text + counted_, text + at_, '\n'));
    counted_ = at_;
    return line_;
}

Failure Tokens::faultAt(std::size_t line, std::string what) const {
    return fail(ErrorCode::Malformed, fmt::format("{}:{}", name_, line), std::move(what));
}

Failure Tokens::endsWithin(std::size_t line, const char* part) const {
    if (!broken_)
        return Failure(broken_.error());
    return faultAt(line,
                   fmt::format("the file ends within the {} that begins here; it is not complete", part));
}

void Tokens::skipLine() {
    for (int c = peek(); c != kEnd && c != '\n'; c = peek())
        skip();
}

Result<void> Tokens::skipComment() {
    const std::size_t begin = line();
    skip();
    skip();
    for (int c = peek(); c != kEnd; c = peek()) {
        if (c == '*' && peekAfter() == '/') {
            skip();
            skip();
            return {};
        }
        skip();
        while (at_ < end_ && buffer_[at_] != '*')
            ++at_;
    }
    return endsWithin(begin, "comment");
}

Result<void> Tokens::skipBlanks() {
    for (;;) {
        const int c = peek();
        if (isBlank(c)) {
            skip();
        } else if (c == '#' || (c == '-' && peekAfter() == '-')) {
            skipLine();
        } else if (c == '/' && peekAfter() == '*') {
            if (Result<void> done = skipComment(); !done)
                return done;
        } else {
            return broken_;
        }
    }
}

Result<void> Tokens::skipQuoted(char quote) {
    const std::size_t begin = line();
    skip();
    for (int c = peek(); c != kEnd; c = peek()) {
        skip();
        if (c == '\\' && quote != '`') {
            if (peek() != kEnd)
                skip();
        } else if (c == quote) {
            if (peek() != quote)
                return {};
            skip();
        }
        while (at_ < end_ && buffer_[at_] != quote && buffer_[at_] != '\\')
            ++at_;
    }
    return endsWithin(begin, "string");
}

void Tokens::addEscaped(int c) {
    switch (c) {
    case '0':
        text_ += '\0';
        break;
    case 'b':
        text_ += '\b';
        break;
    case 'n':
        text_ += '\n';
        break;
    case 'r':
        text_ += '\r';
        break;
    case 't':
        text_ += '\t';
        break;
    case 'Z':
        text_ += '\x1A';
        break;
    case '%':
    case '_':
        text_ += '\\';
        [[fallthrough]];
    default:
        text_ += static_cast<char>(c);
    }
}

Result<Token> Tokens::readQuoted(Token::Kind kind, char quote) {
    const std::size_t begin = line();
    text_.clear();
    skip();
    for (int c = peek(); c != kEnd; c = peek()) {
        skip();
        if (text_.size() > kMostText)
            return faultAt(begin, "a string of more than 1 MiB");
        if (c == '\\' && quote != '`') {
            const int escaped = peek();
            if (escaped == kEnd)
                break;
            skip();
            addEscaped(escaped);
        } else if (c != quote) {
            text_ += static_cast<char>(c);
        } else if (peek() == quote) {
            skip();
            text_ += quote;
        } else {
            return Token{kind, text_};
        }
    }
    return endsWithin(begin, "string");
}

Result<Token> Tokens::readWhile(Token::Kind kind, bool (*belongs)(int)) {
    text_.clear();
    for (int c = peek(); c != kEnd && belongs(c); c = peek()) {
        if (text_.size() == kMostText)
            return fault("a name of more than 1 MiB");
        text_ += static_cast<char>(c);
        skip();
    }
    return Token{kind, text_};
}

Result<Token> Tokens::readNumber() {
    text_.clear();
    bool isExponent = false; // the character before was the e of a decimal number
    for (int c = peek(); c != kEnd; c = peek()) {
        const bool isHex = text_.starts_with("0x");
        if (!isInName(c) && c != '.' && !(isExponent && (c == '+' || c == '-')))
            break;
        isExponent = !isHex && (c == 'e' || c == 'E');
        if (text_.size() == kMostText)
            return fault("a number of more than 1 MiB");
        text_ += static_cast<char>(c);
        skip();
    }
    return Token{Token::Kind::Number, text_};
}

Result<Token> Tokens::next() {
    if (Result<void> blanks = skipBlanks(); !blanks)
        return Failure(blanks.error());
    const int c = peek();
    if (c == kEnd)
        return Token{};
    if (c == '\0')
        return fault("a byte 0 outside of a string: the file is damaged");
    if (c == '\'' || c == '"')
        return readQuoted(Token::Kind::String, static_cast<char>(c));
    if (c == '`')
        return readQuoted(Token::Kind::QuotedName, '`');
    if (isDigit(c) || (c == '.' && isDigit(peekAfter())))
        return readNumber();
    if (c == '@')
        return readWhile(Token::Kind::Variable, isInVariable);
    if (isInName(c))
        return readWhile(Token::Kind::Word, isInName);
    skip();
    text_.assign(1, static_cast<char>(c));
    return Token{Token::Kind::Symbol, text_};
}

Result<bool> Tokens::skipStatement() {
    for (;;) {
        while (at_ < end_ && !kIsMark[static_cast<unsigned char>(buffer_[at_])])
            ++at_;
        const int c = peek();
        if (c == kEnd)
            return broken_.map([] { return false; });
        if (c == '\0')
            return fault("a byte 0 outside of a string: the file is damaged");
        Result<void> skipped;
        if (c == '\'' || c == '"' || c == '`')
            skipped = skipQuoted(static_cast<char>(c));
        else if (c == '#' || (c == '-' && peekAfter() == '-'))
            skipLine();
        else if (c == '/' && peekAfter() == '*')
            skipped = skipComment();
        else if (kIsMark[static_cast<std::size_t>(c)])
            skip();
        if (!skipped)
            return Failure(skipped.error());
        if (c == ';')
            return true;
    }
}

} // namespace limen::placements
