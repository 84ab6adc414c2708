#include "core/Assert.h"
#include "placements/ContentBuilder.h"
#include "placements/Import.h"
#include "placements/server/ServerUrl.h"
#include "placements/sql/Text.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <mysql.h>

namespace limen::placements {
namespace {

struct ConnectionClosed {
    void operator()(MYSQL* connection) const { mysql_close(connection); }
};
struct StatementClosed {
    void operator()(MYSQL_STMT* statement) const { mysql_stmt_close(statement); }
};
struct ResultFreed {
    void operator()(MYSQL_RES* result) const { mysql_free_result(result); }
};
using Connection = std::unique_ptr<MYSQL, ConnectionClosed>;
using Statement = std::unique_ptr<MYSQL_STMT, StatementClosed>;

constexpr unsigned kConnectSeconds = 10, kReadSeconds = 120;

/// The fault of a query, as the server states it, with a next step.
Failure refused(const std::string& where, unsigned number, const char* reason) {
    constexpr unsigned kNoTable = 1146, kNoColumn = 1054;
    const bool isSchema = number == kNoTable || number == kNoColumn;
    return fail(isSchema ? ErrorCode::Malformed : ErrorCode::Unreadable, where,
                printable(reason) +
                    (isSchema ? "; the database is not a world database that Limen knows" : ""));
}

bool isIntegerField(enum_field_types type) {
    return type == MYSQL_TYPE_TINY || type == MYSQL_TYPE_SHORT || type == MYSQL_TYPE_INT24 ||
           type == MYSQL_TYPE_LONG || type == MYSQL_TYPE_LONGLONG;
}

/// Whether values of a field of the server can be read as those of a column.
bool fits(enum_field_types type, ColumnType column) {
    switch (column) {
    case ColumnType::Float:
        return type == MYSQL_TYPE_FLOAT;
    case ColumnType::Double:
        return type == MYSQL_TYPE_DOUBLE;
    case ColumnType::Text:
        return type == MYSQL_TYPE_VAR_STRING || type == MYSQL_TYPE_STRING || type == MYSQL_TYPE_BLOB;
    default:
        return isIntegerField(type);
    }
}

/// The wanted columns of a table, separated by commas. A bit is read as a number.
std::string columnList(const Table& table) {
    std::string list;
    for (const Column& column : table.columns)
        if (column.type != ColumnType::Unread)
            list += fmt::format("{}`{}`{}", list.empty() ? "" : ", ", column.name,
                                column.type == ColumnType::Bit ? " + 0" : "");
    return list;
}

/// One column of the current row, in the memory that the client library writes to.
struct Slot {
    long long integer = 0;
    float single = 0.0f;
    double real = 0.0;
    std::vector<char> text;
    unsigned long length = 0;
    my_bool isNull = 0;
};

/// Reads the rows of one table.
class TableReader {
public:
    TableReader(MYSQL* connection, const Table& table, const std::string& where)
        : table_(table), where_(where), statement_(mysql_stmt_init(connection)) {}

    /// Errors: the table or a column is missing, or a column has another type.
    Result<void> prepare() {
        LIMEN_ASSERT(statement_ != nullptr, "the client library has memory for a statement");
        const std::string query =
            fmt::format("SELECT {} FROM `{}` ORDER BY `{}`", columnList(table_), table_.name, table_.order);
        if (mysql_stmt_prepare(statement_.get(), query.data(), query.size()) != 0)
            return refused(where_, mysql_stmt_errno(statement_.get()), mysql_stmt_error(statement_.get()));
        const std::unique_ptr<MYSQL_RES, ResultFreed> meta(mysql_stmt_result_metadata(statement_.get()));
        unsigned field = 0;
        for (const Column& column : table_.columns) {
            if (column.type == ColumnType::Unread)
                continue;
            if (meta == nullptr || field >= mysql_num_fields(meta.get()) ||
                !fits(mysql_fetch_field_direct(meta.get(), field)->type, column.type))
                return fail(ErrorCode::Malformed, where_,
                            fmt::format("column {} of {} has another type than in a world database",
                                        column.name, table_.name));
            ++field;
        }
        return {};
    }

