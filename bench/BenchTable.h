#pragma once

#include "BenchRow.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

namespace limen::bench {

/// How many times better the value is than the best of what it is measured against; nothing without any.
[[nodiscard]] std::optional<double> ratioOf(const BenchRow& row);

/// True if the row has no target or reaches it.
[[nodiscard]] bool isMet(const BenchRow& row);

/// The rows as a table for people, one line each under a heading.
[[nodiscard]] std::string benchTable(std::span<const BenchRow> rows);

/// One row as docs/performance.md describes it.
[[nodiscard]] nlohmann::ordered_json benchJson(const BenchRow& row);

} // namespace limen::bench
