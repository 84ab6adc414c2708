#include "motion/Collisions.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"
#include "motion/Locate.h"
#include "world/LeafPose.h"

#include <algorithm>
#include <btBulletCollisionCommon.h>

namespace limen::motion {
namespace {

/// Metres before a surface at which its space is looked up: the space that the surface is seen from.
constexpr double kBefore = 0.001;
/// Metres: least height of the cylinder between a capsule's caps. The chase camera's sphere has no cylinder
/// of its own.
constexpr double kLeastCylinder = 1e-3;
/// Sine of the angle by which rounding may turn a way along a plane into the plane.
constexpr double kAlong = 1e-6;

btVector3 toBullet(const Vec3& v) {
    return {v.x, v.y, v.z};
}
Vec3 fromBullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace

/// Bullet's collision world, and the door leaves. Coordinates are relative to Solids::origin.
struct Collisions::Bodies {
    Bodies(const world::World& of, world::Solids from) : world(of), solids(std::move(from)) {
        indices.resize(solids.corners.size());
        for (std::size_t i = 0; i < indices.size(); ++i)
            indices[i] = static_cast<int>(i);
        for (std::size_t i = 0; i < solids.solids.size(); ++i)
            add(static_cast<int>(i));
    }
    ~Bodies() {
        for (const auto& object : objects)
            if (object->getBroadphaseHandle() != nullptr)
                bullet.removeCollisionObject(object.get());
    }
    Bodies(const Bodies&) = delete;
    Bodies& operator=(const Bodies&) = delete;

    void add(int index) {
        const world::Solid& solid = solids.solids[static_cast<std::size_t>(index)];
        LIMEN_ASSERT(3 * (std::size_t{solid.firstTriangle} + solid.triangleCount) <= solids.corners.size(),
                     "a solid's triangles are among the corners");
        LIMEN_ASSERT(solid.leaf == world::kNone || solid.leaf < world.leaves.size(),
                     "a swinging solid is a leaf of the world");
        btIndexedMesh part;
        part.m_numTriangles = static_cast<int>(solid.triangleCount);
        part.m_triangleIndexBase =
            reinterpret_cast<const unsigned char*>(indices.data() + std::size_t{solid.firstTriangle} * 3);
        part.m_triangleIndexStride = 3 * sizeof(int);
        part.m_numVertices = static_cast<int>(solids.corners.size());
        part.m_vertexBase = reinterpret_cast<const unsigned char*>(solids.corners.data());
        part.m_vertexStride = sizeof(Vec3);
        part.m_vertexType = PHY_DOUBLE;
        meshes.push_back(std::make_unique<btTriangleIndexVertexArray>());
        meshes.back()->addIndexedMesh(part);
        shapes.push_back(std::make_unique<btBvhTriangleMeshShape>(meshes.back().get(), false));
        shapes.back()->setMargin(0.0);
        objects.push_back(std::make_unique<btCollisionObject>());
        objects.back()->setCollisionShape(shapes.back().get());
        objects.back()->setUserIndex(index);
        if (solid.leaf == world::kNone)
            bullet.addCollisionObject(objects.back().get());
        else
            leaves.push_back(hungLeaf(index, solid));
    }

    struct HungLeaf {
        int index = 0;      ///< of its solid
        Vec3 hinge{0.0};    ///< the middle of the sphere that it stays in, relative to Solids::origin
        double reach = 0.0; ///< the radius of that sphere
    };
    [[nodiscard]] HungLeaf hungLeaf(int index, const world::Solid& solid) const {
        const world::Leaf& leaf = world.leaves[solid.leaf];
        if (leaf.keyCount == 0)
            return {index, leaf.hinge - solids.origin, reachOf(solid)};
        const Sphere reach = world::leafReach(world, leaf);
        return {index, reach.centre - solids.origin, std::max(reach.radius, 0.0)};
    }

    /// The largest distance of a leaf's corners from its hinge; metres.
    [[nodiscard]] double reachOf(const world::Solid& solid) const {
        double reach = 0.0;
        for (std::uint32_t i = 3 * solid.firstTriangle; i < 3 * (solid.firstTriangle + solid.triangleCount);
             ++i)
            reach = std::max(reach, glm::length(solids.corners[i]));
        return reach;
    }

