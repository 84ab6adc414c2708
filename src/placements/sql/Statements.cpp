#include "placements/sql/Statements.h"

#include "core/Assert.h"
#include "placements/sql/Text.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace limen::placements {
namespace {

bool isWord(const Token& token, std::string_view word) {
    return token.kind == Token::Kind::Word && isSameName(token.text, word);
}

/// A number as it is written, with its sign. Unknown if it is none, or an integer of more than 64 bits.
Value numberOf(std::string_view text, bool isNegative) {
    Value value;
    value.kind = Value::Kind::Unknown;
    const char* const end = text.data() + text.size();
    const bool isHex = text.starts_with("0x") || text.starts_with("0X");
    std::uint64_t integer = 0;
    const auto whole = std::from_chars(text.data() + (isHex ? 2 : 0), end, integer, isHex ? 16 : 10);
    if (whole.ec == std::errc() && whole.ptr == end) {
        if (integer > std::uint64_t{0x7FFFFFFFFFFFFFFF})
            return value;
        value.kind = Value::Kind::Integer;
        value.integer = isNegative ? -static_cast<std::int64_t>(integer) : static_cast<std::int64_t>(integer);
        return value;
    }
    double real = 0.0;
    const auto fraction = std::from_chars(text.data(), end, real);
    if (isHex || fraction.ec != std::errc() || fraction.ptr != end)
        return value;
    value.kind = Value::Kind::Real;
    value.real = isNegative ? -real : real;
    return value;
}

/// Reads the statements of one text.
class Statements {
public:
    Statements(Tokens& tokens, ContentBuilder& builder) : tokens_(tokens), builder_(builder) {}

    Result<void> run() {
        for (;;) {
            if (Result<void> read = advance(); !read)
                return read;
            if (token_.kind == Token::Kind::End)
                return {};
            if (token_.isSymbol(';'))
                continue;
            if (Result<void> done = statement(); !done)
                return done;
        }
    }

private:
    Result<void> advance() {
        Result<Token> token = tokens_.next();
        if (!token)
            return Failure(token.error());
        token_ = *token;
        return {};
    }

    [[nodiscard]] Failure expected(const char* what) {
        if (token_.kind == Token::Kind::End)
            return tokens_.fault("the file ends within a statement; it is not complete");
        constexpr std::size_t kMostShown = 40;
        return tokens_.fault(
            fmt::format("expected {}, found '{}'", what, printable(token_.text.substr(0, kMostShown))));
    }

    Result<void> take(char symbol) {
        if (!token_.isSymbol(symbol))
            return expected(fmt::format("'{}'", symbol).c_str());
        return advance();
    }

    /// Skips the rest of a statement. The current token must not be its semicolon.
    Result<void> skipRest() {
        const std::size_t begin = tokens_.line();
        const Result<bool> whole = tokens_.skipStatement();
        if (!whole)
            return Failure(whole.error());
        if (!*whole)
            return tokens_.faultAt(begin, "the file ends within this statement; it is not complete");
        return {};
    }

    Result<void> statement() {
        if (token_.kind != Token::Kind::Word)
            return expected("a statement");
        if (isWord(token_, "INSERT"))
            return advance().and_then([&] { return insert(); });
        if (isWord(token_, "DELETE"))
            return advance().and_then([&] { return remove(); });
        if (isWord(token_, "UPDATE") || isWord(token_, "REPLACE") || isWord(token_, "TRUNCATE"))
            return refuseForTables();
        return skipRest();
    }

    /// A name of a table, perhaps with that of its database before it. Null: another table.
    Result<const Table*> tableName() {
        for (;;) {
            if (token_.kind != Token::Kind::Word && token_.kind != Token::Kind::QuotedName)
                return expected("the name of a table");
            const Table* table = findTable(token_.text);
            if (Result<void> read = advance(); !read)
                return Failure(read.error());
            if (!token_.isSymbol('.'))
                return table;
            if (Result<void> read = advance(); !read)
                return Failure(read.error());
        }
    }

