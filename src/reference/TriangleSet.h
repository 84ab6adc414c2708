#pragma once

#include "geometry/Plane.h"
#include "reference/Hierarchy.h"
#include "reference/RayFrame.h"
#include "world/World.h"

#include <limits>
#include <vector>

namespace limen::reference {

/// A triangle of an instance, relative to the scene's origin.
struct Triangle {
    Vec3 a{0.0}, b{0.0}, c{0.0};         ///< counter-clockwise from the front
    std::uint32_t id = 0;                ///< as the pixel shows it
    std::uint32_t cutOut = world::kNone; ///< index into TriangleSet::cutOuts; kNone: solid
};

/// What a triangle of a cut-out needs to find its texel.
struct CutOut {
    Vec2f a{0.0f}, b{0.0f}, c{0.0f};
    std::uint32_t material = world::kNone;
};

/// Where on a triangle a ray meets it: parameter and barycentric weights.
struct Meeting {
    double t = 0.0, a = 0.0, b = 0.0, c = 0.0;
};

/// True if the ray's line meets the triangle's front, edges included.
[[nodiscard]] inline bool meetsFront(const RayFrame& ray, const Triangle& triangle, Meeting& meeting) {
    const Sheared a = ray(triangle.a), b = ray(triangle.b), c = ray(triangle.c);
    const double u = edgeSide(b, c), v = edgeSide(c, a), w = edgeSide(a, b);
    const double sum = u + v + w;
    if (u < 0.0 || v < 0.0 || w < 0.0 || !(sum > 0.0))
        return false;
    meeting = {(u * a.z + v * b.z + w * c.z) * ray.scale / sum, u / sum, v / sum, w / sum};
    return true;
}

/// The nearest surface so far. Of two at the same parameter the one with the lower id counts, so that no order of
/// testing shows.
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

/// The parameters in which surfaces are met: after `after`, at least `least`, at most `most`.
struct Stretch {
    double after = 0.0, least = 0.0, most = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool holds(double t) const { return t > after && t >= least && t <= most; }
};

/// Triangles of one class of surface, and a hierarchy over them.
class TriangleSet {
public:
    /// How triangles are grouped: the same for all instances of a mesh.
    struct Grouping {
        Hierarchy tree;
        std::vector<std::uint32_t> order; ///< of the triangles, in the leaves
        bool isKnown = false;
    };
    /// What build() needs for its time; for many sets in turn.
    struct Scratch {
        std::vector<Box> boxes;
        std::vector<Triangle> triangles;
    };
    /// Adds an instance's triangles of one class; `origin` is the scene's. build() must follow.
    void add(const world::World& world, const world::Instance& instance, world::SurfaceClass surfaces,
             const Vec3& origin);
    /// Takes over the grouping; finds one first if it is not known.
    void build(Grouping& grouping, Scratch& scratch);
    void clear();
    [[nodiscard]] bool empty() const { return triangles_.empty(); }
    [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }

    [[nodiscard]] const Box& box() const { return box_; }
    [[nodiscard]] const Hierarchy& tree() const { return tree_; }

    /// Calls visit(triangle) for those that the ray may meet, as Hierarchy::walk calls its leaf.
    template <class Visit>
    void walk(const BoxRay& boxRay, double nearest, const double& farthest, Visit&& visit) const {
        tree_.walk(boxRay, nearest, farthest, [&](std::uint32_t first, std::uint32_t count) {
            for (const Triangle& triangle : std::span(triangles_).subspan(first, count))
                visit(triangle);
        });
    }

    /// Whether a triangle of the set lets the ray through where the ray meets it: the texel there is cut out.
    [[nodiscard]] bool isHole(const world::World& world, const Triangle& triangle, const Meeting& at) const;

    /// Lowers `nearest` to the nearest front face in the stretch, cut-outs tested, as if triangles were larger by `margin` metres all around. `boxRay` must have that margin.
    /// Slow: for the rays that would meet nothing.
    void findNearestGrown(const world::World& world, const RayFrame& ray, const BoxRay& boxRay,
                          const Stretch& stretch, double margin, Nearest& nearest) const;

private:
    std::vector<Triangle> triangles_;
    std::vector<Plane> planes_; ///< by triangle, for findNearestGrown
    std::vector<CutOut> cutOuts_;
    Hierarchy tree_;
    Box box_;
};

} // namespace limen::reference
