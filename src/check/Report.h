#pragma once

#include "check/Totals.h"
#include "core/Error.h"

#include <string>

namespace limen::check {

/// What the report says beside the totals.
struct ReportContext {
    std::uint64_t seed = 1;
    std::string
        worldOptions; ///< of `limen shot`, in front of the view's: "", " --dat 'DIR'", " --zones cells"
};

/// The whole command that draws a view again and writes its ids.
[[nodiscard]] std::string shotCommand(const View& view, const std::string& worldOptions);

/// The result as one JSON object in one line (src/check/README.md#verdicts). disagreeing_pixels are those whose id the rule
/// forbids; void_pixels those of them that were drawn as void.
[[nodiscard]] std::string reportJson(const Totals& totals, const ReportContext& context);

/// The result in a few lines for people.
[[nodiscard]] std::string reportText(const Totals& totals, const ReportContext& context);

/// How far a run has come, so that a stopped one continues.
struct Progress {
    std::string run;         ///< what was asked for; a state is only good for the same
    std::uint64_t tasks = 0; ///< block tasks that are done
    std::uint64_t views = 0; ///< views that are done in the next one
    Totals totals;
};
[[nodiscard]] std::string progressJson(const Progress& progress);
/// Errors: not such a text; numbers that make no sense.
[[nodiscard]] Result<Progress> parseProgress(const std::string& text);

} // namespace limen::check
