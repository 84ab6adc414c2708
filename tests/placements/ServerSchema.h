#pragma once

#include "placements/Tables.h"

#include <string>

namespace limen::test {

/// The type of a column on the server.
inline std::string serverType(placements::ColumnType type, std::string_view name) {
    using placements::ColumnType;
    switch (type) {
    case ColumnType::Signed8:
        return "tinyint";
    case ColumnType::Unsigned8:
        return "tinyint unsigned";
    case ColumnType::Unsigned16:
        return "smallint unsigned";
    case ColumnType::Signed32:
        return "int";
    case ColumnType::Unsigned32:
        return "int unsigned";
    case ColumnType::Float:
        return "float";
    case ColumnType::Double:
        return "double";
    case ColumnType::Bit:
        return "bit(1)";
    case ColumnType::Text:
        return name == "class_Name" ? "varchar(100)" : "text";
    case ColumnType::Unread:
        break;
    }
    if (name == "id")
        return "int unsigned";
    return name == "last_Modified" ? "datetime"
           : name == "delay"       ? "float"
           : name == "try_To_Bond" ? "bit(1)"
                                   : "int";
}

/// Statements that make the tables which Limen reads. `without`: a table or a "table.column" that is left out.
inline std::string serverSchema(const std::string& without = "") {
    std::string sql;
    for (const placements::Table& table : placements::tables()) {
        const std::string name(table.name);
        if (name == without)
            continue;
        std::string columns;
        for (const placements::Column& column : table.columns) {
            if (name + "." + std::string(column.name) == without)
                continue;
            const bool isKey = &column == &table.columns.front();
            columns += (columns.empty() ? "" : ", ") + ("`" + std::string(column.name) + "` ") +
                       serverType(column.type, column.name) +
                       (column.mayBeNull ? " NULL"
                        : isKey          ? " NOT NULL"
                                         : "") +
                       (column.name == "id" ? " AUTO_INCREMENT" : "") + (isKey ? " PRIMARY KEY" : "");
        }
        // Like the published schema: the landblock is computed, and rows refer to their templates and parents.
        if (table.key == placements::TableKey::Instance)
            columns += ", `landblock` int GENERATED ALWAYS AS ((`obj_Cell_Id` >> 16)) VIRTUAL";
        if (name.starts_with("weenie_properties") && without != "weenie")
            columns += ", FOREIGN KEY (`object_Id`) REFERENCES `weenie` (`class_Id`) ON DELETE CASCADE";
        if (table.key == placements::TableKey::InstanceLink && without != "landblock_instance")
            columns +=
                ", FOREIGN KEY (`parent_GUID`) REFERENCES `landblock_instance` (`guid`) ON DELETE CASCADE";
        sql += "CREATE TABLE `" + name + "` (" + columns + ") ENGINE=InnoDB DEFAULT CHARSET=utf8mb4;\n";
    }
    return sql;
}

} // namespace limen::test
