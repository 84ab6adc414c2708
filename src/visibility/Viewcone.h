#pragma once

#include "geometry/Tolerances.h"
#include "visibility/VisibleSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace limen::visibility {

enum class Containment : std::uint8_t { Outside, Partial, Inside };

/// A ball, eye-relative, with how far it is taken to reach beyond its surface; made by Viewcones::ballOf.
struct SeenSphere {
    Vec3 centre{0.0};
    double radius = 0.0;
    double slack = 0.0; ///< metres, at entry planes
    double reach = 0.0; ///< metres, at planes through the eye: two pixels more
};

/// So many balls side by side, global: where they begin in arrays.
struct FewSpheres {
    static constexpr std::size_t kCount = 4;
    const double* x = nullptr;
    const double* y = nullptr;
    const double* z = nullptr;
    const double* radius = nullptr;
};

/// More, in floats, each no farther along any axis than kMostOffset from a place that they are told from (world::ListedInstances): to the
/// nearest float, so that centres are off by 0.2 mm at most along each axis.
struct SphereBatch {
    static constexpr std::size_t kCount = 16;
    static constexpr double kMostOffset = 4096.0; ///< metres; of radii, too
    const float* x = nullptr;
    const float* y = nullptr;
    const float* z = nullptr;
    const float* radius = nullptr;
};

/// Four planes through the eye: unit normals, positive inside. Side by side, for they are all asked at once.
class FourEdges {
public:
    /// The same in floats.
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
    /// From a point to the plane that it lies farthest outside of, or least far inside.
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

/// What balls are asked about side by side are for (SphereBatch.cpp): each is the same code, told that processors have it.
enum class Vectors : std::uint8_t {
    Any,   ///< what every processor has
    Avx2,  ///< eight floats
    Avx512 ///< sixteen
};
/// The widest that this processor has.
[[nodiscard]] Vectors widestVectors();

/// The visits of one flood as planes, for asking what of a ball can be seen in them. Reuse it: steady frames
/// allocate nothing.
class Viewcones {
public:
    /// `vectors`: no wider than the processor has; the answers are the same.
    explicit Viewcones(Vectors vectors = widestVectors()) : vectors_(vectors) {}
    /// `pixel` is the angle of one pixel in radians: balls are counted as touching a region when they come
    /// that near.
    void prepare(const View& view, const VisibleSet& set, double pixel);

    /// How the ball, eye-relative, lies to a visit's region and entry plane. Inside means more: no part of it
    /// shows in a pixel of another owner in front of it, i.e. it lies wholly within the visit, before the
    /// entry planes of all visits drawn later that it touches on the screen, and those are all below this
    /// visit. Then every fragment of it passes the ownership test, and the test may be left out.
    [[nodiscard]] Containment classify(std::uint32_t visit, const SeenSphere& sphere) const {
        // The root's alone: everything is beyond where the eye is, and nothing is drawn later.
        if (cones_.size() == 1)
            return classifyOnScreen(cones_.front(), sphere);
        const Containment alone = classifyAlone(cones_[visit], sphere);
        return alone == Containment::Inside && isHidden(visit, sphere) ? Containment::Partial : alone;
    }
    /// Which of a block's balls do not lie outside of the root's region, nor of a rectangle if there is one: just what `classify` tells of each.
    /// For many balls, of which nobody can foretell how they lie: they are asked side by side, in floats. Writes `first + i` for each of
    /// them, in order; `out` has room for a whole block. Yields how many they are, or kCannotTell where floats cannot. `count`: of balls,
    /// though as many as a block has are read. `eye`: from where the balls are told from. Requires a single visit.
    static constexpr std::uint32_t kCannotTell = 0xFFFFFFFFu;
    [[nodiscard]] std::uint32_t listWithin(const SphereBatch& spheres, const Vec3& eye, const FourEdges* rect,
                                           std::uint32_t first, std::uint32_t count,
                                           std::uint32_t* out) const;
    /// Of so many, and whether they lie inside. Requires a single visit.
    static constexpr std::size_t kFew = FewSpheres::kCount;
    [[nodiscard]] std::array<Containment, kFew> classifyFew(const FewSpheres& spheres, const Vec3& eye) const;
    /// Of a ball, eye-relative.
    [[nodiscard]] SeenSphere sphereOf(const Sphere& sphere) const {
        const double distance = std::sqrt(glm::dot(sphere.centre, sphere.centre)) + sphere.radius;
        const double slack = kSlack + kSlackShare * distance;
        return {sphere.centre, sphere.radius, slack, slack + 2.0 * pixel_ * distance};
    }

    /// A rectangle (a SeenSpace's) of the screen.
    [[nodiscard]] FourEdges edgesOf(const Rect& rect) const;
    /// How the ball lies to it. Outside: nothing of the ball shows within the rectangle.
    [[nodiscard]] static Containment classify(const FourEdges& rect, const SeenSphere& sphere) {
        const double far = sphere.radius + sphere.reach, least = rect.least(sphere.centre);
        return least < -far ? Containment::Outside : least > far ? Containment::Inside : Containment::Partial;
    }

private:
    /// The ownership test's own tolerance (1 mm and a share of the distance) and float rounding on the GPU, with
    /// room to spare, in metres per metre of distance and in metres: "inside" must hold under it, "outside"
    /// beyond it.
    static constexpr double kSlackShare = 2e-6;
    static constexpr double kSlack = 0.004;
    static_assert(kSlackShare > kEntryPlaneToleranceSlope && kSlack > kEntryPlaneTolerance);
    struct Cone {
        Plane entry;
        std::uint32_t firstEdges = 0, edgesCount = 0, parent = 0;
    };
    /// Where on the screen, however far.
    [[nodiscard]] Containment classifyOnScreen(const Cone& cone, const SeenSphere& sphere) const {
        Containment found = Containment::Inside;
        for (std::uint32_t e = cone.firstEdges; e < cone.firstEdges + cone.edgesCount; ++e) {
            found = std::min(found, classify(edges_[e], sphere));
            if (found == Containment::Outside)
                break;
        }
        return found;
    }
    [[nodiscard]] Containment classifyAlone(const Cone& cone, const SeenSphere& sphere) const {
        const double beyond = cone.entry.signedDistance(sphere.centre);
        if (beyond < -sphere.radius - sphere.slack)
            return Containment::Outside;
        const Containment onScreen = classifyOnScreen(cone, sphere);
        return onScreen == Containment::Inside && beyond <= sphere.radius + sphere.slack
                   ? Containment::Partial
                   : onScreen;
    }
    [[nodiscard]] std::array<Containment, kFew> classifyOneByOne(const FewSpheres& spheres,
                                                                 const Vec3& eye) const;
    /// Of a ball that lies within a visit: whether a part of it may show in another's pixels.
    [[nodiscard]] bool isHidden(std::uint32_t visit, const SeenSphere& sphere) const;
    [[nodiscard]] bool descends(std::uint32_t visit, std::uint32_t ancestor) const;
    std::vector<Cone> cones_;
    std::vector<FourEdges> edges_; ///< of regions; what is left of the last four repeats the last edge
    View view_;
    double pixel_ = 0.0;
    Vectors vectors_;
};

} // namespace limen::visibility
