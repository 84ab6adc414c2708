#pragma once

#include "visibility/GraphBuilder.h"
#include "visibility/Pairing.h"
#include "visibility/SpaceMesh.h"

#include <span>
#include <vector>

namespace limen::visibility {

struct MeshGraphOptions {
    /// Metres: vertices of one mesh this near are one vertex; openings of two meshes are one opening if their corners
    /// or, for an inexact pair, their planes are this near.
    double tolerance = kPairTolerance;
    /// Adds one more space around all meshes. Openings without a partner lead there and back. false: they lead nowhere.
    bool hasOutside = false;
};

/// An opening of a mesh in the graph.
struct MeshOpening {
    std::uint32_t mesh = 0, opening = 0; ///< MeshFace::opening
    std::uint32_t portal = kNone;        ///< leads out of the space of the mesh
    std::uint32_t destination = kNone;   ///< the space behind it
    bool exact = true;                   ///< false: the other mesh has another polygon there
};

struct MeshGraph {
    Graph graph;                       ///< space i is that of mesh i, in a zone of its own
    std::uint32_t outside = kNone;     ///< the space around all; kNone without hasOutside
    std::vector<MeshOpening> openings; ///< by mesh, then by number
};

/// A graph from closed meshes with marked openings. An opening of a mesh leads to the mesh with an opening in the same
/// place that faces it. The faces of one opening may be triangles; their outline must be one flat, convex polygon.
/// Cost: linear in the faces, the square of the number of openings. Errors: those of checkClosed; BadArgument for an
/// opening whose faces have no single outline, or whose outline is no good opening (faultOfOpening).
[[nodiscard]] LIMEN_API Result<MeshGraph> graphFromMeshes(std::span<const SpaceMesh> meshes,
                                                          const MeshGraphOptions& options = {});

} // namespace limen::visibility
