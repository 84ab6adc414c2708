#pragma once

#include "visibility/VisibleSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace limen::visibility {

/// The result of a test of a sphere. Partial includes every doubtful case.
enum class Containment : std::uint8_t { Outside, Partial, Inside };

/// A sphere, eye-relative, with the tolerances of its tests, in metres; made by Viewcones::sphereOf.
struct SeenSphere {
    Vec3 centre{0.0};
    double radius = 0.0;
    double tolerance = 0.0;     ///< at entry planes
    double edgeTolerance = 0.0; ///< at planes through the eye: two pixels more
};

/// Four spheres that are tested together: pointers to the first element of each array, in the graph's frame, metres.
struct SphereQuad {
    static constexpr std::size_t kCount = 4;
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
    const double* radius = nullptr;
};

/// Sixteen spheres that are tested together, in floats, relative to an origin of the caller's choice. No centre is farther from
/// it along any axis than kMostOffset, so that rounding moves a centre by at most 0.2 mm along each axis.
struct SphereBatch {
    static constexpr std::size_t kCount = 16;
    static constexpr double kMostOffset = 4096.0; ///< metres; also the largest radius
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    const float* radius = nullptr;
};

/// Four planes through the eye: unit normals, positive inside. As arrays, because all four are evaluated
/// together.
class FourEdges {
public:
    /// The planes in floats.
    struct Floats {
        std::array<float, 4> x{}, y{}, z{};
    };
    void set(std::size_t i, const Vec3& inwards) {
        x_[i] = inwards.x;
        y_[i] = inwards.y;
        z_[i] = inwards.z;
        const Vec3f nearest(inwards);
        floats_.x[i] = nearest.x;
        floats_.y[i] = nearest.y;
        floats_.z[i] = nearest.z;
    }
    /// The least of a point's signed distances to the four planes.
    [[nodiscard]] double least(const Vec3& point) const {
        const double a = side(0, point), b = side(1, point), c = side(2, point), d = side(3, point);
        const double ab = a < b ? a : b, cd = c < d ? c : d; // values, not references: no branches
        return ab < cd ? ab : cd;
    }

    [[nodiscard]] Vec3 edge(std::size_t i) const { return {x_[i], y_[i], z_[i]}; }
    [[nodiscard]] const Floats& floats() const { return floats_; }

private:
    [[nodiscard]] double side(std::size_t i, const Vec3& point) const {
        return x_[i] * point.x + y_[i] * point.y + z_[i] * point.z;
    }
    std::array<double, 4> x_{}, y_{}, z_{};
    Floats floats_;
};

/// Vector instructions for testing batches of spheres (SphereBatch.cpp). The code is the same, compiled for
/// each set.
enum class Vectors : std::uint8_t {
    Any,   ///< instructions that every processor has
    Avx2,  ///< eight floats
    Avx512 ///< sixteen floats
};
/// The widest set that this processor supports.
[[nodiscard]] LIMEN_API Vectors widestVectors();

/// The visits of one flood as planes, for frustum culling of spheres. Reuse it: steady frames allocate
/// nothing.
class LIMEN_API Viewcones {
public:
    /// `vectors`: a set that the processor supports. The results do not depend on it.
    explicit Viewcones(Vectors vectors = widestVectors()) : vectors_(vectors) {}
    /// Copies the visits of a flood with this view. `pixel`: the angle of one pixel in radians; a sphere within two pixels of a
    /// region touches it. Cost: visits and corners.
    void prepare(const View& view, const VisibleSet& set, double pixel);

