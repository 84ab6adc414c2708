#pragma once

#include "BenchRow.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

namespace limen::bench {

/// The ratio by which the value is better than the best figure it is compared with. None: there is no such
/// figure, or the ratio is not finite.
[[nodiscard]] std::optional<double> ratioOf(const BenchRow& row);

/// Whether the row reaches its target. True if it has none.
[[nodiscard]] bool isMet(const BenchRow& row);

/// The rows as a text table, one line a row below a heading.
[[nodiscard]] std::string benchTable(std::span<const BenchRow> rows);

/// One row as JSON, in the format of docs/performance.md.
[[nodiscard]] nlohmann::ordered_json benchJson(const BenchRow& row);

} // namespace limen::bench
