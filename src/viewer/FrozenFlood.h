#pragma once

#include "viewer/PortalTraces.h"
#include "visibility/VisibleSet.h"

#include <vector>

namespace limen::viewer {

/// A flood that is kept, to be looked at from elsewhere.
struct FrozenFlood {
    visibility::View view;
    visibility::VisibleSet visible;
    std::vector<PortalTrace> portals; ///< what became of each that it came to
};

/// A line of a visit's pyramid in a picture, in NDC; it may leave the picture.
struct PyramidLine {
    Vec2 from{0.0}, to{0.0};
    std::uint32_t visit = 0;
};

/// The pyramids of rays that visits are made of, seen by another eye: each region's outline where its rays come in, their edges from
/// there on for so many metres, and the outline there. What lies behind that eye is cut off.
[[nodiscard]] std::vector<PyramidLine> pyramidLines(const FrozenFlood& flood, const visibility::View& eye,
                                                    double metres);

} // namespace limen::viewer
