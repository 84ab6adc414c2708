#pragma once

#include "doctor/retail/Census.h"
#include "doctor/retail/Ledger.h"

#include <span>

namespace limen::doctor {

/// A fact about one tally of the census.
struct CountFact {
    std::string_view id; ///< without the area "count."
    std::string_view source;
    Tally tally;
    double expected;
    Tally basis; ///< if this one is 0, there is nothing to judge
    Rule rule = Rule::Equal;
    double tolerance = 0.0;
};
[[nodiscard]] std::span<const CountFact> countFacts();

} // namespace limen::doctor
