#pragma once

#include "visibility/Flood.h"

#include <vector>

namespace limen::visibility {

/// Collects spaces and openings for a Graph, in any order.
class TestGraph {
public:
    std::uint32_t addSpace(std::uint32_t zone);
    /// A space in a zone of its own.
    std::uint32_t addSpace();
    /// An opening from `from` to `to` and back. `polygon` is counter-clockwise seen from inside `from`.
    void link(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon);
    void linkOneWay(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon);
    /// A pair whose two polygons differ; `back` is counter-clockwise seen from inside `to`.
    void linkInexact(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon,
                     const std::vector<Vec3>& back);
    [[nodiscard]] Graph build() const;

private:
    struct Opening {
        std::uint32_t space = 0, destination = 0;
        int pair = -1; ///< index of the reciprocal in openings_
        std::vector<Vec3> polygon;
        bool exact = true;
    };
    std::vector<std::uint32_t> zones_;
    std::vector<Opening> openings_;
};

/// An upright rectangle of the given width and height around `centre`, counter-clockwise seen from the side
/// that `towardsViewer` (horizontal) points to.
[[nodiscard]] std::vector<Vec3> uprightRectangle(const Vec3& centre, const Vec3& towardsViewer, double width,
                                                 double height);

/// A view from `eye` in compass direction `yaw` (degrees, 0 = +y, 90 = +x) and `pitch`, 90 degrees wide and
/// high.
[[nodiscard]] View viewFrom(const Vec3& eye, double yaw, double pitch, std::uint32_t root);

/// The last visit in drawing order whose region contains the direction, in (x, y, w).
[[nodiscard]] std::uint32_t ownerOf(const VisibleSet& set, const Vec3& direction);

/// The spaces of a visit's chain, root first.
[[nodiscard]] std::vector<std::uint32_t> chainOf(const VisibleSet& set, std::uint32_t visit);

/// One flood with new buffers. Aborts if the flood refuses the view.
[[nodiscard]] VisibleSet floodOnce(const Graph& graph, const View& view, const Limits& limits = {},
                                   std::span<const std::uint8_t> closed = {});

} // namespace limen::visibility
