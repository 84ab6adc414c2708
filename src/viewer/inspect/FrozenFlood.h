#pragma once

#include "viewer/inspect/PortalTraces.h"
#include "visibility/VisibleSet.h"

#include <vector>

namespace limen::viewer {

/// A frozen flood, for inspection from other viewpoints.
struct FrozenFlood {
    visibility::View view;
    visibility::VisibleSet visible;
    std::vector<PortalTrace> portals; ///< the fate of each portal that the flood tested
};

/// An edge of a visit's pyramid in NDC. It can extend beyond the picture.
struct PyramidLine {
    Vec2 from{0.0}, to{0.0};
    std::uint32_t visit = 0;
};

/// The ray pyramids of all visits, projected for another eye. A pyramid consists of the region's outline at
/// the entry plane, edges of length `metres`, and the outline at their ends. Parts behind that eye are
/// clipped.
[[nodiscard]] std::vector<PyramidLine> pyramidLines(const FrozenFlood& flood, const visibility::View& eye,
                                                    double metres);

} // namespace limen::viewer
