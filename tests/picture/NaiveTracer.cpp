#include "picture/NaiveTracer.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace limen::test {

namespace {

/// Metres. An eye this near to a portal's plane is in it, and a surface this near is hit from both sides.
constexpr double kTolerance = 0.0002;

/// Triangles are closed sets: a ray along a shared edge must not pass between two of them by rounding. In
/// barycentric coordinates, where doubles round at 10⁻¹⁵ times distance over triangle size.
constexpr double kEdge = 1e-9;

} // namespace

NaiveTracer::NaiveTracer(const world::World& world, world::DynamicState dynamics)
    : world_(world), dynamics_(std::move(dynamics)) {
    for (const world::Instance& instance : world.instances)
        addTriangles(instance);
    for (const world::Instance& instance : dynamics_.instances)
        addTriangles(instance);
    for (world::SpaceIndex space = 0; space < world.spaces.size(); ++space)
        addClusters(space);
}

void NaiveTracer::addClusters(world::SpaceIndex index) {
    constexpr double kSize = 24.0;
    std::map<std::tuple<long, long>, Cluster> grid;
    const world::Space& space = world_.spaces[index];
    std::vector<world::InstanceIndex> members(world_.spaceInstances.begin() + space.firstInstance,
                                              world_.spaceInstances.begin() + space.firstInstance +
                                                  space.instanceCount);
    for (const world::InstanceIndex moving : dynamics_.instancesIn(index))
        members.push_back(static_cast<world::InstanceIndex>(world_.instances.size()) + moving);
    for (const world::InstanceIndex instance : members) {
        const Vec3& centre = bodies_[instance].bounds.centre;
        grid[{std::lround(centre.x / kSize), std::lround(centre.y / kSize)}].bodies.push_back(instance);
    }
    clusters_.emplace_back();
    for (auto& [key, cluster] : grid) {
        Aabb box;
        for (const world::InstanceIndex i : cluster.bodies) {
            const Sphere& sphere = bodies_[i].bounds;
            box.include(sphere.centre - sphere.radius);
            box.include(sphere.centre + sphere.radius);
        }
        cluster.bounds = {box.centre(), glm::length(box.max - box.min) * 0.5};
        clusters_.back().push_back(std::move(cluster));
    }
}

// The distance rule in whole sixteenths of a metre, as docs/ray-rule.md states it.
bool NaiveTracer::isInLevelRange(const Body& body, const Vec3& eye) const {
    if (body.level == world::kNone)
        return true;
    const world::Level& level = world_.levels[body.level];
    const Vec3 at = glm::floor(eye * 16.0);
    const Vec3 origin = body.block * 16.0 + Vec3(level.origin[0], level.origin[1], level.origin[2]);
    const Vec3 offset = origin - at;
    double away = glm::dot(offset, offset);
    const Vec3 middle = (glm::floor(origin / 384.0) + 0.5) * 384.0 - at;
    const double across = middle.x * middle.x + middle.y * middle.y;
    if (level.measure == world::LevelMeasure::Landcell && across > 800.0 * 800.0)
        away = across;
    const double from = level.range.from, upTo = level.range.upTo;
    return away >= from * from && (level.range.upTo == world::LevelRange::kEndless || away < upTo * upTo);
}

bool NaiveTracer::mayMeet(const Sphere& bounds, const Ray& ray) {
    const Vec3 offset = bounds.centre - ray.eye;
    const Vec3 across = glm::cross(offset, ray.direction);
    const double reach = bounds.radius * 1.0001 + 0.01;
    return glm::dot(across, across) <= reach * reach * glm::dot(ray.direction, ray.direction);
}

