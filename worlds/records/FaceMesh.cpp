#include "worlds/records/FaceMesh.h"

#include "geometry/Plane.h"
#include "worlds/pictures/Noise.h"

#include <numbers>

namespace limen::worlds {

namespace {

Vec3 turned(double degrees, const Vec3& v) {
    // Quarter turns are exact.
    const double quarters = degrees / 90.0;
    double c = std::cos(degrees * std::numbers::pi / 180.0);
    double s = std::sin(degrees * std::numbers::pi / 180.0);
    if (quarters == std::floor(quarters)) {
        c = std::round(c);
        s = std::round(s);
    }
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

std::array<std::vector<Vec3>, 6> boxFaces(const Vec3& a, const Vec3& b) {
    return {{{{a.x, b.y, a.z}, {a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}},
             {{b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}, {b.x, a.y, b.z}},
             {{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}},
             {{b.x, b.y, a.z}, {a.x, b.y, a.z}, {a.x, b.y, b.z}, {b.x, b.y, b.z}},
             {{a.x, b.y, a.z}, {b.x, b.y, a.z}, {b.x, a.y, a.z}, {a.x, a.y, a.z}},
             {{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}}};
}

Vec2 shiftFor(const Vec3& p) {
    const auto key = [](double v) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::llround(v * 64.0)));
    };
    const std::uint32_t h = hash(key(p.x), key(p.y), key(p.z));
    return {4.0 * random01(h, 1), 4.0 * random01(h, 2)};
}

} // namespace

Face planarFace(std::vector<Vec3> points, Material material) {
    Face face;
    face.material = material;
    const Vec3 n = planeOf(points).n;
    const bool level = std::abs(n.z) > 0.99;
    const Vec3 u = level ? Vec3(1, 0, 0) : glm::normalize(glm::cross(Vec3(0, 0, 1), n));
    const Vec3 v = level ? Vec3(0, -1, 0) : -glm::cross(n, u);
    const double scale = 1.0 / metresPerTile(material);
    for (const Vec3& p : points)
        face.uvs.emplace_back(glm::dot(p, u) * scale, glm::dot(p, v) * scale);
    face.points = std::move(points);
    return face;
}

Face grainedFace(std::vector<Vec3> points, Material material, const Vec3& grain, const Vec2& shift) {
    Face face;
    face.material = material;
    const Vec3 n = planeOf(points).n;
    Vec3 u = grain - n * glm::dot(grain, n);
    if (glm::dot(u, u) < 0.01)
        u = std::abs(n.z) < 0.9 ? glm::cross(Vec3(0, 0, 1), n) : Vec3(1, 0, 0);
    u = glm::normalize(u);
    const Vec3 v = glm::cross(n, u);
    const double scale = 1.0 / metresPerTile(material);
    for (const Vec3& p : points)
        face.uvs.emplace_back((glm::dot(p, u) + shift.x) * scale, (glm::dot(p, v) + shift.y) * scale);
    face.points = std::move(points);
    return face;
}

Face portalFace(std::vector<Vec3> points) {
    Face face;
    face.points = std::move(points);
    face.portal = true;
    return face;
}

Face flipped(Face face) {
    std::reverse(face.points.begin(), face.points.end());
    std::reverse(face.uvs.begin(), face.uvs.end());
    std::reverse(face.normals.begin(), face.normals.end());
    for (Vec3& n : face.normals)
        n = -n;
    return face;
}

Vec3 faceNormal(const Face& face) {
    return planeOf(face.points).n;
}

Vec3 place(const Placement& placement, const Vec3& point) {
    return placement.origin + turned(placement.turn, point);
}

void FaceMesh::addThin(const Face& face) {
    Face back = flipped(face);
    for (Vec3& n : back.normals)
        n = -n;
    add(face);
    add(std::move(back));
}

void FaceMesh::card(const std::array<Vec3, 4>& c, Material material, bool twoSided) {
    Face face;
    face.points.assign(c.begin(), c.end());
    face.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    face.material = material;
    face.twoSided = twoSided;
    add(std::move(face));
}

