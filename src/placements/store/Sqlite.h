#pragma once

#include "core/Error.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

// A thin layer over SQLite.
namespace limen::placements {

/// A prepared statement. Indices of parameters and columns begin at 0.
class Query {
public:
    Query() = default;
    void bind(int parameter, std::int64_t value);
    void bindReal(int parameter, double value);
    void bindText(int parameter, std::string_view text);
    void bindNull(int parameter);

    /// Goes to the next row; false after the last one. Errors: those of SQLite.
    [[nodiscard]] Result<bool> step();
    /// Executes a statement without rows, and makes it ready for new values.
    [[nodiscard]] Result<void> execute();
    /// Makes the statement ready for new values.
    void reset();

    [[nodiscard]] bool isNull(int column) const;
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] double real(int column) const;
    [[nodiscard]] std::string text(int column) const;

private:
    friend class Sqlite;
    struct Finalized {
        void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalized> statement_;
    std::string where_;
};

/// An open database file.
class Sqlite {
public:
    enum class Mode : std::uint8_t { Read, Create, Change };
    /// Errors: the file cannot be opened; it is no SQLite database.
    [[nodiscard]] static Result<Sqlite> open(const std::filesystem::path& path, Mode mode);

    [[nodiscard]] Result<void> run(const char* sql);
    [[nodiscard]] Result<Query> prepare(std::string_view sql) const;
    /// The first column of the first row of a query, e.g. of a PRAGMA.
    [[nodiscard]] Result<std::int64_t> number(std::string_view sql) const;

private:
    struct DatabaseClosed {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, DatabaseClosed> database_;
    std::string where_;
};

} // namespace limen::placements
