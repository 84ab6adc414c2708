#include "worlds/Shell.h"

namespace limen::worlds::test {

double windingAround(const dat::EnvCell& cell, const Vec3& point) {
    const dat::CellStruct& shape = shapeOf(cell);
    double angle = 0.0;
    for (const auto& [id, polygon] : shape.polygons) {
        const std::vector<Vec3> p = pointsOf(shape.vertexArray, polygon, cell.position);
        for (std::size_t k = 1; k + 1 < p.size(); ++k) {
            const Vec3 a = glm::normalize(p[0] - point);
            const Vec3 b = glm::normalize(p[k] - point);
            const Vec3 c = glm::normalize(p[k + 1] - point);
            angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                      1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
        }
    }
    return -angle / 12.566370614359172; // polygons look inwards
}

double distanceToPlanes(const dat::EnvCell& cell, const Vec3& point) {
    const dat::CellStruct& shape = shapeOf(cell);
    double nearest = 1e300;
    for (const auto& [id, polygon] : shape.polygons) {
        const Plane plane = planeOf(pointsOf(shape.vertexArray, polygon, cell.position));
        nearest = std::min(nearest, std::abs(plane.signedDistance(point)));
    }
    return nearest;
}

bool isConvex(const dat::EnvCell& cell) {
    const dat::CellStruct& shape = shapeOf(cell);
    for (const auto& [id, polygon] : shape.polygons) {
        const Plane plane = planeOf(pointsOf(shape.vertexArray, polygon, cell.position));
        for (const auto& [key, vertex] : shape.vertexArray.vertices)
            if (plane.signedDistance(apply(cell.position, Vec3(vertex.position))) < -1e-3)
                return false;
    }
    return true;
}

} // namespace limen::worlds::test
