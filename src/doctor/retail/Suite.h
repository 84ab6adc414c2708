#pragma once

#include "doctor/Releases.h"
#include "doctor/retail/Census.h"
#include "doctor/retail/Ledger.h"

// The acceptance suite for the original files, `limen dat verify --retail`.
namespace limen::doctor {

struct SuiteResult {
    Ledger ledger;
    Release release = Release::Unknown; ///< of portal and cell file
};

/// Judges all facts. Errors: the index of a file is damaged.
[[nodiscard]] Result<SuiteResult> runSuite(const dat::Archive& archive, const CensusProgress& progress = {});

/// Lines of one area.
struct AreaSum {
    std::string_view area; ///< points into the ledger
    std::size_t right = 0, wrong = 0, notThere = 0;
};
[[nodiscard]] std::vector<AreaSum> sumsOf(const Ledger& ledger);

/// The report as JSON. It holds ids of facts, expected numbers, verdicts, found numbers where the verdict is "wrong",
/// and the program's version: no path, no name, no bytes of the files.
[[nodiscard]] std::string reportJson(const SuiteResult& result, const std::string& program);
inline constexpr int kReportVersion = 1;

/// The report for people: a table of the areas, then the lines that are not right (at most `most`), then a summary.
/// `all`: the right lines, too.
[[nodiscard]] std::string reportText(const SuiteResult& result, std::size_t most, bool all);

} // namespace limen::doctor
