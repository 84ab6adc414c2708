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

} // namespace limen::visibility
