#include "check/LonePolygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace limen::check {

namespace {

constexpr double kSnap = 1.0 / 128.0;       // pixels
constexpr double kDepthShare = 1e-4;        // of the depth
constexpr double kTransformShare = 4e-7;    // of the farthest corner's distance
constexpr double kBlockFloat = 2e-5;        // metres
constexpr double kStoredRounding = 0x1p-22; // of the largest inverse depth

/// A triangle relative to an eye, and its plane n·p = offset. n is not unit length.
struct Seen {
    Vec3 a{0.0}, ab{0.0}, ac{0.0}, n{0.0};
    double offset = 0.0;

    Seen(const Triangle& triangle, const Vec3& eye)
        : a(triangle.corners[0] - eye), ab(triangle.corners[1] - triangle.corners[0]),
          ac(triangle.corners[2] - triangle.corners[0]), n(glm::cross(ab, ac)), offset(glm::dot(n, a)) {}

    /// Where a direction meets the triangle, from either side (Möller, Trumbore 1997); behind the eye too.
    [[nodiscard]] std::optional<double> meet(const Vec3& d) const {
        const Vec3 p = glm::cross(d, ac);
        const double det = glm::dot(ab, p);
        if (det == 0.0)
            return std::nullopt;
        const double u = -glm::dot(a, p) / det;
        const Vec3 q = glm::cross(-a, ab);
        const double v = glm::dot(d, q) / det;
        if (u < 0.0 || v < 0.0 || u + v > 1.0)
            return std::nullopt;
        return glm::dot(ac, q) / det;
    }
};

/// Visits directions of a grid of (2·reach + 1)² rays over the square of half-width kSnap around a pixel's centre.
template <class Visit>
void forGrid(const reference::Camera& camera, int x, int y, int reach, Visit visit) {
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx)
            visit(reference::rayThrough(camera, x + dx * kSnap / reach, y + dy * kSnap / reach).direction);
    }
}

/// The range of n·d over some directions.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void include(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
    [[nodiscard]] double farthest() const { return std::max(std::abs(low), std::abs(high)); }
};

Range overPicture(const Seen& seen, const reference::Camera& camera) {
    Range range;
    const double right = camera.width - 0.5, bottom = camera.height - 0.5;
    for (const double x : {-0.5, right}) {
        for (const double y : {-0.5, bottom})
            range.include(glm::dot(seen.n, reference::rayThrough(camera, x, y).direction));
    }
    return range;
}

bool triangleMayHaveDepth(const Seen& seen, const reference::Camera& camera, int x, int y, double drawn) {
    Range facing; // affine: the corners of the square bound it
    forGrid(camera, x, y, 1, [&](const Vec3& d) { facing.include(glm::dot(seen.n, d)); });
    // On the plane n·d = offset / t: all terms in units of n.
    const double wanted = seen.offset / drawn;
    const double reach =
        std::max({glm::length(seen.a), glm::length(seen.a + seen.ab), glm::length(seen.a + seen.ac)});
    const double slack = kDepthShare * std::abs(wanted) +
                         glm::length(seen.n) * (kTransformShare * reach + kBlockFloat) / drawn +
                         kStoredRounding * overPicture(seen, camera).farthest();
    if (!(wanted >= facing.low - slack && wanted <= facing.high + slack))
        return false;
    bool covers = false;
    forGrid(camera, x, y, 4, [&](const Vec3& d) { covers = covers || seen.meet(d).has_value(); });
    return covers;
}

} // namespace

bool coversEdgeOn(std::span<const Triangle> polygon, const reference::Camera& camera, int x, int y,
                  double shown) {
    bool covered = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : polygon) {
        const Seen seen(triangle, camera.eye);
        forGrid(camera, x, y, 16, [&](const Vec3& d) {
            covered = covered || seen.meet(d).has_value();
            const double t = seen.offset / glm::dot(seen.n, d);
            if (t > 0.0)
                nearest = std::min(nearest, t);
        });
    }
    return covered && (nearest <= shown || !std::isfinite(shown));
}

bool mayHaveDepth(std::span<const Triangle> polygon, const reference::Camera& camera, int x, int y,
                  double drawn) {
    if (!(drawn > 0.0) || !std::isfinite(drawn))
        return false;
    return std::any_of(polygon.begin(), polygon.end(), [&](const Triangle& triangle) {
        return triangleMayHaveDepth(Seen(triangle, camera.eye), camera, x, y, drawn);
    });
}

} // namespace limen::check
