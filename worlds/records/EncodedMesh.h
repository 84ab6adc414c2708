#pragma once

#include "dat/records/Mesh.h"
#include "worlds/records/FaceMesh.h"

namespace limen::worlds {

/// A mesh as a record stores it. Face i has polygon id i.
struct EncodedMesh {
    dat::VertexArray vertexArray;
    dat::PolygonList polygons;
    std::vector<dat::RecordId> surfaces;
};
/// Requires fewer than 32768 distinct vertices and faces.
[[nodiscard]] EncodedMesh encodeMesh(const std::vector<Face>& faces);

/// The physics polygons of a mesh: all but portals, foliage, flames and glass. They keep the drawing
/// polygons' ids.
struct PhysicsMesh {
    dat::PolygonList polygons;
    dat::BspTree tree;
};
[[nodiscard]] PhysicsMesh physicsOf(const std::vector<Face>& faces, const dat::PolygonList& polygons);

} // namespace limen::worlds
