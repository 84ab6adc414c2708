#include "placements/store/Sqlite.h"

#include "core/Assert.h"

#include <sqlite3.h>

namespace limen::placements {
namespace {

Failure failed(sqlite3* database, const std::string& where) {
    const int code = sqlite3_errcode(database);
    const bool isDamaged = code == SQLITE_NOTADB || code == SQLITE_CORRUPT || code == SQLITE_ERROR;
    return fail(isDamaged ? ErrorCode::Malformed : ErrorCode::Unreadable, where,
                std::string(sqlite3_errmsg(database)) +
                    (isDamaged ? "; write it again with limen world import" : ""));
}

} // namespace

void Query::Finalized::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

void Query::bind(int parameter, std::int64_t value) {
    sqlite3_bind_int64(statement_.get(), parameter + 1, value);
}
void Query::bindReal(int parameter, double value) {
    sqlite3_bind_double(statement_.get(), parameter + 1, value);
}
void Query::bindText(int parameter, std::string_view text) {
    sqlite3_bind_text64(statement_.get(), parameter + 1, text.data(), text.size(), SQLITE_TRANSIENT,
                        SQLITE_UTF8);
}
void Query::bindNull(int parameter) {
    sqlite3_bind_null(statement_.get(), parameter + 1);
}

Result<bool> Query::step() {
    LIMEN_ASSERT(statement_ != nullptr, "the query is prepared");
    const int status = sqlite3_step(statement_.get());
    if (status == SQLITE_ROW)
        return true;
    if (status == SQLITE_DONE)
        return false;
    return failed(sqlite3_db_handle(statement_.get()), where_);
}

Result<void> Query::execute() {
    const Result<bool> row = step();
    reset();
    if (!row)
        return Failure(row.error());
    return {};
}

void Query::reset() {
    sqlite3_reset(statement_.get());
}

bool Query::isNull(int column) const {
    return sqlite3_column_type(statement_.get(), column) == SQLITE_NULL;
}
std::int64_t Query::integer(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}
double Query::real(int column) const {
    return sqlite3_column_double(statement_.get(), column);
}
std::string Query::text(int column) const {
    const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    const int length = sqlite3_column_bytes(statement_.get(), column);
    return text != nullptr ? std::string(text, static_cast<std::size_t>(length)) : std::string();
}

void Sqlite::DatabaseClosed::operator()(sqlite3* database) const {
    sqlite3_close_v2(database);
}

Result<Sqlite> Sqlite::open(const std::filesystem::path& path, Mode mode) {
    const int flags = mode == Mode::Read     ? SQLITE_OPEN_READONLY
                      : mode == Mode::Change ? SQLITE_OPEN_READWRITE
                                             : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
    Sqlite opened;
    opened.where_ = path.string();
    sqlite3* database = nullptr;
    const int status =
        sqlite3_open_v2(opened.where_.c_str(), &database, flags | SQLITE_OPEN_FULLMUTEX, nullptr);
    opened.database_.reset(database);
    if (database == nullptr)
        return fail(ErrorCode::Unsupported, path.string(), "SQLite has no memory");
    if (status != SQLITE_OK)
        return failed(database, opened.where_);
    // The file may come from elsewhere: its schema must not run functions or write to itself.
    sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_busy_timeout(database, 5000);
    return opened;
}

Result<void> Sqlite::run(const char* sql) {
    if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK)
        return failed(database_.get(), where_);
    return {};
}

Result<Query> Sqlite::prepare(std::string_view sql) const {
    Query query;
    query.where_ = where_;
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr) !=
        SQLITE_OK)
        return failed(database_.get(), where_);
    query.statement_.reset(statement);
    return query;
}

Result<std::int64_t> Sqlite::number(std::string_view sql) const {
    Result<Query> query = prepare(sql);
    if (!query)
        return Failure(query.error());
    const Result<bool> row = query->step();
    if (!row)
        return Failure(row.error());
    return *row ? query->integer(0) : 0;
}

} // namespace limen::placements
