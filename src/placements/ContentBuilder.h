#pragma once

#include "placements/Placements.h"
#include "placements/Tables.h"

#include <unordered_map>

namespace limen::placements {

/// Makes a Content from rows, in the order in which a database would execute them. Keys are unique and
/// references are checked as in the schema. The places of errors are empty: the reader adds its own.
class ContentBuilder {
public:
    /// Adds a row. `row`: a value for each column of the table; those of unread columns are ignored. Errors: a
    /// value that does not fit its column; a key that is there already; a template or a parent that is not
    /// there; too many rows.
    [[nodiscard]] Result<void> add(const Table& table, std::span<const Value> row);

    /// Removes the rows with this value, and all rows that refer to them. Errors: a column that Limen cannot
    /// remove by.
    [[nodiscard]] Result<void> remove(const Table& table, std::string_view column, std::int64_t value);

    /// The content of all rows, sorted. The builder is empty afterwards.
    [[nodiscard]] Content finish();

private:
    using Row = std::span<const Value>;
    [[nodiscard]] Result<void> addTemplate(Row row);
    [[nodiscard]] Result<void> addProperty(TableKey key, Template& to, Row row);
    [[nodiscard]] Result<void> addInstance(Row row);
    [[nodiscard]] Result<void> addLink(Row row);
    /// Errors: the template has a property of this table and type already.
    [[nodiscard]] Result<void> claim(TableKey table, std::uint32_t object, std::int64_t type);

    void removeTemplate(std::uint32_t id);
    void removeLandblock(std::uint32_t id);
    void removeInstance(std::uint32_t guid);

    Content content_; ///< its landblocks have unsorted placements, and no links
    std::unordered_map<std::uint32_t, std::uint32_t> landblockOf_;           ///< by guid
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> children_; ///< by parent
    /// By template: table and type of its properties.
    std::unordered_map<std::uint32_t, std::vector<std::uint64_t>> keys_;
    std::vector<Value> fitted_; ///< scratch
};

} // namespace limen::placements
