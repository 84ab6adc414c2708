#include "visibility/SpaceLocator.h"

#include <cmath>
#include <numbers>
#include <string>

namespace limen::visibility {

namespace {

/// Share of a turn around a point on a face that rounding may take away.
constexpr double kRounding = 1e-6;

/// The angle of a triangle as seen from the origin, of a full 4π; positive if it is counter-clockwise from there.
double solidAngle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double above = glm::dot(a, glm::cross(b, c));
    const double below = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    return -2.0 * std::atan2(above, below);
}

} // namespace

Result<SpaceLocator> SpaceLocator::build(std::span<const SpaceMesh> meshes, double tolerance) {
    SpaceLocator locator;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const SpaceMesh& mesh = meshes[i];
        if (Result<void> closed = checkClosed(mesh, tolerance, "space " + std::to_string(i)); !closed)
            return Failure(closed.error());
        Space space;
        space.firstTriangle = static_cast<std::uint32_t>(locator.triangles_.size());
        for (const MeshFace& face : mesh.faces) {
            const auto corner = [&](std::uint32_t at) {
                return mesh.vertices[mesh.corners[face.firstCorner + at]];
            };
            for (std::uint32_t c = 0; c < face.cornerCount; ++c)
                space.box.include(corner(c));
            for (std::uint32_t c = 2; c < face.cornerCount; ++c)
                locator.triangles_.push_back({corner(0), corner(c - 1), corner(c)});
        }
        space.triangleCount = static_cast<std::uint32_t>(locator.triangles_.size()) - space.firstTriangle;
        locator.spaces_.push_back(space);
    }
    return locator;
}

bool SpaceLocator::contains(const Space& space, const Vec3& point) const {
    if (!space.box.contains(point))
        return false;
    double sum = 0.0;
    for (std::uint32_t t = space.firstTriangle; t < space.firstTriangle + space.triangleCount; ++t) {
        const auto& [a, b, c] = triangles_[t];
        sum += solidAngle(a - point, b - point, c - point);
    }
    return sum >= 2.0 * std::numbers::pi * (1.0 - kRounding); // half of a full sphere: on a face
}

std::uint32_t SpaceLocator::spaceAt(const Vec3& point) const {
    for (std::uint32_t i = 0; i < spaces_.size(); ++i)
        if (contains(spaces_[i], point))
            return i;
    return kNone;
}

void SpaceLocator::spacesAt(const Vec3& point, std::vector<std::uint32_t>& out) const {
    out.clear();
    for (std::uint32_t i = 0; i < spaces_.size(); ++i)
        if (contains(spaces_[i], point))
            out.push_back(i);
}

} // namespace limen::visibility
