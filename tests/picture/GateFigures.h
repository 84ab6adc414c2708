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
    std::filesystem::path file; ///< one JSON object a view is appended

    /// From LIMEN_MEASURED_GATE and LIMEN_GATE_FIGURES; none if one of them is not set.
    [[nodiscard]] static std::optional<GateFigures> fromEnvironment();
    /// `milliseconds`: of drawing the picture and reading it.
    void add(const world::World& world, const Picture& picture, const check::Comparison& comparison,
             double milliseconds) const;
};

} // namespace limen::test