    /// Tests a sphere against a visit's region and entry plane. Inside means more than contained: the sphere
    /// is also in front of the entry planes of all later visits that it touches on the screen, and those are
    /// all descendants of this visit. Then every fragment inside the sphere passes the ownership test, and
    /// the test can be omitted.
    [[nodiscard]] Containment classify(std::uint32_t visit, const SeenSphere& sphere) const {
        // The root only: it has no entry plane, and no visit is drawn later.
        if (cones_.size() == 1)
            return classifyOnScreen(cones_.front(), sphere);
        const Containment found = classifyInVisit(cones_[visit], sphere);
        return found == Containment::Inside && isCovered(visit, sphere) ? Containment::Partial : found;
    }
    /// Tests a sphere against the root's region alone, whichever visits are drawn later.
    [[nodiscard]] Containment classifyInRoot(const SeenSphere& sphere) const {
        return classifyOnScreen(cones_.front(), sphere);
    }
    /// Whether a later visit may own a pixel of a sphere that is in the root's zone: one whose region it touches
    /// and whose entry plane it is not in front of.
    [[nodiscard]] bool isCoveredInRoot(const SeenSphere& sphere) const { return isCovered(0, sphere); }
    /// Lists the spheres of a batch that are not outside the root's region, nor outside a rectangle if there
    /// is one: the same result as `classify` gives for each. Tests them together, in floats, without
    /// unpredictable branches. Writes `first + i` for each sphere i found, in order; `out` has room for a
    /// whole batch. Returns their number, or kUndecided if float precision does not suffice for one. `count`:
    /// spheres to test, 1..kCount; the arrays hold a whole batch. `eye`: relative to the batch's origin.
    /// `rect`: null for none. Requires a single visit.
    static constexpr std::uint32_t kUndecided = 0xFFFFFFFFu;
    [[nodiscard]] std::uint32_t listWithin(const SphereBatch& spheres, const Vec3& eye, const FourEdges* rect,
                                           std::uint32_t first, std::uint32_t count,
                                           std::uint32_t* out) const;
    /// The result of `classify` for each of four spheres. Requires a single visit.
    using QuadContainment = std::array<Containment, SphereQuad::kCount>;
    [[nodiscard]] QuadContainment classifyQuad(const SphereQuad& spheres, const Vec3& eye) const;
    /// The sphere, which is eye-relative, with the tolerances of its tests.
    [[nodiscard]] SeenSphere sphereOf(const Sphere& sphere) const {
        const double distance = std::sqrt(glm::dot(sphere.centre, sphere.centre)) + sphere.radius;
        const double tolerance = kTolerance + kToleranceShare * distance;
        return {sphere.centre, sphere.radius, tolerance, tolerance + 2.0 * pixel_ * distance};
    }

    /// The edges of a rectangle on the screen (a SeenSpace's).
    [[nodiscard]] FourEdges edgesOf(const Rect& rect) const;
    /// Tests a sphere against a rectangle. Outside: no part of the sphere is visible within it.
    [[nodiscard]] static Containment classify(const FourEdges& rect, const SeenSphere& sphere) {
        const double far = sphere.radius + sphere.edgeTolerance, least = rect.least(sphere.centre);
        return least < -far ? Containment::Outside : least > far ? Containment::Inside : Containment::Partial;
    }

private:
    /// Tolerance of a test: metres per metre of distance, and metres. Covers that of the ownership test (1 mm
    /// and a share of the distance) and float rounding on the GPU, with a margin. A sphere is inside only if
    /// it is so by more than the tolerance, and outside only if by more than it.
    static constexpr double kToleranceShare = 2e-6;
    static constexpr double kTolerance = 0.004;
    struct CoversTheGate; ///< asserts it, in Viewcone.cpp
    struct Cone {
        Plane entry;
        std::uint32_t firstEdges = 0, edgesCount = 0, parent = 0;
    };
    /// Tests the visit's region only.
    [[nodiscard]] Containment classifyOnScreen(const Cone& cone, const SeenSphere& sphere) const {
        Containment found = Containment::Inside;
        for (std::uint32_t e = cone.firstEdges; e < cone.firstEdges + cone.edgesCount; ++e) {
            found = std::min(found, classify(edges_[e], sphere));
            if (found == Containment::Outside)
                break;
        }
        return found;
    }
    [[nodiscard]] Containment classifyInVisit(const Cone& cone, const SeenSphere& sphere) const {
        const double beyond = cone.entry.signedDistance(sphere.centre);
        if (beyond < -sphere.radius - sphere.tolerance)
            return Containment::Outside;
        const Containment onScreen = classifyOnScreen(cone, sphere);
        return onScreen == Containment::Inside && beyond <= sphere.radius + sphere.tolerance
                   ? Containment::Partial
                   : onScreen;
    }
    [[nodiscard]] QuadContainment classifyOneByOne(const SphereQuad& spheres, const Vec3& eye) const;
    /// Whether a later visit may own a pixel of a sphere that is inside `visit`.
    [[nodiscard]] bool isCovered(std::uint32_t visit, const SeenSphere& sphere) const;
    [[nodiscard]] bool descends(std::uint32_t visit, std::uint32_t ancestor) const;
    std::vector<Cone> cones_;
    std::vector<FourEdges> edges_; ///< of regions; the last edge is repeated to fill up four
    View view_;
    double pixel_ = 0.0;
    Vectors vectors_;
};

} // namespace limen::visibility
