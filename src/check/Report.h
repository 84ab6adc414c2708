#pragma once

#include "check/Totals.h"
#include "core/Error.h"

#include <string>

namespace limen::check {

/// The inputs of a report beside the totals.
struct ReportContext {
    std::uint64_t seed = 1;
    /// Options of `limen shot` in front of the view's: "", " --dat 'DIR'", " --zones cells".
    std::string worldOptions;
};

/// The command that draws a view again and writes its ids.
[[nodiscard]] std::string shotCommand(const View& view, const std::string& worldOptions);

/// The result as one JSON object in one line (src/check/README.md). disagreeing_pixels counts ids that the rule
/// forbids; void_pixels counts those of them that were drawn as void.
[[nodiscard]] std::string reportJson(const Totals& totals, const ReportContext& context);

/// The result as a table and a few lines of text.
[[nodiscard]] std::string reportText(const Totals& totals, const ReportContext& context);

/// The progress of a run, from which a stopped run continues.
struct Progress {
    std::string run;         ///< the run's options; a state fits only a run with equal options
    std::uint64_t tasks = 0; ///< finished block tasks
    std::uint64_t views = 0; ///< finished views of the next task
    Totals totals;
};
[[nodiscard]] std::string progressJson(const Progress& progress);
/// Errors: the text is no state of a run, or of another version.
[[nodiscard]] Result<Progress> parseProgress(const std::string& text);

} // namespace limen::check
