#include "doctor/Finding.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::doctor {
namespace {

constexpr std::size_t kCheckWidth = 16, kOutcomeWidth = 10;
constexpr std::size_t kTextAt = kCheckWidth + 1 + kOutcomeWidth + 1;
constexpr std::size_t kLeastTextWidth = 20;

std::size_t countOf(const Findings& findings, Outcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(findings.begin(), findings.end(),
                      [&](const Finding& finding) { return finding.outcome == outcome; }));
}

/// The text in lines of at most `width` bytes. Breaks at blanks; longer words (paths) are cut.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
    std::vector<std::string> lines;
    while (text.size() > width) {
        std::size_t end = text.rfind(' ', width);
        const bool atBlank = end != std::string_view::npos && end > 0;
        if (!atBlank)
            end = width;
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end + (atBlank ? 1 : 0));
    }
    lines.emplace_back(text);
    return lines;
}

std::string rowOf(const Finding& finding, std::size_t width) {
    const std::size_t textWidth = std::max(width, kTextAt + kLeastTextWidth) - kTextAt;
    std::vector<std::string> lines = wrapped(finding.text, textWidth);
    if (!finding.next.empty())
        for (std::string& line : wrapped("Next: " + finding.next, textWidth))
            lines.push_back(std::move(line));
    std::string row;
    for (std::size_t i = 0; i < lines.size(); ++i)
        row += fmt::format("{:<{}} {:<{}} {}\n", i == 0 ? finding.check : "", kCheckWidth,
                           i == 0 ? nameOf(finding.outcome) : "", kOutcomeWidth, lines[i]);
    return row;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

} // namespace

const char* nameOf(Outcome outcome) {
    constexpr std::array<const char*, 4> kNames{"ok", "warning", "failed", "not tested"};
    return kNames.at(static_cast<std::size_t>(outcome));
}

std::string tableOf(const Findings& findings, std::size_t width) {
    std::string table;
    for (const Finding& finding : findings)
        table += rowOf(finding, width);
    return table;
}

std::string verdictOf(const Findings& findings) {
    const std::size_t failed = countOf(findings, Outcome::Failed),
                      warnings = countOf(findings, Outcome::Warning);
    const std::string rest =
        warnings > 0 ? fmt::format(", {}", counted(warnings, "warning", "warnings")) : "";
    if (failed > 0)
        return fmt::format("Not ready: {}{}.", counted(failed, "check failed", "checks failed"), rest);
    return fmt::format("Ready: Limen can run, and the files are whole{}.", rest);
}

std::string findingsJson(const Findings& findings) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Finding& finding : findings) {
        nlohmann::ordered_json row{
            {"check", finding.check}, {"result", nameOf(finding.outcome)}, {"finding", finding.text}};
        if (!finding.next.empty())
            row["next"] = finding.next;
        rows.push_back(std::move(row));
    }
    const nlohmann::ordered_json report{{"format", "limen-doctor"},
                                        {"version", 1},
                                        {"ready", isSound(findings)},
                                        {"warnings", countOf(findings, Outcome::Warning)},
                                        {"failed", countOf(findings, Outcome::Failed)},
                                        {"notTested", countOf(findings, Outcome::NotTested)},
                                        {"checks", rows}};
    return report.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

bool isSound(const Findings& findings) {
    return countOf(findings, Outcome::Failed) == 0;
}

} // namespace limen::doctor
