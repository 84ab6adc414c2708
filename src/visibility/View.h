#pragma once

#include "core/Api.h"
#include "geometry/Vec.h"

#include <cstdint>

namespace limen::visibility {

/// An eye and its perspective. Screen space in this room is homogeneous (x, y, w): x to the right and y up,
/// scaled so that the screen is |x| <= w, |y| <= w, and w the distance forward in metres. There is no near
/// plane.
struct LIMEN_API View {
    Vec3 eye{0.0};                                      ///< in the graph's frame
    Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0}; ///< orthonormal
    double tanHalfX = 1.0, tanHalfY = 1.0;              ///< tangents of half the field of view, > 0
    std::uint32_t root = 0;                             ///< the space the eye is in

    /// Transforms an eye-relative point to (x, y, w). Its transpose transforms normals of planes through the
    /// eye back.
    [[nodiscard]] Mat3 screenFromEye() const;
};

/// Parts of the method that tests can switch off. Each part is necessary: without it some view is wrong
/// (docs/proof.md), and a test shows that the check notices.
struct Rules {
    bool eyePlaneClip = true; ///< off: openings are clipped 2 cm before the eye, as by a near plane
    bool halfPlane = true;    ///< off: an opening whose plane contains the eye is edge-on and admits no ray
    bool siblingOrder = true; ///< off: openings of one visit are painted in the order they are listed
};

/// Bounds that the caller sets on one flood.
struct Limits {
    /// Beyond it, the visits with the smallest regions are left out. A level of 3,364 cells, each a zone of its own,
    /// needs up to 7,000.
    std::uint32_t maxVisits = 32768;
    Rules rules{};
};

} // namespace limen::visibility
