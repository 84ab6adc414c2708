#pragma once

#include "geometry/Bounds.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Plane.h"
#include "worlds/BuiltInWorld.h"

#include <algorithm>
#include <map>

// Access to the built-in world's records, independent of the engine's readers.
namespace limen::worlds::test {

inline const WorldRecords& world() {
    static const WorldRecords records = buildBuiltInWorld(Pictures::Blank);
    return records;
}

inline Vec3 apply(const dat::Frame& frame, const Vec3& p) {
    return Vec3(frame.origin) + glm::dquat(frame.orientation) * p;
}

inline std::vector<Vec3> pointsOf(const dat::VertexArray& array, const dat::Polygon& polygon,
                                  const dat::Frame& frame) {
    std::vector<Vec3> out;
    for (const std::uint16_t key : polygon.vertexKeys)
        out.push_back(apply(frame, Vec3(array.vertices.at(key).second.position)));
    return out;
}

inline const dat::CellStruct& shapeOf(const dat::EnvCell& cell) {
    for (const dat::Environment& e : world().environments)
        if ((e.id & 0xFFFF) == cell.environment)
            return e.cells.at(cell.cellStructure).second;
    std::abort();
}

inline std::vector<Vec3> portalPoints(const dat::EnvCell& cell, std::size_t portal) {
    const dat::CellStruct& shape = shapeOf(cell);
    for (const auto& [id, polygon] : shape.polygons)
        if (id == cell.portals.at(portal).polygonId)
            return pointsOf(shape.vertexArray, polygon, cell.position);
    return {};
}

inline const dat::EnvCell* findCell(std::uint32_t id) {
    for (const dat::EnvCell& cell : world().envCells)
        if (cell.id == id)
            return &cell;
    return nullptr;
}

inline Aabb boundsOf(const dat::EnvCell& cell) {
    Aabb box;
    for (const auto& [key, vertex] : shapeOf(cell).vertexArray.vertices)
        box.include(apply(cell.position, Vec3(vertex.position)));
    return box;
}

/// docs/formats/cells.md#point-in-cell.
inline bool contains(const dat::EnvCell& cell, const Vec3& blockPoint) {
    const Vec3 p =
        glm::conjugate(glm::dquat(cell.position.orientation)) * (blockPoint - Vec3(cell.position.origin));
    const dat::BspTree& tree = shapeOf(cell).cellBsp;
    std::size_t node = 0;
    while (tree.nodes.at(node).tag != dat::BspTag::Leaf) {
        const dat::BspNode& n = tree.nodes[node];
        if (glm::dot(Vec3(n.plane.n), p) + static_cast<double>(n.plane.d) < -0.0002)
            return false;
        if (n.positive < 0)
            return true;
        node = static_cast<std::size_t>(n.positive);
    }
    return true;
}

/// The largest distance from a corner of either polygon to the nearest corner of the other.
inline double mismatch(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    const auto oneWay = [](const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
        double worst = 0.0;
        for (const Vec3& p : from) {
            double nearest = 1e300;
            for (const Vec3& q : to)
                nearest = std::min(nearest, glm::length(p - q));
            worst = std::max(worst, nearest);
        }
        return worst;
    };
    return a.empty() || b.empty() ? 1e300 : std::max(oneWay(a, b), oneWay(b, a));
}

} // namespace limen::worlds::test