    /// Calls `take` for each row. Requires prepare().
    template <class Take>
    Result<void> read(Take&& take) {
        if (mysql_stmt_execute(statement_.get()) != 0 || !bind())
            return refused(where_, mysql_stmt_errno(statement_.get()), mysql_stmt_error(statement_.get()));
        for (;;) {
            const int status = mysql_stmt_fetch(statement_.get());
            if (status == MYSQL_NO_DATA)
                return {};
            if (status == MYSQL_DATA_TRUNCATED)
                return fail(ErrorCode::Malformed, where_,
                            fmt::format("{} has a text of more than {} bytes", table_.name, kMostText));
            if (status != 0)
                return refused(where_, mysql_stmt_errno(statement_.get()),
                               mysql_stmt_error(statement_.get()));
            if (Result<void> taken = take(row()); !taken)
                return taken;
        }
    }

private:
    static constexpr std::size_t kMostText = 65'535; // that of the type TEXT

    bool bind() {
        const std::size_t count = table_.columns.size();
        slots_.assign(count, {});
        std::vector<MYSQL_BIND> binds;
        for (std::size_t i = 0; i < count; ++i) {
            if (table_.columns[i].type == ColumnType::Unread)
                continue;
            Slot& slot = slots_[i];
            MYSQL_BIND bind{};
            bind.is_null = &slot.isNull;
            bind.length = &slot.length;
            switch (table_.columns[i].type) {
            case ColumnType::Float:
                bind.buffer_type = MYSQL_TYPE_FLOAT;
                bind.buffer = &slot.single;
                break;
            case ColumnType::Double:
                bind.buffer_type = MYSQL_TYPE_DOUBLE;
                bind.buffer = &slot.real;
                break;
            case ColumnType::Text:
                slot.text.resize(kMostText);
                bind.buffer_type = MYSQL_TYPE_STRING;
                bind.buffer = slot.text.data();
                bind.buffer_length = kMostText;
                break;
            default:
                bind.buffer_type = MYSQL_TYPE_LONGLONG;
                bind.buffer = &slot.integer;
            }
            binds.push_back(bind);
        }
        return mysql_stmt_bind_result(statement_.get(), binds.data()) == 0;
    }

    std::span<const Value> row() {
        row_.assign(slots_.size(), Value());
        texts_.clear();
        texts_.reserve(slots_.size()); // views of its strings are in row_
        for (std::size_t i = 0; i < slots_.size(); ++i) {
            const Slot& slot = slots_[i];
            Value& value = row_[i];
            if (table_.columns[i].type == ColumnType::Unread || slot.isNull != 0)
                continue;
            switch (table_.columns[i].type) {
            case ColumnType::Float:
                value = {Value::Kind::Real, 0, static_cast<double>(slot.single), {}};
                break;
            case ColumnType::Double:
                value = {Value::Kind::Real, 0, slot.real, {}};
                break;
            case ColumnType::Text:
                texts_.push_back(validUtf8({slot.text.data(), slot.length}));
                value = {Value::Kind::Text, 0, 0.0, texts_.back()};
                break;
            default:
                value = {Value::Kind::Integer, slot.integer, 0.0, {}};
            }
        }
        return row_;
    }

