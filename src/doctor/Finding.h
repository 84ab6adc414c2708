#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace limen::doctor {

/// The result of one check.
enum class Outcome : std::uint8_t {
    Ok,
    Warning,  ///< works, with the stated loss
    Failed,   ///< Limen cannot run, or a file is damaged
    NotTested ///< another check failed, or there is nothing to test
};
[[nodiscard]] const char* nameOf(Outcome outcome);

/// One line of the doctor's table.
struct Finding {
    std::string check; ///< at most 16 characters
    Outcome outcome = Outcome::Ok;
    std::string text; ///< without a full stop
    std::string next; ///< the next step; empty: none
};
using Findings = std::vector<Finding>;

/// The findings as an aligned table of at most `width` columns.
[[nodiscard]] std::string tableOf(const Findings& findings, std::size_t width);
/// One line: whether Limen can run, whether the files are whole, and the numbers of warnings and failures.
[[nodiscard]] std::string verdictOf(const Findings& findings);
/// One JSON object with the findings and the verdict.
[[nodiscard]] std::string findingsJson(const Findings& findings);
/// Whether no check failed.
[[nodiscard]] bool isSound(const Findings& findings);

} // namespace limen::doctor
