#pragma once

#include "placements/ContentBuilder.h"
#include "placements/sql/Tokens.h"

namespace limen::placements {

/// Executes the statements of a text of SQL on a ContentBuilder: INSERT with VALUES, and DELETE with one
/// comparison, on the tables of Tables.h. All other statements, and those on other tables, are skipped.
/// Errors, each with the name of the text and a line: SQL that is not understood in a statement on these tables;
/// UPDATE, REPLACE, TRUNCATE and other DELETE on them; the text ends within a statement; those of the builder and
/// of Tokens.
[[nodiscard]] Result<void> executeSql(Tokens& tokens, ContentBuilder& builder);

} // namespace limen::placements
