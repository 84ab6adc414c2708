#pragma once

#include "core/Error.h"
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

/// A view by its eye and its target.
struct LookAt {
    Vec3 eye{0.0}, target{0.0, 1.0, 0.0}; ///< in the graph's frame; the eye looks at the target
    Vec3 up{0.0, 0.0, 1.0};               ///< any length; not parallel to the line from eye to target
    double heightDegrees = 60.0;          ///< the vertical field of view, more than 0 and less than 180
    double aspect = 16.0 / 9.0;           ///< width by height of the picture, > 0
    std::uint32_t root = 0;               ///< the space the eye is in
};

/// The view with orthonormal axes. Errors: BadArgument for numbers that are not finite, a target in the eye, `up` parallel to
/// the line from eye to target, an angle or an aspect out of range.
[[nodiscard]] LIMEN_API Result<View> viewOf(const LookAt& look);

/// Parts of the method that tests can switch off. Each part is necessary: without it some view is wrong (docs/proof.md).
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
