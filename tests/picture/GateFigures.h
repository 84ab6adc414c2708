#pragma once

#include "picture/PictureWorld.h"

#include "check/Comparison.h"
#include "frame/Gate.h"

#include <filesystem>
#include <optional>

namespace limen::test {

/// Measures a gate on the views of tests, for the table of docs/gates.md (tools/gates-by-case). The tests then draw
/// with that gate, and wrong pixels are written down instead of failing.
struct GateFigures {
    frame::Gate gate = frame::Gate::Ownership;
    std::filesystem::path file;                        ///< one JSON object a view is appended
    std::filesystem::path pictures;                    ///< a directory, or empty: writePair
    std::size_t secondLooks = check::kMostSecondLooks; ///< of the judge in each view

    /// From LIMEN_MEASURED_GATE, LIMEN_GATE_FIGURES, LIMEN_GATE_PICTURES and LIMEN_GATE_SECOND_LOOKS; none if one of
    /// the first two is not set.
    [[nodiscard]] static std::optional<GateFigures> fromEnvironment();
    /// `milliseconds`: of drawing the picture and reading it.
    void add(const world::World& world, const Picture& picture, const check::Comparison& comparison,
             double milliseconds) const;
    /// Whether writePair is to be called: pictures are wanted, and no view of the test before had as many wrong
    /// pixels.
    [[nodiscard]] bool wantsPair(const check::Comparison& comparison) const;
    /// Writes two lit pictures of one size side by side, `right` and the gate's, to TEST-GATE.png.
    void writePair(const Picture& right, const Picture& gated) const;
};

} // namespace limen::test
