#include "check/LonePolygon.h"

#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace limen::check {

namespace {

/// Metres. The spacing of floats in a landblock, rounded up: floats of 128 m to 192 m are 0.000015 m apart. A corner
/// stored in block coordinates is off by less than this.
constexpr double kBlockFloatTolerance = 0.00002;
constexpr double kTransformShare = 4e-7; // of the farthest corner's distance: rounding of a float transform
constexpr double kStoredRounding = 0x1p-22; // of the largest inverse depth: rounding of a stored float

/// A triangle relative to an eye, and its plane n·p = offset. n is not unit length.
struct Seen {
    Vec3 a{0.0}, ab{0.0}, ac{0.0}, n{0.0};
    double offset = 0.0;

    Seen(const Triangle& triangle, const Vec3& eye)
        : a(triangle.corners[0] - eye), ab(triangle.corners[1] - triangle.corners[0]),
          ac(triangle.corners[2] - triangle.corners[0]), n(glm::cross(ab, ac)), offset(glm::dot(n, a)) {}
};

/// Directions through the corners of the square of half-width kSnapTolerance around a place,
/// counter-clockwise as seen.
std::array<Vec3, 4> squareAround(const reference::Camera& camera, double x, double y) {
    const auto at = [&](double dx, double dy) {
        return reference::rayThrough(camera, x + dx * kSnapTolerance, y + dy * kSnapTolerance).direction;
    };
    return {at(-1, 1), at(1, 1), at(1, -1), at(-1, -1)};
}

/// The part of the triangle ahead of the eye inside the pyramid over the square, relative to the eye.
std::vector<Vec3> partWithin(const Seen& seen, const std::array<Vec3, 4>& square) {
    std::vector<Vec3> part{seen.a, seen.a + seen.ab, seen.a + seen.ac}, clipped;
    for (std::size_t i = 0; i < square.size(); ++i) {
        const Vec3 inward = glm::normalize(glm::cross(square[(i + 1) % square.size()], square[i]));
        const Vec3 middle = square[0] + square[2];
        clipPolygon(part, {glm::dot(inward, middle) > 0.0 ? inward : -inward, 0.0}, 0.0, clipped);
        part.swap(clipped);
    }
    return part; // the four planes pass through the eye, so the part is ahead
}

bool reaches(const Seen& seen, const std::array<Vec3, 4>& square) {
    return !partWithin(seen, square).empty();
}

double farthestCorner(const Seen& seen) {
    return std::max({glm::length(seen.a), glm::length(seen.a + seen.ab), glm::length(seen.a + seen.ac)});
}

/// Metres by which floats may move any of the triangle across the eye's rays.
double transformRounding(const Seen& seen) {
    return kTransformShare * farthestCorner(seen);
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

/// Affine in the place on the screen: the corners bound it.
Range over(const Seen& seen, const std::array<Vec3, 4>& square) {
    Range range;
    for (const Vec3& direction : square)
        range.include(glm::dot(seen.n, direction));
    return range;
}

Range overPicture(const Seen& seen, const reference::Camera& camera) {
    Range range;
    const double right = camera.width - 0.5, bottom = camera.height - 0.5;
    for (const double x : {-0.5, right})
        for (const double y : {-0.5, bottom})
            range.include(glm::dot(seen.n, reference::rayThrough(camera, x, y).direction));
    return range;
}

bool triangleMayHaveDepth(const Seen& seen, const reference::Camera& camera, int x, int y, double drawn) {
    const std::array<Vec3, 4> square = squareAround(camera, x, y);
    const Range facing = over(seen, square);
    // On the plane n·d = offset / t: all terms in units of n.
    const double wanted = seen.offset / drawn;
    const double slack = kDepthShareTolerance * std::abs(wanted) +
                         glm::length(seen.n) * (transformRounding(seen) + kBlockFloatTolerance) / drawn +
                         kStoredRounding * overPicture(seen, camera).farthest();
    if (!(wanted >= facing.low - slack && wanted <= facing.high + slack))
        return false;
    return reaches(seen, square);
}

} // namespace

bool coversEdgeOn(std::span<const Triangle> polygon, const reference::Camera& camera, double x, double y,
                  double shown) {
    const std::array<Vec3, 4> square = squareAround(camera, x, y);
    bool covered = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : polygon) {
        const Seen seen(triangle, camera.eye);
        covered = covered || reaches(seen, square);
        const Range facing = over(seen, square);
        // t = offset / (n·d): nearest where n·d is farthest from 0 on the side of offset.
        const double steepest = seen.offset > 0.0 ? facing.high : -facing.low;
        if (steepest > 0.0)
            nearest = std::min(nearest, std::abs(seen.offset) / steepest);
    }
    return covered && (nearest <= shown || !std::isfinite(shown));
}

double outlineRounding(std::span<const Triangle> polygon, const reference::Camera& camera, double x,
                       double y) {
    const std::array<Vec3, 4> square = squareAround(camera, x, y);
    const double pixel = 2.0 * std::min(camera.tanHalfX / camera.width, camera.tanHalfY / camera.height);
    double most = 0.0;
    for (const Triangle& triangle : polygon) {
        const Seen seen(triangle, camera.eye);
        for (const Vec3& corner : partWithin(seen, square)) {
            const double pixelThere = pixel * glm::dot(corner, camera.forward);
            most = std::max(most, transformRounding(seen) / std::max(pixelThere, transformRounding(seen)));
        }
    }
    return std::min(most, kSnapTolerance);
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