    const world::World& world;
    world::Solids solids;
    std::vector<int> indices; ///< 0, 1, 2, ...: three corners a triangle, none shared
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btCollisionWorld bullet{&dispatcher, &broadphase, &configuration};
    std::vector<std::unique_ptr<btTriangleIndexVertexArray>> meshes;
    std::vector<std::unique_ptr<btBvhTriangleMeshShape>> shapes;
    std::vector<std::unique_ptr<btCollisionObject>> objects; ///< by solid
    /// `door`: the only door to leave; kNone: all solids.
    [[nodiscard]] Vec3 wayOut(const Capsule& capsule, const Standing& standing, std::span<const double> open,
                              std::uint32_t door);
    std::vector<HungLeaf> leaves; ///< not in Bullet's world: each query poses them anew
};

namespace {

/// Decides which contacts of a body at one position count.
class Meets {
public:
    /// `door`: the only door whose solids count; kNone: all solids do.
    Meets(const world::World& world, const world::Solids& solids, const Capsule& capsule,
          const Standing& standing, std::span<const double> doors, std::uint32_t door = world::kNone)
        : world_(world), solids_(solids), capsule_(capsule), standing_(standing), doors_(doors), door_(door) {
        LIMEN_ASSERT(standing.space < world.spaces.size(), "a body is in a space of the world");
    }

    [[nodiscard]] bool isThere(int index) const {
        const world::Solid& solid = solidAt(index);
        if (door_ != world::kNone && solid.door != door_)
            return false;
        return solid.door == world::kNone || solid.leaf != world::kNone || openness(solid.door) <= 0.0;
    }

    /// The pose of a leaf, relative to Solids::origin.
    [[nodiscard]] btTransform poseOf(int index) const {
        const world::Solid& solid = solidAt(index);
        const world::Leaf& leaf = world_.leaves[solid.leaf];
        const auto [turn, origin] = world::leafPose(world_, leaf, openness(solid.door));
        return btTransform(btMatrix3x3(turn[0][0], turn[1][0], turn[2][0], turn[0][1], turn[1][1], turn[2][1],
                                       turn[0][2], turn[1][2], turn[2][2]),
                           toBullet(origin - solids_.origin));
    }

    /// Whether the body collides with a solid at a point. `at`: the point, relative to Solids::origin.
    /// `feet`: the body's feet at that time, global.
    [[nodiscard]] bool meets(int index, const Vec3& at, const Vec3& feet) const {
        const Vec3 start = capsule_.middle(standing_.feet), middle = capsule_.middle(feet);
        const Vec3 towards = solids_.origin + at - middle;
        const double distance = glm::length(towards);
        const double share = distance > kBefore ? (distance - kBefore) / distance : 0.0;
        const Vec3 before = middle + towards * share;
        world::SpaceIndex space = sweep(world_, standing_.space, start, middle);
        space = sweep(world_, space, middle, before);
        if (isMember(index, space) || isBehindAnOpeningAt(index, space, solids_.origin + at))
            return true;
        // The point may be behind an opening, by less than kBefore.
        const world::SpaceIndex there = sweep(world_, space, before, solids_.origin + at);
        return there != space && isMember(index, there);
    }