    const Table& table_;
    const std::string& where_;
    Statement statement_;
    std::vector<Slot> slots_;
    std::vector<Value> row_;
    std::vector<std::string> texts_;
};

const char* orNull(const std::string& text) {
    return text.empty() ? nullptr : text.c_str();
}

Result<Connection> connect(const ServerAccess& access, const ServerUrl& url, const std::string& where) {
    Connection connection(mysql_init(nullptr));
    if (connection == nullptr)
        return fail(ErrorCode::Unsupported, where, "the client library cannot be used");
    MYSQL* const c = connection.get();
    mysql_options(c, MYSQL_OPT_CONNECT_TIMEOUT, &kConnectSeconds);
    mysql_options(c, MYSQL_OPT_READ_TIMEOUT, &kReadSeconds);
    mysql_options(c, MYSQL_SET_CHARSET_NAME, "utf8mb4");
    const unsigned noLocalFiles = 0; // a server could otherwise ask for files of this computer
    mysql_options(c, MYSQL_OPT_LOCAL_INFILE, &noLocalFiles);
    if (!access.optionFile.empty())
        mysql_options(c, MYSQL_READ_DEFAULT_FILE, access.optionFile.c_str());
    if (mysql_real_connect(c, orNull(url.host), orNull(url.user), orNull(access.password),
                           url.database.c_str(), url.port, orNull(url.socket), 0) == nullptr)
        return fail(ErrorCode::Unreadable, where,
                    printable(mysql_error(c)) +
                        "; check the URL, the user and the password (MYSQL_PWD or --option-file)");
    return connection;
}

Result<void> run(MYSQL* connection, const char* query, const std::string& where) {
    if (mysql_query(connection, query) != 0)
        return refused(where, mysql_errno(connection), mysql_error(connection));
    return {};
}

Result<std::size_t> countRows(MYSQL* connection, const std::string& where) {
    std::size_t total = 0;
    for (const Table& table : tables()) {
        if (Result<void> done =
                run(connection, fmt::format("SELECT COUNT(*) FROM `{}`", table.name).c_str(), where);
            !done)
            return Failure(done.error());
        const std::unique_ptr<MYSQL_RES, ResultFreed> result(mysql_store_result(connection));
        const MYSQL_ROW row = result != nullptr ? mysql_fetch_row(result.get()) : nullptr;
        if (row != nullptr && row[0] != nullptr)
            total += std::strtoull(row[0], nullptr, 10);
    }
    return total;
}

Result<Content> readTables(MYSQL* connection, const std::string& where, const ImportProgress& progress) {
    std::vector<TableReader> readers;
    readers.reserve(tables().size());
    for (const Table& table : tables()) {
        readers.emplace_back(connection, table, where);
        if (Result<void> prepared = readers.back().prepare(); !prepared)
            return Failure(prepared.error());
    }
    const Result<std::size_t> total = countRows(connection, where);
    if (!total)
        return Failure(total.error());
    constexpr std::size_t kRowsOfAStep = 4096;
    ContentBuilder builder;
    std::size_t done = 0;
    for (std::size_t i = 0; i < readers.size(); ++i) {
        const Result<void> read = readers[i].read([&](std::span<const Value> row) -> Result<void> {
            if (++done % kRowsOfAStep == 0 && progress && !progress(std::min(done, *total), *total))
                return fail(ErrorCode::Unreadable, where, "the import was cancelled");
            Result<void> added = builder.add(tables()[i], row);
            if (!added)
                added.error().where = where;
            return added;
        });
        if (!read)
            return Failure(read.error());
    }
    return builder.finish();
}

} // namespace

Result<Content> importServer(const ServerAccess& access, const ImportProgress& progress) {
    const Result<ServerUrl> url = parseServerUrl(access.url);
    if (!url)
        return Failure(url.error());
    const std::string where = printable(access.url);
    const Result<Connection> connection = connect(access, *url, where);
    if (!connection)
        return Failure(connection.error());
    MYSQL* const c = connection->get();
    if (Result<void> begun = run(c, "START TRANSACTION WITH CONSISTENT SNAPSHOT, READ ONLY", where); !begun)
        return Failure(begun.error());
    Result<Content> content = readTables(c, where, progress);
    if (content && content->templates.empty() && content->landblocks.empty())
        return fail(ErrorCode::NotFound, where, "the database has no placed objects and no templates");
    return content;
}

} // namespace limen::placements