    Result<void> refuseForTables() {
        const std::string verb(token_.text);
        if (Result<void> read = advance(); !read)
            return read;
        for (const char* word : {"LOW_PRIORITY", "DELAYED", "IGNORE", "INTO", "TABLE"})
            if (isWord(token_, word))
                if (Result<void> read = advance(); !read)
                    return read;
        const Result<const Table*> table = tableName();
        if (!table)
            return Failure(table.error());
        if (*table != nullptr)
            return tokens_.fault(fmt::format("cannot execute {} on {}; only INSERT and DELETE are read",
                                             printable(verb), (*table)->name));
        return token_.isSymbol(';') ? Result<void>() : skipRest();
    }

    Result<void> remove() {
        if (!isWord(token_, "FROM"))
            return expected("FROM");
        if (Result<void> read = advance(); !read)
            return read;
        const Result<const Table*> table = tableName();
        if (!table)
            return Failure(table.error());
        if (*table == nullptr)
            return token_.isSymbol(';') ? Result<void>() : skipRest();
        if (!isWord(token_, "WHERE"))
            return expected("WHERE");
        if (Result<void> read = advance(); !read)
            return read;
        const std::string column(token_.text);
        if (token_.kind != Token::Kind::Word && token_.kind != Token::Kind::QuotedName)
            return expected("the name of a column");
        if (Result<void> read = advance().and_then([&] { return take('='); }); !read)
            return read;
        Value value;
        if (Result<void> read = this->value(value); !read)
            return read;
        if (value.kind != Value::Kind::Integer)
            return expected("an integer");
        if (!token_.isSymbol(';'))
            return expected("';'");
        return placed(builder_.remove(**table, column, value.integer));
    }

    Result<void> placed(Result<void> done) {
        if (!done && done.error().where.empty())
            return tokens_.fault(done.error().what);
        return done;
    }

    Result<void> insert() {
        for (const char* word : {"LOW_PRIORITY", "DELAYED", "HIGH_PRIORITY", "IGNORE", "INTO"})
            if (isWord(token_, word))
                if (Result<void> read = advance(); !read)
                    return read;
        const Result<const Table*> table = tableName();
        if (!table)
            return Failure(table.error());
        if (*table == nullptr)
            return token_.isSymbol(';') ? Result<void>() : skipRest();
        if (Result<void> read = columns(**table); !read)
            return read;
        if (!isWord(token_, "VALUES") && !isWord(token_, "VALUE"))
            return expected("VALUES");
        return advance().and_then([&] { return rows(**table); });
    }

    /// Reads the list of columns, or takes those of the schema.
    Result<void> columns(const Table& table) {
        columns_.clear();
        if (!token_.isSymbol('(')) {
            for (std::size_t i = 0; i < table.columns.size(); ++i)
                columns_.push_back(i);
            return {};
        }
        do {
            if (Result<void> read = advance(); !read)
                return read;
            if (token_.kind != Token::Kind::Word && token_.kind != Token::Kind::QuotedName)
                return expected("the name of a column");
            columns_.push_back(findColumn(table, token_.text));
            if (columns_.size() > kMostColumns)
                return tokens_.fault(fmt::format("more than {} columns", kMostColumns));
            if (Result<void> read = advance(); !read)
                return read;
        } while (token_.isSymbol(','));
        if (Result<void> read = take(')'); !read)
            return read;
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            const Column& column = table.columns[i];
            if (column.type == ColumnType::Unread || column.mayBeNull)
                continue;
            if (std::count(columns_.begin(), columns_.end(), i) != 1)
                return tokens_.fault(fmt::format("the row of {} has no column {}", table.name, column.name));
        }
        return {};
    }

    Result<void> rows(const Table& table) {
        for (;;) {
            if (Result<void> done = row(table); !done)
                return done;
            if (token_.isSymbol(';'))
                return {};
            if (!token_.isSymbol(','))
                return expected("',' or ';' after a row");
            if (Result<void> read = advance(); !read)
                return read;
        }
    }

