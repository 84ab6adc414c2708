#include "visibility/WeldedMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace limen::visibility {

namespace {

/// Finds earlier vertices by the cell of a grid, and its neighbours.
class Welder {
public:
    Welder(std::span<const Vec3> vertices, double tolerance)
        : vertices_(vertices), tolerance_(tolerance), cell_(std::max(2.0 * tolerance, 1e-9)) {}

    std::uint32_t firstAt(std::uint32_t vertex) {
        const Vec3 place = glm::floor(vertices_[vertex] / cell_);
        for (int i = 0; i < 27; ++i) {
            const Vec3 step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (const auto found = kept_.find(keyOf(place + step)); found != kept_.end())
                for (const std::uint32_t other : found->second)
                    if (glm::length(vertices_[other] - vertices_[vertex]) <= tolerance_)
                        return other;
        }
        kept_[keyOf(place)].push_back(vertex);
        return vertex;
    }

private:
    using Key = std::array<double, 3>;
    static Key keyOf(const Vec3& cell) { return {cell.x, cell.y, cell.z}; }
    std::span<const Vec3> vertices_;
    double tolerance_, cell_;
    std::map<Key, std::vector<std::uint32_t>> kept_;
};

Result<void> checkIndices(const SpaceMesh& mesh, const std::string& name) {
    const auto refuse = [&](std::string why) { return fail(ErrorCode::BadArgument, name, std::move(why)); };
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const MeshFace& face = mesh.faces[f];
        if (face.firstCorner > mesh.corners.size() ||
            face.cornerCount > mesh.corners.size() - face.firstCorner)
            return refuse("face " + std::to_string(f) + " has corners outside the array");
        if (face.cornerCount < 3)
            return refuse("face " + std::to_string(f) + " has fewer than three corners");
    }
    for (const std::uint32_t corner : mesh.corners)
        if (corner >= mesh.vertices.size())
            return refuse("a corner names vertex " + std::to_string(corner) + " of " +
                          std::to_string(mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (!isFinite(mesh.vertices[v]))
            return refuse("vertex " + std::to_string(v) + " is not finite");
    return {};
}

std::string textOf(const Vec3& place) {
    return "(" + std::to_string(place.x) + ", " + std::to_string(place.y) + ", " + std::to_string(place.z) +
           ")";
}

/// Six times the volume inside, with faces that look outwards.
double sixVolumes(const SpaceMesh& mesh) {
    double sum = 0.0;
    const Vec3 origin = mesh.vertices[mesh.corners.front()];
    for (const MeshFace& face : mesh.faces) {
        const auto corner = [&](std::uint32_t i) {
            return mesh.vertices[mesh.corners[face.firstCorner + i]] - origin;
        };
        for (std::uint32_t i = 2; i < face.cornerCount; ++i)
            sum += glm::dot(corner(0), glm::cross(corner(i - 1), corner(i)));
    }
    return sum;
}

} // namespace

Result<WeldedMesh> WeldedMesh::build(const SpaceMesh& mesh, double tolerance, const std::string& name) {
    if (Result<void> checked = checkIndices(mesh, name); !checked)
        return Failure(checked.error());
    WeldedMesh welded;
    welded.mesh_ = mesh;
    Welder welder(mesh.vertices, tolerance);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v)
        welded.first_.push_back(welder.firstAt(v));
    return welded;
}

std::vector<WeldedMesh::Edge> WeldedMesh::edgesOf(const MeshFace& face) const {
    std::vector<Edge> edges;
    for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
        const auto corner = [&](std::uint32_t at) { return first_[mesh_.corners[face.firstCorner + at]]; };
        const Edge edge(corner(i), corner(i + 1 == face.cornerCount ? 0 : i + 1));
        if (edge.first != edge.second)
            edges.push_back(edge);
    }
    return edges;
}

void cancelOpposites(std::vector<WeldedMesh::Edge>& edges) {
    std::map<WeldedMesh::Edge, int> surplus; ///< by edge from the lower vertex: forwards less backwards
    for (const auto& [from, to] : edges)
        surplus[std::minmax(from, to)] += from < to ? 1 : -1;
    std::erase_if(edges, [&](const WeldedMesh::Edge& edge) {
        int& left = surplus[std::minmax(edge.first, edge.second)];
        const int way = edge.first < edge.second ? 1 : -1;
        if (left * way <= 0)
            return true;
        left -= way;
        return false;
    });
}

Result<void> checkClosed(const SpaceMesh& mesh, double tolerance, const std::string& name) {
    const Result<WeldedMesh> welded = WeldedMesh::build(mesh, tolerance, name);
    if (!welded)
        return Failure(welded.error());
    const auto refuse = [&](std::string why) { return fail(ErrorCode::BadArgument, name, std::move(why)); };
    std::vector<WeldedMesh::Edge> edges;
    for (const MeshFace& face : mesh.faces) {
        const std::vector<WeldedMesh::Edge> more = welded->edgesOf(face);
        edges.insert(edges.end(), more.begin(), more.end());
    }
    if (edges.empty())
        return refuse("the mesh has no faces");
    cancelOpposites(edges);
    if (!edges.empty())
        return refuse("the mesh is not closed: the edge from " + textOf(welded->at(edges.front().first)) +
                      " to " + textOf(welded->at(edges.front().second)) + " belongs to one face only");
    const double volume = sixVolumes(mesh);
    if (volume > 0.0)
        return refuse(
            "the mesh is inside out: list the corners of a face counter-clockwise as seen from inside");
    if (!(volume < 0.0))
        return refuse("the mesh has no volume");
    return {};
}

} // namespace limen::visibility
