#pragma once

#include "core/Error.h"

#include <cstdint>
#include <span>
#include <string_view>

// The tables of the community's world database that Limen reads, and their columns. The readers of SQL files
// and of a database server share them, so that equal rows give equal content.
namespace limen::placements {

/// One value of a row, as its source gives it.
struct Value {
    enum class Kind : std::uint8_t { Null, Integer, Real, Text, Unknown };
    Kind kind = Kind::Null;
    std::int64_t integer = 0; ///< of Integer
    double real = 0.0;        ///< of Real
    std::string_view text;    ///< of Text; valid until the reader goes to the next row
};

enum class ColumnType : std::uint8_t {
    Unread,
    Signed8,
    Unsigned8,
    Unsigned16,
    Signed32,
    Unsigned32,
    Float,
    Double,
    Bit,
    Text
};

struct Column {
    std::string_view name;
    ColumnType type = ColumnType::Unread;
    bool mayBeNull = false;
};

enum class TableKey : std::uint8_t {
    Weenie,
    Int,
    Bool,
    Float,
    String,
    DataId,
    Palette,
    TextureMap,
    AnimPart,
    CreateList,
    Position,
    Generator,
    Instance,
    InstanceLink
};

/// A table. Its columns have the order of the schema, without generated columns: a row without a list of
/// columns has values for all of them.
struct Table {
    TableKey key = TableKey::Weenie;
    std::string_view name;
    std::span<const Column> columns;
    std::string_view order; ///< the column by which a server sorts the rows
};

/// All tables, each after those that its rows refer to.
[[nodiscard]] std::span<const Table> tables();
/// Letter case does not matter. Null: Limen does not read the table.
[[nodiscard]] const Table* findTable(std::string_view name);
/// Index into table.columns; npos: no such column.
[[nodiscard]] std::size_t findColumn(const Table& table, std::string_view name);
inline constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

/// A value in its column's range: an Integer for integers and bits, a Real for floats (rounded to single
/// precision for Float; never -0), a Text, or Null. Errors: the value does not fit; `where` of the error is
/// empty.
[[nodiscard]] Result<Value> fitted(const Table& table, const Column& column, const Value& value);

/// True if two names of SQL are equal; letter case does not matter.
[[nodiscard]] bool isSameName(std::string_view a, std::string_view b);

} // namespace limen::placements
