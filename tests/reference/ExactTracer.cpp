#include "reference/ExactTracer.h"

#include "geometry/Tolerances.h"

#include <algorithm>

namespace limen::test {

namespace {

using Vector = ExactTracer::Vector;
constexpr mp_bitcnt_t kBits = 512;

mpf_class number(double value) {
    return mpf_class(value, kBits);
}
Vector vector(const Vec3& v) {
    return {number(v.x), number(v.y), number(v.z)};
}
Vector operator+(const Vector& a, const Vector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator-(const Vector& a, const Vector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vector operator*(const Vector& a, const mpf_class& s) {
    return {a.x * s, a.y * s, a.z * s};
}
mpf_class dot(const Vector& a, const Vector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3 rounded(const Vector& v) {
    return {v.x.get_d(), v.y.get_d(), v.z.get_d()};
}

/// True if a line in this direction through the point meets the convex polygon, its border included.
bool meetsPolygon(const std::vector<Vector>& polygon, const Vector& point, const Vector& direction) {
    bool isLeft = true, isRight = true;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector from = polygon[i] - point, to = polygon[(i + 1) % polygon.size()] - point;
        const mpf_class side = dot(cross(from, to), direction);
        isLeft = isLeft && side >= 0;
        isRight = isRight && side <= 0;
    }
    return polygon.size() >= 3 && (isLeft || isRight);
}

} // namespace

struct ExactTracer::Ray {
    Vector eye, direction;
    Vec3 roughEye{0.0}, roughDirection{0.0};
    mpf_class nearPlane;
    std::vector<world::PortalIndex> notAgain; ///< passed by an eye in their planes
};

struct ExactTracer::Exit {
    world::PortalIndex portal = world::kNone;
    mpf_class t{0, kBits}, half{0, kBits}; ///< half of the stretch within the tolerance of the plane
};

struct ExactTracer::Best {
    std::uint32_t id = 0;
    mpf_class t{0, kBits};
};

ExactTracer::ExactTracer(const world::World& world) : world_(world) {
    mpf_set_default_prec(kBits);
    for (const world::Instance& instance : world.instances) {
        const world::Mesh& mesh = world.meshes[instance.mesh];
        const world::Mesh::Range& opaque = mesh.ranges[static_cast<std::size_t>(world::SurfaceClass::Opaque)];
        const Vector origin = vector(world.blocks[instance.block].origin()) + vector(Vec3(instance.origin));
        const Mat3 linear(instance.linear);
        const auto place = [&](const world::MeshVertex& v) {
            const Vector local = vector(Vec3(v.position)) + vector(Vec3(v.rest));
            return origin +
                   (vector(linear[0]) * local.x + vector(linear[1]) * local.y + vector(linear[2]) * local.z);
        };
        std::vector<Triangle>& out = triangles_.emplace_back();
        for (std::uint32_t i = opaque.firstIndex; i < opaque.firstIndex + opaque.indexCount; i += 3) {
            const auto vertex = [&](std::uint32_t k) -> const world::MeshVertex& {
                return world.vertices[mesh.firstVertex + world.indices[i + k]];
            };
            Triangle t;
            t.a = place(vertex(0));
            t.ab = place(vertex(1)) - t.a;
            t.ac = place(vertex(2)) - t.a;
            t.normal = cross(t.ab, t.ac);
            t.roughA = rounded(t.a);
            t.roughAb = rounded(t.ab);
            t.roughAc = rounded(t.ac);
            t.id = instance.idBase + vertex(0).polygon;
            out.push_back(std::move(t));
        }
    }
    for (const world::Portal& portal : world.portals) {
        Opening& opening = openings_.emplace_back();
        opening.plane = {vector(portal.plane.n), number(portal.plane.d)};
        mpf_class off = number(0.0);
        for (const Vec3& corner : world::cornersOf(world, portal))
            opening.corners.push_back(vector(corner));
        for (const Vec3& corner : world::polygonOf(world, portal))
            opening.outline.push_back(vector(corner));
        for (const Vector& corner : opening.corners) {
            const mpf_class side = dot(opening.plane.n, corner) + opening.plane.d;
            off = std::max(off, mpf_class(abs(side)));
        }
        const mpf_class most = number(kInPlaneTolerance), before = off + number(kEyeInPlaneTolerance);
        opening.before = std::min(before, most);
    }
}

/// Whether an eye is behind the plane, farther than an eye in it and not farther than the tolerance.
bool ExactTracer::isPassed(world::PortalIndex index, const Vector& eye) const {
    const world::Portal& portal = world_.portals[index];
    const Opening& opening = openings_[index];
    const mpf_class past = -(dot(opening.plane.n, eye) + opening.plane.d);
    if (portal.walled || portal.destination == world::kNone || past <= opening.before ||
        past > kInPlaneTolerance || !meetsPolygon(opening.corners, eye, opening.plane.n))
        return false;
    if (portal.exact || portal.reciprocal == world::kNone)
        return true;
    const Opening& back = openings_[portal.reciprocal];
    const mpf_class side = dot(back.plane.n, eye) + back.plane.d;
    return side > 0 && meetsPolygon(back.corners, eye, back.plane.n);
}

world::SpaceIndex ExactTracer::beyondPassed(world::SpaceIndex space, const Vector& eye) const {
    world::PortalIndex back = world::kNone;
    for (int passed = 0; passed < 4; ++passed) {
        const world::Space& from = world_.spaces[space];
        world::PortalIndex p = from.firstPortal;
        const world::PortalIndex end = from.firstPortal + from.portalCount;
        while (p < end && (p == back || !isPassed(p, eye)))
            ++p;
        if (p == end)
            break;
        back = world_.portals[p].reciprocal;
        space = world_.portals[p].destination;
    }
    return space;
}

bool ExactTracer::passesPair(world::PortalIndex index, const Ray& ray, const mpf_class& after) const {
    const world::Portal& portal = world_.portals[index];
    if (portal.exact || portal.reciprocal == world::kNone)
        return true;
    const Opening& back = openings_[portal.reciprocal];
    const mpf_class side = dot(back.plane.n, ray.eye) + back.plane.d,
                    speed = dot(back.plane.n, ray.direction);
    if (after <= 0 && -side >= -kInPlaneTolerance && -side <= back.before &&
        meetsPolygon(back.corners, ray.eye, back.plane.n))
        return true;
    if (speed == 0)
        return false;
    const mpf_class t = -side / speed;
    return meetsPolygon(back.corners, ray.eye + ray.direction * t, back.plane.n);
}

void ExactTracer::nearestPortal(world::SpaceIndex space, const Ray& ray, const mpf_class& after,
                                world::PortalIndex cameBy, Exit& exit) const {
    const world::Space& from = world_.spaces[space];
    for (world::PortalIndex p = from.firstPortal; p < from.firstPortal + from.portalCount; ++p) {
        const world::Portal& portal = world_.portals[p];
        const Opening& opening = openings_[p];
        const mpf_class speed = -dot(opening.plane.n, ray.direction);
        if (portal.walled || opening.corners.size() < 3 || speed <= 0 ||
            (cameBy != world::kNone && world_.portals[cameBy].reciprocal == p))
            continue;
        const mpf_class side = dot(opening.plane.n, ray.eye) + opening.plane.d;
        const bool inPlane = after <= 0 && side >= -kInPlaneTolerance && side <= opening.before &&
                             meetsPolygon(opening.corners, ray.eye, opening.plane.n) &&
                             std::find(ray.notAgain.begin(), ray.notAgain.end(), p) == ray.notAgain.end();
        const mpf_class at = inPlane ? number(0.0) : mpf_class(side / speed);
        if ((!inPlane && (side <= 0 || at <= after)) || (exit.portal != world::kNone && at >= exit.t) ||
            (!inPlane && !meetsPolygon(opening.corners, ray.eye, ray.direction) &&
             !meetsPolygon(opening.outline, ray.eye, ray.direction)))
            continue;
        exit.portal = p;
        exit.t = at;
        exit.half = number(kInPlaneTolerance) / speed;
    }
}

void ExactTracer::nearestSurface(world::SpaceIndex index, const Ray& ray, const mpf_class& after,
                                 const Exit& exit, Best& best) const {
    const world::Space& space = world_.spaces[index];
    for (std::uint32_t k = space.firstInstance; k < space.firstInstance + space.instanceCount; ++k) {
        for (const Triangle& t : triangles_[world_.spaceInstances[k]]) {
            const Vec3 roughNormal = glm::cross(t.roughAb, t.roughAc);
            const double facing = -glm::dot(roughNormal, ray.roughDirection),
                         scale = glm::length(roughNormal);
            if (facing < -1e-6 * scale)
                continue;
            if (facing > 1e-3 * scale) { // far beside the triangle, whatever the rounding
                const Vec3 s = ray.roughEye - t.roughA, q = glm::cross(s, t.roughAb);
                const double v = glm::dot(s, glm::cross(ray.roughDirection, t.roughAc)) / facing,
                             w = glm::dot(ray.roughDirection, q) / facing;
                if (v < -0.01 || w < -0.01 || v + w > 1.01)
                    continue;
            }
            const mpf_class determinant = -dot(t.normal, ray.direction);
            if (determinant <= 0)
                continue;
            const Vector s = ray.eye - t.a;
            const mpf_class v = dot(s, cross(ray.direction, t.ac)), w = dot(ray.direction, cross(s, t.ab));
            if (v < 0 || w < 0 || v + w > determinant)
                continue;
            const mpf_class height = dot(t.normal, s), distance = height / determinant;
            const mpf_class inPlane =
                dot(t.normal, t.normal) * number(kEyeInPlaneTolerance) * number(kEyeInPlaneTolerance);
            if (height * height <= inPlane || distance <= after || distance < ray.nearPlane ||
                (exit.portal != world::kNone && distance > exit.t + exit.half) ||
                (best.id != 0 && distance >= best.t))
                continue;
            best.id = t.id;
            best.t = distance;
        }
    }
}

ExactTracer::Answer ExactTracer::trace(world::SpaceIndex root, const Vec3& eye, const Vec3& direction,
                                       double nearPlane) const {
    Ray ray{vector(eye), vector(direction), eye, direction, number(nearPlane), {}};
    world::SpaceIndex space = beyondPassed(root, ray.eye);
    world::PortalIndex cameBy = world::kNone;
    mpf_class after = number(0.0), surfacesAfter = number(0.0);
    Best best;
    bool isHole = false;
    for (int visits = 0; visits < 256; ++visits) {
        Exit exit;
        nearestPortal(space, ray, after, cameBy, exit);
        nearestSurface(space, ray, surfacesAfter, exit, best);
        if (exit.portal == world::kNone || (best.id != 0 && best.t < exit.t - exit.half))
            break;
        if (best.id != 0 && best.t > exit.t + exit.half)
            best = {};
        if (world_.portals[exit.portal].destination == world::kNone || !passesPair(exit.portal, ray, after)) {
            isHole = true;
            break;
        }
        if (exit.t <= 0)
            ray.notAgain.push_back(exit.portal);
        space = world_.portals[exit.portal].destination;
        cameBy = exit.portal;
        after = std::max(exit.t, after);
        surfacesAfter = std::max(mpf_class(exit.t - exit.half), number(0.0));
    }
    if (best.id != 0)
        return {best.id, best.t.get_d()};
    return {space == world::kOutside && !isHole ? 1u : 0u, 0.0};
}

} // namespace limen::test
