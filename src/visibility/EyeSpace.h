#pragma once

#include "visibility/Graph.h"

namespace limen::visibility {

/// The space in which the rays of an eye begin: `root`, or the space behind an opening that the eye has just passed.
/// That is an opening of the root whose plane is at least Portal::inPlane and at most kInPlaneTolerance before the eye
/// (metres), and that the eye is inside; open or shut. The search is repeated from there, a few times at most.
[[nodiscard]] std::uint32_t spaceOfEye(const Graph& graph, const Vec3& eye, std::uint32_t root);

/// Whether the eye is before or behind no other opening between the same two spaces that is nearer to it. Of openings that
/// meet at a sharp edge, as the parts of a bent one do, the nearest tells the side of the eye.
[[nodiscard]] bool isNearestOpening(const Graph& graph, std::uint32_t portal, const Vec3& eye);

/// Whether the eye is in the portal's plane and inside the opening. `way`: 1 for rays out of its space, -1 for rays into it.
[[nodiscard]] bool holdsEye(const Graph& graph, const Graph::Portal& portal, const Vec3& eye, double way);

/// Whether rays out of the portal's space leave by it at the eye, if they point outwards: the eye is in its plane, or has passed it.
[[nodiscard]] bool isLeftAtEye(const Graph& graph, std::uint32_t portal, const Vec3& eye);

} // namespace limen::visibility