void FaceMesh::box(const Vec3& min, const Vec3& max, Material material) {
    for (auto& points : boxFaces(min, max))
        polygon(std::move(points), material);
}

void FaceMesh::beam(const Vec3& min, const Vec3& max, Material material) {
    const Vec3 size = max - min;
    const Vec3 grain = size.x >= size.y && size.x >= size.z ? Vec3(1, 0, 0)
                       : size.y >= size.z                   ? Vec3(0, 1, 0)
                                                            : Vec3(0, 0, 1);
    const Vec2 shift = shiftFor(min + max);
    for (auto& points : boxFaces(min, max))
        add(grainedFace(std::move(points), material, grain, shift));
}

void FaceMesh::strut(const Vec3& a, const Vec3& b, const Vec3& side, double wide, double deep,
                     Material material) {
    const double length = glm::length(b - a);
    const Vec3 along = (b - a) / length;
    const Vec3 across = glm::normalize(side - along * glm::dot(side, along));
    const Vec3 third = glm::cross(along, across);
    for (auto& points : boxFaces({0, -wide / 2, -deep / 2}, {length, wide / 2, deep / 2})) {
        for (Vec3& p : points)
            p = a + along * p.x + across * p.y + third * p.z;
        add(grainedFace(std::move(points), material, along, shiftFor(a + b)));
    }
}

void FaceMesh::cylinder(const Round& r) {
    const double tile = metresPerTile(r.side);
    const double around =
        r.wrapOnce ? 1.0
                   : std::max(1.0, std::round(2.0 * std::numbers::pi * std::max(r.lower, r.upper) / tile));
    const double down = r.wrapOnce ? 1.0 : r.height / tile;
    std::vector<Vec3> bottom;
    std::vector<Vec3> top;
    for (int k = 0; k < r.sides; ++k) {
        const double a = 2.0 * std::numbers::pi * k / r.sides;
        const Vec3 d{std::cos(a), std::sin(a), 0.0};
        bottom.push_back(r.base + d * r.lower);
        top.push_back(r.base + d * r.upper + Vec3(0, 0, r.height));
    }
    const double slope = (r.lower - r.upper) / r.height;
    for (int k = 0; k < r.sides; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const auto j = static_cast<std::size_t>((k + 1) % r.sides);
        const double u0 = around * k / r.sides;
        const double u1 = around * (k + 1) / r.sides;
        const auto normal = [&](std::size_t m) {
            const double a = 2.0 * std::numbers::pi * static_cast<double>(m) / r.sides;
            return glm::normalize(Vec3(std::cos(a), std::sin(a), slope));
        };
        Face face;
        face.material = r.side;
        face.points = {bottom[i], bottom[j], top[j], top[i]};
        face.uvs = {{u0, down}, {u1, down}, {u1, 0.0}, {u0, 0.0}};
        face.normals = {normal(i), normal(j), normal(j), normal(i)};
        if (r.upper <= 0.0) {
            face.points.pop_back();
            face.uvs = {{u0, down}, {u1, down}, {0.5 * (u0 + u1), 0.0}};
            face.normals.pop_back();
        }
        add(std::move(face));
    }
    if (r.caps && r.upper > 0.0)
        polygon(top, r.cap);
    if (r.caps && r.lower > 0.0) {
        std::reverse(bottom.begin(), bottom.end());
        polygon(std::move(bottom), r.cap);
    }
}

void FaceMesh::append(const FaceMesh& part, const Placement& placement) {
    for (Face face : part.faces_) {
        for (Vec3& p : face.points)
            p = place(placement, p);
        for (Vec3& n : face.normals)
            n = turned(placement.turn, n);
        add(std::move(face));
    }
}

Aabb FaceMesh::bounds() const {
    Aabb box;
    for (const Face& face : faces_)
        for (const Vec3& p : face.points)
            box.include(p);
    return box;
}

} // namespace limen::worlds
