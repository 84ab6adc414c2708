#pragma once

#include "core/Error.h"
#include "geometry/Vec.h"
#include "visibility/Graph.h"

#include <cstdint>
#include <span>

namespace limen::visibility {

/// A face of a mesh: a run of corners.
struct MeshFace {
    std::uint32_t firstCorner = 0, cornerCount = 0;
    std::uint32_t opening = kNone; ///< kNone: a wall. Faces with the same number are one opening of the mesh
};

/// The surface of a space, with its openings as faces. The arrays are the caller's. Walls may be non-convex polygons.
struct SpaceMesh {
    std::span<const Vec3> vertices;         ///< metres
    std::span<const std::uint32_t> corners; ///< indices into `vertices`
    std::span<const MeshFace> faces;        ///< counter-clockwise seen from inside the space
};

/// Checks that a mesh bounds a space: each edge of a face, between vertices at most `tolerance` metres apart from their
/// copies, is also an edge of another face in the other direction, and the faces look inwards. `name` is its place in
/// messages. Errors: BadArgument for an index out of range, a vertex that is not finite, a face with fewer than three
/// corners, an open edge, a mesh that is inside out or has no volume.
[[nodiscard]] LIMEN_API Result<void> checkClosed(const SpaceMesh& mesh, double tolerance,
                                                 const std::string& name);

} // namespace limen::visibility