    Result<void> row(const Table& table) {
        const std::size_t line = tokens_.line();
        row_.assign(table.columns.size(), Value());
        texts_.clear();
        texts_.reserve(columns_.size()); // views of its strings are in row_
        for (std::size_t i = 0; i < columns_.size(); ++i) {
            if (Result<void> read = take(i == 0 ? '(' : ','); !read)
                return read;
            Value value;
            if (Result<void> read = this->value(value); !read)
                return read;
            if (columns_[i] != kNoColumn)
                row_[columns_[i]] = value;
        }
        if (!token_.isSymbol(')'))
            return expected("')' after the last value");
        Result<void> added = builder_.add(table, row_);
        if (!added && added.error().where.empty())
            return tokens_.faultAt(line, added.error().what);
        return added.and_then([&] { return advance(); });
    }

    /// Reads one value and goes to the token after it.
    Result<void> value(Value& out) {
        bool isNegative = false;
        if (token_.isSymbol('-') || token_.isSymbol('+')) {
            isNegative = token_.isSymbol('-');
            if (Result<void> read = advance(); !read)
                return read;
            if (token_.kind != Token::Kind::Number)
                return expected("a number");
        }
        switch (token_.kind) {
        case Token::Kind::Number:
            out = numberOf(token_.text, isNegative);
            return advance();
        case Token::Kind::String:
            out = textValue();
            return advance();
        case Token::Kind::Variable:
            out.kind = Value::Kind::Unknown;
            return advance();
        case Token::Kind::Word:
            return wordValue(out);
        default:
            return expected("a value");
        }
    }

    Value textValue() {
        texts_.push_back(validUtf8(token_.text));
        return {Value::Kind::Text, 0, 0.0, texts_.back()};
    }

    /// NULL, True, False, a string with its character set, a bit string, or a call of a function.
    Result<void> wordValue(Value& out) {
        if (isWord(token_, "NULL") || isWord(token_, "DEFAULT")) {
            out = {};
            return advance();
        }
        if (isWord(token_, "True") || isWord(token_, "False")) {
            out = {Value::Kind::Integer, isWord(token_, "True") ? 1 : 0, 0.0, {}};
            return advance();
        }
        const bool isBits = isWord(token_, "b");
        const bool isText = token_.text.starts_with('_');
        if (Result<void> read = advance(); !read)
            return read;
        out.kind = Value::Kind::Unknown;
        if ((isBits || isText) && token_.kind == Token::Kind::String) {
            out = isBits ? bitsOf(token_.text) : rawText();
            return advance();
        }
        return token_.isSymbol('(') ? skipArguments() : Result<void>();
    }

    Value rawText() {
        texts_.emplace_back(token_.text);
        return {Value::Kind::Text, 0, 0.0, texts_.back()};
    }

    static Value bitsOf(std::string_view digits) {
        std::uint64_t bits = 0;
        const char* const end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, bits, 2);
        const bool isWhole = read.ec == std::errc() && read.ptr == end && bits <= 0x7FFFFFFFFFFFFFFF;
        return {
            isWhole ? Value::Kind::Integer : Value::Kind::Unknown, static_cast<std::int64_t>(bits), 0.0, {}};
    }

    Result<void> skipArguments() {
        int depth = 0;
        do {
            depth += token_.isSymbol('(') ? 1 : token_.isSymbol(')') ? -1 : 0;
            if (token_.kind == Token::Kind::End || token_.isSymbol(';'))
                return expected("')'");
            if (Result<void> read = advance(); !read)
                return read;
        } while (depth > 0);
        return {};
    }

    static constexpr std::size_t kMostColumns = 256;
    Tokens& tokens_;
    ContentBuilder& builder_;
    Token token_;
    std::vector<std::size_t> columns_; ///< of the statement: indices into Table::columns, or kNoColumn
    std::vector<Value> row_;
    std::vector<std::string> texts_; ///< of the row
};

} // namespace

Result<void> executeSql(Tokens& tokens, ContentBuilder& builder) {
    return Statements(tokens, builder).run();
}

} // namespace limen::placements
