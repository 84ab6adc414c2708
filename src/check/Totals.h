#pragma once

#include "check/Comparison.h"
#include "check/View.h"

#include <array>
#include <cstdint>
#include <vector>

namespace limen::check {

/// Sums over the views of one kind.
struct KindTotals {
    std::uint64_t views = 0, pixels = 0;
    std::array<std::uint64_t, kVerdictCount> counts{}; ///< pixels by verdict
    std::uint64_t moved = 0; ///< pixels that changed between two pictures of one view

    [[nodiscard]] std::uint64_t count(Verdict verdict) const {
        return counts[static_cast<std::size_t>(verdict)];
    }
    /// Pixels whose id the rule forbids: edge-on ones and voids among them.
    [[nodiscard]] std::uint64_t disagreeing() const;
    /// Everything that makes the check fail.
    [[nodiscard]] std::uint64_t findings() const;
    void add(const KindTotals& other);
};

/// A view with findings.
struct Finding {
    View view;
    std::uint64_t count = 0;  ///< pixels
    std::uint64_t number = 0; ///< of the view, in the order of the run
    std::array<std::uint64_t, kVerdictCount> counts{};
    std::uint64_t moved = 0;

    /// Pixels of it that are not the rasteriser's edge-on ones.
    [[nodiscard]] std::uint64_t grave() const {
        return count - counts[static_cast<std::size_t>(Verdict::EdgeOn)];
    }
};

/// What a run has found.
struct Totals {
    static constexpr std::size_t kWorst = 50;

    std::array<KindTotals, kKindCount> kinds;
    std::vector<Finding>
        worst; ///< at most kWorst: most grave pixels first, then most pixels, then the earlier view
    std::uint64_t viewsWithFindings = 0;
    std::uint64_t blocksLeftOut = 0; ///< that could not be loaded
    std::uint64_t pictures =
        0; ///< of all that was drawn, ids, depth, layers and colour: equal runs have the same
    double drawSeconds = 0.0;  ///< of them with drawing and reading back
    double traceSeconds = 0.0; ///< of them with tracing and comparing, while others are drawn
    double seconds = 0.0;      ///< spent on it, over all parts of a resumed run

    /// Adds one view. `moved`: of a view that was drawn twice. `picture`: a hash of what was drawn.
    void add(const View& view, std::uint64_t number, const Comparison& comparison, std::uint64_t moved,
             std::uint64_t picture = 0);
    [[nodiscard]] KindTotals sum() const;
};

} // namespace limen::check
