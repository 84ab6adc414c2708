#pragma once

#include "check/Totals.h"
#include "output/report/ReportHead.h"

namespace limen::output {

/// One view of a check, with its pictures.
struct CheckedView {
    std::uint64_t number = 0; ///< of the view, in the order of the run
    std::string kind, about;
    std::string command; ///< draws it again
    std::array<std::uint64_t, check::kVerdictCount> counts{};
    std::uint64_t moved = 0;
    std::vector<ReportPicture> pictures; ///< drawn, traced, verdicts
};

/// A check as data.
struct CheckReport {
    ReportHead head;
    check::Totals totals;
    std::vector<CheckedView> findings; ///< most wrong pixels first
    std::vector<CheckedView> samples;  ///< views without a finding
};

/// The report as one HTML page without references to other files.
[[nodiscard]] std::string checkPage(const CheckReport& report);

} // namespace limen::output
