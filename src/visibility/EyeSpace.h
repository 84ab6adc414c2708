#pragma once

#include "visibility/Graph.h"

namespace limen::visibility {

/// The space in which the rays of an eye begin: `root`, or the space behind an opening that the eye has just passed.
/// That is an opening of the root whose plane is at least Portal::inPlane and at most kInPlaneTolerance before the eye
/// (metres), and that the eye is inside; open or shut. The search is repeated from there, a few times at most.
[[nodiscard]] std::uint32_t spaceOfEye(const Graph& graph, const Vec3& eye, std::uint32_t root);

} // namespace limen::visibility