void NaiveTracer::addTriangles(const world::Instance& instance) {
    const world::Mesh& mesh = world_.meshes[instance.mesh];
    Body body{instance.bounds,
              triangles_.size(),
              0,
              instance.kind == world::InstanceKind::Filling,
              world_.blocks[instance.block].origin(),
              instance.level};
    const Vec3 origin = body.block + Vec3(instance.origin);
    const auto place = [&](const world::MeshVertex& v) {
        return origin + Mat3(instance.linear) * v.corner();
    };
    for (const auto surfaces :
         {world::SurfaceClass::Opaque, world::SurfaceClass::CutOut, world::SurfaceClass::Blended}) {
        const world::Mesh::Range& range = mesh.ranges[static_cast<std::size_t>(surfaces)];
        for (std::uint32_t i = range.firstIndex; i < range.firstIndex + range.indexCount; i += 3) {
            const auto vertex = [&](std::uint32_t k) -> const world::MeshVertex& {
                return world_.vertices[mesh.firstVertex + world_.indices[i + k]];
            };
            Triangle t;
            t.a = place(vertex(0));
            t.ab = place(vertex(1)) - t.a;
            t.ac = place(vertex(2)) - t.a;
            t.uvA = vertex(0).uv;
            t.uvB = vertex(1).uv;
            t.uvC = vertex(2).uv;
            t.blended = surfaces == world::SurfaceClass::Blended;
            t.id = instance.idBase + vertex(0).polygon;
            if (surfaces == world::SurfaceClass::CutOut)
                t.material = world_.materialRefs[instance.firstMaterial + vertex(0).surface];
            triangles_.push_back(t);
        }
    }
    body.triangleCount = triangles_.size() - body.firstTriangle;
    bodies_.push_back(body);
}

bool NaiveTracer::isHole(const Triangle& triangle, double v, double w) const {
    if (triangle.material == world::kNone)
        return false;
    const world::Material& material = world_.materials[triangle.material];
    if (material.texture == world::kNone)
        return false;
    const world::Image& image = *world_.textures[material.texture];
    const Vec2 uv = Vec2(triangle.uvA) * (1.0 - v - w) + Vec2(triangle.uvB) * v + Vec2(triangle.uvC) * w;
    const auto texel = [&](double coordinate, std::uint32_t size) {
        const bool clamp = (material.flags & world::Material::kClamp) != 0;
        const double inside =
            clamp ? std::min(std::max(coordinate, 0.0), 1.0) : coordinate - std::floor(coordinate);
        return std::min(static_cast<std::uint32_t>(inside * size), size - 1);
    };
    const std::size_t at =
        (std::size_t{texel(uv.y, image.height)} * image.width + texel(uv.x, image.width)) * 4 + 3;
    return image.rgba[at] < (image.isIndexed ? 100 : 200);
}

double NaiveTracer::meets(const Triangle& triangle, const Ray& ray, double& v, double& w) {
    // Möller, Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection" (1997), front faces only.
    const Vec3 p = glm::cross(ray.direction, triangle.ac);
    const double determinant = glm::dot(triangle.ab, p);
    if (determinant > 0.0) {
        const Vec3 s = ray.eye - triangle.a;
        v = glm::dot(s, p) / determinant;
        const Vec3 q = glm::cross(s, triangle.ab);
        w = glm::dot(ray.direction, q) / determinant;
        const double t = glm::dot(triangle.ac, q) / determinant;
        const Vec3 normal = glm::normalize(glm::cross(triangle.ab, triangle.ac));
        if (std::abs(glm::dot(normal, s)) <= 0.0000005)
            return std::numeric_limits<double>::infinity(); // the eye is in its plane
        if (v >= -kEdge && w >= -kEdge && v + w <= 1.0 + kEdge && t >= ray.nearPlane)
            return t;
    }
    return std::numeric_limits<double>::infinity();
}

void NaiveTracer::nearestIn(const Body& body, const Ray& ray, double after, Answer& best) const {
    for (std::size_t i = body.firstTriangle; i < body.firstTriangle + body.triangleCount; ++i) {
        const Triangle& triangle = triangles_[i];
        double v = 0.0, w = 0.0;
        const double t = meets(triangle, ray, v, w);
        if (!triangle.blended && t > after && t < best.t && !isHole(triangle, v, w)) {
            best.t = t;
            best.id = triangle.id;
        }
    }
}

