#pragma once

#include "geometry/Vec.h"

#include <cstdint>

namespace limen::visibility {

/// An eye and its perspective. Screen space of this room is homogeneous (x, y, w): right and up scaled so
/// that the screen is |x| <= w, |y| <= w, and w the distance forward in metres. There is no near plane.
struct View {
    Vec3 eye{0.0};                                      ///< in the graph's frame
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< orthonormal
    double tanHalfX = 1.0, tanHalfY = 1.0;              ///< tangents of half the field of view, > 0
    std::uint32_t root = 0;                             ///< the space the eye is in

    /// Rows that take an eye-relative point to (x, y, w); the columns of its transpose are the planes'
    /// normals.
    [[nodiscard]] Mat3 screenFromEye() const;
};

/// Parts of the method. All are needed: each has a view that goes wrong without it (docs/proof.md), and tests switch
/// them off one by one to show that they would notice.
struct Rules {
    bool eyePlaneClip = true; ///< off: openings are cut at 2 cm before the eye, as by a near plane
    bool halfPlane = true;    ///< off: an opening in whose plane the eye lies is seen edge-on, so not at all
    bool siblingOrder = true; ///< off: openings of one visit are painted in the order they are listed
};

/// Bounds that the caller sets on one flood.
struct Limits {
    std::uint32_t maxVisits =
        4096; ///< when more would be needed, those with the smallest regions are left out
    Rules rules{};
};

} // namespace limen::visibility
