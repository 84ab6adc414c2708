#pragma once

#include "geometry/Plane.h"
#include "geometry/Tolerances.h"
#include "reference/Hierarchy.h"
#include "reference/RayFrame.h"
#include "world/World.h"

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace limen::reference {

/// A triangle of an instance, relative to the scene's origin.
struct Triangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};         ///< counter-clockwise from the front
    std::uint32_t id = 0;                ///< in the id image
    std::uint32_t cutOut = world::kNone; ///< index into TriangleSet::cutOuts; kNone: solid
};

/// Texture coordinates and material of a triangle of a cut-out.
struct CutOut {
    Vec2f a{0.0f}, b{0.0f}, c{0.0f};
    std::uint32_t material = world::kNone;
};

/// The point where a ray meets a triangle: parameter and barycentric weights.
struct Meeting {
    double t = 0.0, a = 0.0, b = 0.0, c = 0.0;
};

/// True if the ray begins in the triangle's plane, up to kEyeInPlaneTolerance.
[[nodiscard]] inline bool beginsInPlane(const RayFrame& ray, const Triangle& triangle) {
    const Vec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const double height = glm::dot(normal, ray.eye - triangle.a);
    return height * height <= kEyeInPlaneTolerance * kEyeInPlaneTolerance * glm::dot(normal, normal);
}

/// True if the ray's line meets the triangle's front, edges included. A ray that begins in the plane does not.
[[nodiscard]] inline bool meetsFront(const RayFrame& ray, const Triangle& triangle, Meeting& meeting) {
    const Sheared a = ray(triangle.a), b = ray(triangle.b), c = ray(triangle.c);
    const double u = edgeSide(b, c), v = edgeSide(c, a), w = edgeSide(a, b);
    const double sum = u + v + w;
    if (u < 0.0 || v < 0.0 || w < 0.0 || !(sum > 0.0) || beginsInPlane(ray, triangle))
        return false;
    meeting = {(u * a.z + v * b.z + w * c.z) * ray.scale / sum, u / sum, v / sum, w / sum};
    return true;
}

/// The nearest surface so far. At equal parameters the lower id counts, so results do not depend on the order
/// of tests.
struct Nearest {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t id = 0;
    void take(double at, std::uint32_t other) {
        if (at < t || (at == t && other < id)) {
            t = at;
            id = other;
        }
    }
};

/// The parameters at which surfaces count: after `after`, at least `least`, at most `most`.
struct Stretch {
    double after = 0.0, least = 0.0, most = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool holds(double t) const { return t > after && t >= least && t <= most; }
};

/// Whether a ray that passes beside a polygon, at a point of its plane, is in a gap.
using GapTest = std::function<bool(const Vec3& passes, std::span<const Vec3> corners)>;

/// Triangles of one class of surface, and a hierarchy over them.
class TriangleSet {
public:
    /// The grouping of triangles, shared by all instances of a mesh.
    struct Grouping {
        Hierarchy tree;
        std::vector<std::uint32_t> order; ///< triangles in the order of the leaves
        bool isKnown = false;
    };
    /// Scratch memory of build(), reused for many sets.
    struct Scratch {
        std::vector<Box> boxes;
        std::vector<Triangle> triangles;
    };
    /// Adds an instance's triangles of one class; `origin` is the scene's. Call build() afterwards.
    void add(const world::World& world, const world::Instance& instance, world::SurfaceClass surfaces,
             const Vec3& origin);
    /// Groups the triangles by `grouping`, which is made first if it is not known.
    void build(Grouping& grouping, Scratch& scratch);
    void clear();
    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }

    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] const Hierarchy& tree() const { return tree_; }

    /// Calls visit(triangle) for triangles that the ray may meet, as Hierarchy::walk calls its leaf.
    template <class Visit>
    void walk(const BoxRay& boxRay, double nearest, const double& farthest, Visit&& visit) const {
        tree_.walk(boxRay, nearest, farthest, [&](std::uint32_t first, std::uint32_t count) {
            for (const Triangle& triangle : std::span(triangles_).subspan(first, count))
                visit(triangle);
        });
    }

    /// Whether the ray passes the triangle because the texel at the meeting point is cut out.
    [[nodiscard]] bool isHole(const world::World& world, const Triangle& triangle, const Meeting& at) const;

    /// Lowers `nearest` to the nearest front face in the stretch, as if triangles were larger by `margin`
    /// metres all around. Cut-outs are tested. `boxRay` must have that margin. `isGap(passes, corners)` is called
    /// for each such triangle, and false leaves it out. Slow: meant for the few rays that meet nothing otherwise.
    void findNearestGrown(const world::World& world, const RayFrame& ray, const BoxRay& boxRay,
                          const Stretch& stretch, double margin, const GapTest& isGap,
                          Nearest& nearest) const;

private:
    std::vector<Triangle> triangles_;
    std::vector<Plane> planes_; ///< by triangle, for findNearestGrown
    std::vector<CutOut> cutOuts_;
    Hierarchy tree_;
    Box box_;
};

} // namespace limen::reference