void NaiveTracer::addLayers(world::SpaceIndex space, const Ray& ray, double after, double until,
                            std::vector<std::uint32_t>& layers) const {
    for (const Cluster& cluster : clusters_[space]) {
        for (const world::InstanceIndex index : cluster.bodies) {
            const Body& body = bodies_[index];
            if (!isInLevelRange(body, ray.eye))
                continue;
            for (std::size_t i = body.firstTriangle; i < body.firstTriangle + body.triangleCount; ++i) {
                double v = 0.0, w = 0.0;
                const Triangle& triangle = triangles_[i];
                double t = triangle.blended ? meets(triangle, ray, v, w) : 0.0;
                if (triangle.blended && body.filling) { // hit before other surfaces in the plane
                    const Vec3 normal = glm::normalize(glm::cross(triangle.ab, triangle.ac));
                    t -= kTolerance / std::abs(glm::dot(normal, ray.direction));
                }
                const bool known = std::find(layers.begin(), layers.end(), triangle.id) != layers.end();
                if (triangle.blended && t > after && t <= until && std::isfinite(t) && !known)
                    layers.push_back(triangle.id);
            }
        }
    }
    std::sort(layers.begin(), layers.end());
}

// Metres from a portal's plane to an eye in it: float rounding of corners, and their distance to the plane.
double NaiveTracer::beforePlane(const world::Portal& portal) const {
    double before = 0.0000005;
    const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
    for (const auto& corners : {polygon, world::cornersOf(world_, portal)})
        for (const Vec3& corner : corners)
            before = std::max(before, 0.0000005 + std::abs(portal.plane.signedDistance(corner)));
    return std::min(before, kTolerance);
}

// False if the eye is nearer to another opening between the same two spaces.
bool NaiveTracer::isNearest(world::PortalIndex index, const Vec3& eye) const {
    const world::Portal& portal = world_.portals[index];
    const double distance = std::abs(portal.plane.signedDistance(eye));
    for (const world::Portal& other : world_.portals)
        if (other.space == portal.space && other.destination == portal.destination && &other != &portal &&
            other.cornerCount >= 3 && std::abs(other.plane.signedDistance(eye)) < distance &&
            containsProjection(world::cornersOf(world_, other), other.plane.n, eye, 0.0))
            return false;
    return true;
}

world::PortalIndex NaiveTracer::nearestPortal(world::SpaceIndex space, const Ray& ray, double after,
                                              world::PortalIndex cameBy, double& t) const {
    world::PortalIndex nearest = world::kNone;
    const world::Space& from = world_.spaces[space];
    for (std::uint32_t i = from.firstPortal; i < from.firstPortal + from.portalCount; ++i) {
        const world::Portal& portal = world_.portals[i];
        const double speed = glm::dot(portal.plane.n, ray.direction);
        if (portal.walled || dynamics_.isClosed(i) || speed >= 0.0 ||
            (cameBy != world::kNone && world_.portals[cameBy].reciprocal == i))
            continue;
        const auto polygon = std::span(world_.portalVertices).subspan(portal.firstVertex, portal.vertexCount);
        const double side = portal.plane.signedDistance(ray.eye);
        const bool inPlane = after <= 0.0 && side >= -kTolerance && side <= beforePlane(portal) &&
                             containsProjection(polygon, portal.plane.n, ray.eye, 0.0) &&
                             (side >= -beforePlane(portal) || isNearest(i, ray.eye));
        const double at = inPlane ? 0.0 : -side / speed;
        const bool ahead = inPlane || (side > 0.0 && at > after);
        if (ahead && at < t &&
            (inPlane || containsProjection(polygon, portal.plane.n, ray.eye + ray.direction * at, 0.0))) {
            t = at;
            nearest = i;
        }
    }
    return nearest;
}

