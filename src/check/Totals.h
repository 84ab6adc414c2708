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
    /// Pixels whose id the rule forbids, edge-on ones and voids included.
    [[nodiscard]] std::uint64_t disagreeing() const;
    /// Pixels that make the check fail.
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

    /// Findings without the rasteriser's edge-on pixels.
    [[nodiscard]] std::uint64_t grave() const {
        return count - counts[static_cast<std::size_t>(Verdict::EdgeOn)];
    }
};

/// The results of a run.
struct Totals {
    static constexpr std::size_t kWorst = 50;

    std::array<KindTotals, kKindCount> kinds;
    /// At most kWorst: most grave pixels first, then most pixels, then the earlier view.
    std::vector<Finding> worst;
    std::uint64_t viewsWithFindings = 0;
    std::uint64_t blocksLeftOut = 0; ///< blocks that failed to load
    /// A hash of all pictures: ids, depth, layers and colour. Equal runs have equal hashes.
    std::uint64_t pictures = 0;
    double drawSeconds = 0.0;  ///< drawing and reading back
    double traceSeconds = 0.0; ///< tracing and comparing, at the same time
    double seconds = 0.0;      ///< wall clock, summed over all parts of a resumed run

    /// Adds one view. `moved`: pixels that differ in a second picture. `picture`: a hash of the picture.
    void add(const View& view, std::uint64_t number, const Comparison& comparison, std::uint64_t moved,
             std::uint64_t picture = 0);
    [[nodiscard]] KindTotals sum() const;
};

} // namespace limen::check
