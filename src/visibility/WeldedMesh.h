#pragma once

#include "visibility/SpaceMesh.h"

#include <utility>
#include <vector>

namespace limen::visibility {

/// A mesh in which vertices at one place have one number: the first vertex there.
class WeldedMesh {
public:
    /// Errors: an index out of range, a vertex that is not finite, a face with fewer than three corners.
    [[nodiscard]] static Result<WeldedMesh> build(const SpaceMesh& mesh, double tolerance,
                                                  const std::string& name);

    using Edge = std::pair<std::uint32_t, std::uint32_t>; ///< from, to
    /// The edges of a face; none of length 0.
    [[nodiscard]] std::vector<Edge> edgesOf(const MeshFace& face) const;
    [[nodiscard]] const SpaceMesh& mesh() const { return mesh_; }
    [[nodiscard]] const Vec3& at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }

private:
    SpaceMesh mesh_;
    std::vector<std::uint32_t> first_; ///< by vertex
};

/// Removes each pair of edges that run between the same vertices in opposite directions.
void cancelOpposites(std::vector<WeldedMesh::Edge>& edges);

} // namespace limen::visibility