    [[nodiscard]] const world::Solid& solidAt(int index) const {
        return solids_.solids[static_cast<std::size_t>(index)];
    }

private:
    /// A surface in the plane of an opening is met from both sides. Examples: the wall around the smaller
    /// polygon of an inexact pair; the wall between two rooms, at the edge that the openings into both rooms
    /// share.
    [[nodiscard]] bool isBehindAnOpeningAt(int index, world::SpaceIndex from, const Vec3& place) const {
        const world::Space& space = world_.spaces[from];
        for (world::PortalIndex p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const world::Portal& portal = world_.portals[p];
            if (portal.destination != world::kNone && isMember(index, portal.destination) &&
                std::abs(portal.plane.signedDistance(place)) <= kInPlaneTolerance &&
                containsProjection(world::cornersOf(world_, portal), portal.plane.n, place, kGapTolerance))
                return true;
        }
        return false;
    }
    [[nodiscard]] bool isMember(int index, world::SpaceIndex space) const {
        const world::Solid& solid = solidAt(index);
        const auto members = std::span(solids_.members).subspan(solid.firstMember, solid.memberCount);
        return std::find(members.begin(), members.end(), space) != members.end();
    }
    [[nodiscard]] double openness(std::uint32_t door) const {
        return door < doors_.size() ? doors_[door] : world_.doors[door].open;
    }
    const world::World& world_;
    const world::Solids& solids_;
    const Capsule& capsule_;
    const Standing& standing_;
    std::span<const double> doors_;
    std::uint32_t door_;
};

int indexOf(const btCollisionObject* object) {
    return object->getUserIndex();
}

/// Keeps the first contact of a sweep that counts.
struct FirstBump : btCollisionWorld::ConvexResultCallback {
    FirstBump(const Meets& what, const Vec3& start, const Vec3& end) : meets(what), from(start), to(end) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return meets.isThere(indexOf(static_cast<const btCollisionObject*>(proxy->m_clientObject)));
    }
    btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool inWorldSpace) override {
        Vec3 n = fromBullet(inWorldSpace ? result.m_hitNormalLocal
                                         : result.m_hitCollisionObject->getWorldTransform().getBasis() *
                                               result.m_hitNormalLocal);
        const double length = glm::length(n);
        if (!(length > 0.0))
            return m_closestHitFraction;
        n /= length;
        // A way along the plane or away from it is no contact. Rounding may turn a way along it slightly
        // inwards.
        const bool leaves = glm::dot(n, to - from) >= -kAlong * glm::length(to - from);
        const Vec3 feet = from + (to - from) * double{result.m_hitFraction};
        if (leaves ||
            !meets.meets(indexOf(result.m_hitCollisionObject), fromBullet(result.m_hitPointLocal), feet))
            return m_closestHitFraction;
        m_closestHitFraction = result.m_hitFraction;
        normal = n;
        at = fromBullet(result.m_hitPointLocal);
        return m_closestHitFraction;
    }
    const Meets& meets;
    Vec3 from, to;
    Vec3 normal{0.0}, at{0.0};
};

/// Keeps the first surface on a line that counts.
struct FirstSurface : btCollisionWorld::RayResultCallback {
    FirstSurface(const Meets& what, const Vec3& where, const Vec3& start, const Vec3& end)
        : meets(what), feet(where), from(start), to(end) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return meets.isThere(indexOf(static_cast<const btCollisionObject*>(proxy->m_clientObject)));
    }
    btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool) override {
        const Vec3 place = from + (to - from) * double{result.m_hitFraction};
        if (meets.meets(indexOf(result.m_collisionObject), place, feet)) {
            m_closestHitFraction = result.m_hitFraction;
            normal = fromBullet(result.m_hitNormalLocal); // in world axes: Bullet has rotated it
            m_collisionObject = result.m_collisionObject;
        }
        return m_closestHitFraction;
    }
    const Meets& meets;
    Vec3 feet, from, to;
    Vec3 normal{0.0};
};

/// Sums the ways out of all overlaps; along each direction the deepest one counts.
struct Overlaps : btCollisionWorld::ContactResultCallback {
    Overlaps(const Meets& what, const Vec3& where) : meets(what), feet(where) {}
    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return meets.isThere(indexOf(static_cast<const btCollisionObject*>(proxy->m_clientObject)));
    }
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper* other, int, int) override {
        const double depth = -point.getDistance();
        if (!(depth > 0.0) ||
            !meets.meets(indexOf(other->getCollisionObject()), fromBullet(point.getPositionWorldOnB()), feet))
            return 0.0;
        const Vec3 n = fromBullet(point.m_normalWorldOnB);
        const double more = depth - glm::dot(way, n);
        if (more > 0.0)
            way += n * more;
        return 0.0;
    }
    const Meets& meets;
    Vec3 feet;
    Vec3 way{0.0};
};

btTransform at(const Vec3& middle) {
    return btTransform(btQuaternion::getIdentity(), toBullet(middle));
}

btCapsuleShapeZ shapeOf(const Capsule& capsule) {
    return {capsule.radius, std::max(capsule.height - 2.0 * capsule.radius, kLeastCylinder)};
}

/// Calls visit(solid) for each leaf that comes near a straight way; all relative to Solids::origin.
template <class Leaves, class Visit>
void eachLeafNear(const Leaves& leaves, const Vec3& from, const Vec3& to, double radius, Visit&& visit) {
    const Vec3 middle = (from + to) * 0.5;
    const double around = radius + 0.5 * glm::length(to - from);
    for (const auto& leaf : leaves)
        if (glm::length(leaf.hinge - middle) <= leaf.reach + around)
            visit(leaf.index);
}

} // namespace

