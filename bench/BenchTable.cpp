#include "BenchTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace limen::bench {
namespace {

/// About four significant digits, without an exponent.
std::string shortNumber(double value) {
    if (!std::isfinite(value))
        return "-";
    const double size = std::abs(value);
    if (size >= 1000.0)
        return fmt::format("{:.0f}", value);
    return size >= 10.0 ? fmt::format("{:.1f}", value) : fmt::format("{:.3f}", value);
}

std::string againstText(const BenchRow& row) {
    std::string text;
    for (const auto& [name, value] : row.against)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, shortNumber(value));
    return text;
}

using Cells = std::array<std::string, 11>;

Cells cellsOf(const BenchRow& row) {
    const std::optional<double> ratio = ratioOf(row);
    const char* met = !row.hasTarget ? "" : isMet(row) ? "yes" : "NO";
    const std::string target =
        row.hasTarget ? fmt::format("{} {}", row.lowerIsBetter ? "<=" : ">=", shortNumber(row.target)) : "";
    return {row.bench,
            row.scene,
            shortNumber(row.value),
            shortNumber(row.p95),
            row.unit,
            againstText(row),
            ratio ? fmt::format("{:.2f}x", *ratio) : "",
            target,
            met,
            fmt::format("{}", row.allocations),
            fmt::format("{:016x}", row.hash)};
}

} // namespace

BenchRow failedRow(std::string bench, std::string scene, std::string unit) {
    BenchRow row{std::move(bench), std::move(scene), kNotMeasured, kNotMeasured, std::move(unit)};
    row.hasTarget = true;
    return row;
}

std::optional<double> ratioOf(const BenchRow& row) {
    if (row.against.empty())
        return {};
    double best = row.against.front().second;
    for (const auto& [name, value] : row.against)
        best = row.lowerIsBetter ? std::min(best, value) : std::max(best, value);
    const double ratio = row.lowerIsBetter ? best / row.value : row.value / best;
    return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

bool isMet(const BenchRow& row) {
    // The comparison is such that NaN never meets a target.
    return !row.hasTarget || (row.lowerIsBetter ? row.value <= row.target : row.value >= row.target);
}

std::string benchTable(std::span<const BenchRow> rows) {
    std::vector<Cells> lines{
        {"bench", "scene", "median", "p95", "unit", "against", "ratio", "target", "met", "allocs", "hash"}};
    for (const BenchRow& row : rows)
        lines.push_back(cellsOf(row));
    std::array<std::size_t, std::tuple_size_v<Cells>> widths{};
    for (const Cells& line : lines)
        for (std::size_t c = 0; c < line.size(); ++c)
            widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const Cells& line : lines) {
        for (std::size_t c = 0; c < line.size(); ++c) {
            const bool isNumber = c == 2 || c == 3 || c == 6 || c == 9;
            text += isNumber ? fmt::format("{:>{}}  ", line[c], widths[c])
                             : fmt::format("{:<{}}  ", line[c], widths[c]);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

nlohmann::ordered_json benchJson(const BenchRow& row) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
    Json against = Json::object();
    for (const auto& [name, value] : row.against)
        against[name] = number(value);
    const std::optional<double> ratio = ratioOf(row);
    return {{"bench", row.bench},
            {"scene", row.scene},
            {"value", number(row.value)},
            {"p95", number(row.p95)},
            {"unit", row.unit},
            {"against", std::move(against)},
            {"ratio", ratio ? Json(*ratio) : Json(nullptr)},
            {"target", row.hasTarget ? Json(row.target) : Json(nullptr)},
            {"met", row.hasTarget ? Json(isMet(row)) : Json(nullptr)},
            {"allocations", row.allocations},
            {"hash", fmt::format("{:016x}", row.hash)}};
}

} // namespace limen::bench