// An eye past the plane of an opening, by more than rounding and at most the tolerance, begins behind it.
world::SpaceIndex NaiveTracer::beyondPassed(world::SpaceIndex space, const Vec3& eye) const {
    const auto isIn = [&](const world::Portal& portal) {
        return containsProjection(world::cornersOf(world_, portal), portal.plane.n, eye, 0.0);
    };
    const auto isPassed = [&](world::PortalIndex i) {
        const world::Portal& portal = world_.portals[i];
        const double past = -portal.plane.signedDistance(eye);
        if (portal.cornerCount < 3 || portal.walled || portal.destination == world::kNone ||
            past <= beforePlane(portal) || past > kTolerance || !isIn(portal))
            return false;
        return portal.exact || portal.reciprocal == world::kNone ||
               (world_.portals[portal.reciprocal].plane.signedDistance(eye) > 0.0 &&
                isIn(world_.portals[portal.reciprocal]));
    };
    world::PortalIndex back = world::kNone;
    for (int passed = 0; passed < 4; ++passed) {
        const world::Space& from = world_.spaces[space];
        world::PortalIndex portal = from.firstPortal;
        while (portal < from.firstPortal + from.portalCount &&
               (portal == back || !isPassed(portal) || !isNearest(portal, eye)))
            ++portal;
        if (portal == from.firstPortal + from.portalCount)
            break;
        back = world_.portals[portal].reciprocal;
        space = world_.portals[portal].destination;
    }
    return space;
}

bool NaiveTracer::passesReciprocal(world::PortalIndex index, const Ray& ray) const {
    const world::Portal& portal = world_.portals[index];
    if (portal.exact || portal.reciprocal == world::kNone)
        return true;
    const world::Portal& back = world_.portals[portal.reciprocal];
    const auto polygon = std::span(world_.portalVertices).subspan(back.firstVertex, back.vertexCount);
    const double t = -back.plane.signedDistance(ray.eye) / glm::dot(back.plane.n, ray.direction);
    return containsProjection(polygon, back.plane.n, ray.eye + ray.direction * t, 0.0);
}

NaiveTracer::Answer NaiveTracer::trace(world::SpaceIndex root, const Ray& ray) const {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Answer answer;
    double t0 = 0.0;
    world::SpaceIndex space = beyondPassed(root, ray.eye);
    world::PortalIndex cameBy = world::kNone;
    const double slack = kTolerance / std::sqrt(glm::dot(ray.direction, ray.direction));
    for (;;) {
        ++answer.spacesVisited;
        answer.reachedOutside = answer.reachedOutside || space == world::kOutside;
        answer.t = kInfinite;
        answer.id = 0;
        for (const Cluster& cluster : clusters_[space]) {
            if (!mayMeet(cluster.bounds, ray))
                continue;
            for (const world::InstanceIndex i : cluster.bodies)
                if (isInLevelRange(bodies_[i], ray.eye) && mayMeet(bodies_[i].bounds, ray))
                    nearestIn(bodies_[i], ray, t0 - slack, answer);
        }
        double t = kInfinite;
        const world::PortalIndex portal = nearestPortal(space, ray, t0, cameBy, t);
        addLayers(space, ray, t0 - slack, std::min(answer.t, t + slack), answer.layers);
        if (portal == world::kNone || answer.t <= t + slack)
            break;
        if (world_.portals[portal].destination == world::kNone || !passesReciprocal(portal, ray)) {
            answer.id = 0;
            answer.t = kInfinite;
            break;
        }
        space = world_.portals[portal].destination;
        cameBy = portal;
        t0 = t;
    }
    if (answer.id == 0) {
        answer.id = space == world::kOutside ? 1 : 0;
        answer.t = answer.id == 1 ? kInfinite : std::numeric_limits<double>::quiet_NaN();
    }
    return answer;
}

} // namespace limen::test