Vec3 Collisions::Bodies::wayOut(const Capsule& capsule, const Standing& standing,
                                std::span<const double> open, std::uint32_t door) {
    const Meets meets(world, solids, capsule, standing, open, door);
    Overlaps overlaps(meets, standing.feet);
    const Vec3 middle = capsule.middle(standing.feet) - solids.origin;
    btCapsuleShapeZ shape = shapeOf(capsule);
    btCollisionObject body;
    body.setCollisionShape(&shape);
    body.setWorldTransform(at(middle));
    bullet.contactTest(&body, overlaps);
    eachLeafNear(leaves, middle, middle, 0.5 * capsule.height, [&](int index) {
        if (!meets.isThere(index))
            return;
        btCollisionObject leaf;
        leaf.setCollisionShape(objects[static_cast<std::size_t>(index)]->getCollisionShape());
        leaf.setWorldTransform(meets.poseOf(index));
        leaf.setUserIndex(index);
        bullet.contactPairTest(&body, &leaf, overlaps);
    });
    return overlaps.way;
}

Collisions::Collisions(const world::World& world, world::Solids solids)
    : bodies_(std::make_unique<Bodies>(world, std::move(solids))) {}
Collisions::~Collisions() = default;
Collisions::Collisions(Collisions&&) noexcept = default;
Collisions& Collisions::operator=(Collisions&&) noexcept = default;

const world::World& Collisions::world() const {
    return bodies_->world;
}
dat::BlockCoord Collisions::centre() const {
    return bodies_->solids.centre;
}
int Collisions::radius() const {
    return bodies_->solids.radius;
}

std::optional<Bump> Collisions::sweep(const Capsule& capsule, const Standing& from, const Vec3& to,
                                      std::span<const double> doors) const {
    if (from.feet == to || !isFinite(to))
        return std::nullopt;
    const Meets meets(bodies_->world, bodies_->solids, capsule, from, doors);
    FirstBump first(meets, from.feet, to);
    const btCapsuleShapeZ shape = shapeOf(capsule);
    const Vec3 origin = bodies_->solids.origin;
    const Vec3 start = capsule.middle(from.feet) - origin, end = capsule.middle(to) - origin;
    bodies_->bullet.convexSweepTest(&shape, at(start), at(end), first);
    eachLeafNear(bodies_->leaves, start, end, 0.5 * capsule.height, [&](int index) {
        btCollisionObject* leaf = bodies_->objects[static_cast<std::size_t>(index)].get();
        btCollisionWorld::objectQuerySingle(&shape, at(start), at(end), leaf, leaf->getCollisionShape(),
                                            meets.poseOf(index), first, 0.0);
    });
    if (!first.hasHit())
        return std::nullopt;
    return Bump{std::clamp(double{first.m_closestHitFraction}, 0.0, 1.0), first.normal, origin + first.at};
}

std::optional<Vec3> Collisions::surfaceBelow(const Capsule& capsule, const Standing& standing,
                                             const Vec3& above, double depth,
                                             std::span<const double> doors) const {
    const Meets meets(bodies_->world, bodies_->solids, capsule, standing, doors);
    const Vec3 from = above - bodies_->solids.origin, to = from - Vec3(0.0, 0.0, depth);
    FirstSurface first(meets, standing.feet, from, to);
    bodies_->bullet.rayTest(toBullet(from), toBullet(to), first);
    eachLeafNear(bodies_->leaves, from, to, 0.0, [&](int index) {
        btCollisionObject* leaf = bodies_->objects[static_cast<std::size_t>(index)].get();
        btCollisionWorld::rayTestSingle(btTransform(btMatrix3x3::getIdentity(), toBullet(from)),
                                        btTransform(btMatrix3x3::getIdentity(), toBullet(to)), leaf,
                                        leaf->getCollisionShape(), meets.poseOf(index), first);
    });
    const double length = glm::length(first.normal);
    if (!first.hasHit() || !(length > 0.0))
        return std::nullopt;
    const Vec3 normal = first.normal / length;
    return normal.z < 0.0 ? -normal : normal;
}

Vec3 Collisions::wayOut(const Capsule& capsule, const Standing& standing,
                        std::span<const double> doors) const {
    return bodies_->wayOut(capsule, standing, doors, world::kNone);
}

Vec3 Collisions::wayOutOf(std::uint32_t door, const Capsule& capsule, const Standing& standing,
                          std::span<const double> doors) const {
    LIMEN_ASSERT(door < bodies_->world.doors.size(), "overlaps with a door of the world");
    return bodies_->wayOut(capsule, standing, doors, door);
}

} // namespace limen::motion
