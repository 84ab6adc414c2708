#pragma once

#include "geometry/Vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace limen::frame {

/// The clip planes of a region on the screen: lines in homogeneous (x, y, w), as visibility/View.h. A point is
/// inside where dot(line, (x, y, w)) >= 0 for all of them.
struct ScreenPlanes {
    static constexpr std::size_t kMost = 8; ///< clip distances that every driver has
    std::array<Vec3, kMost> lines{};        ///< unit length
    std::uint32_t count = 0;                ///< 0: the whole picture
    bool isRectangle =
        false; ///< the region has too many edges: the lines are those of its bounding rectangle
};

/// Picture size in pixels.
struct ScreenSize {
    std::uint32_t width = 1, height = 1;
};

/// The planes of a convex region: a polygon of (x, y, w) vertices, counter-clockwise, w >= 0. Edges along the
/// picture's border have no plane. While there are more than ScreenPlanes::kMost edges, an edge is removed whose
/// neighbours meet at most one pixel beyond it. If none is left to remove, the region is replaced by its bounding
/// rectangle. All planes are moved outwards by kSnapTolerance. So the result contains the region.
[[nodiscard]] ScreenPlanes screenPlanes(std::span<const Vec3> region, ScreenSize size);

} // namespace limen::frame
