#include "world/mesh/Triangulate.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Tolerances.h"

#include <algorithm>
#include <numeric>

namespace limen::world {
namespace {

/// Metres. An ear whose diagonal passes a corner within this distance would leave a sliver. A little more
/// than the weld tolerance, the greatest distance of a stitched corner from its edge.
constexpr double kClearance = 0.00025;
static_assert(kClearance > kWeldTolerance);
/// Triangles lower than this come from rounding alone; metres.
constexpr double kFlat = 1e-7;

double cross(const Vec2& a, const Vec2& b) {
    return a.x * b.y - a.y * b.x;
}

class EarClipper {
public:
    EarClipper(std::vector<Vec2> points, std::vector<TriangleCorners>& out)
        : points_(std::move(points)), ring_(points_.size()), quality_(points_.size()), out_(out) {
        std::iota(ring_.begin(), ring_.end(), 0u);
    }

    void run() {
        rate(kClearance);
        while (ring_.size() > 3) {
            std::size_t best = bestEar();
            // First rate again, since the corners that blocked an ear may be cut by now. Then accept smaller
            // clearances, so that thin polygons are completed, too.
            for (const double clearance : {kClearance, 0.0, -1.0}) {
                if (quality_[best] > 0.0)
                    break;
                rate(clearance);
                best = bestEar();
            }
            if (quality_[best] <= 0.0)
                return;
            cut(best);
        }
        if (ring_.size() == 3 && altitude(0) > 0.0)
            out_.push_back({ring_[0], ring_[1], ring_[2]});
    }

private:
    [[nodiscard]] std::size_t before(std::size_t i) const { return i == 0 ? ring_.size() - 1 : i - 1; }
    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 == ring_.size() ? 0 : i + 1; }
    [[nodiscard]] const Vec2& at(std::size_t i) const { return points_[ring_[i]]; }

    /// The smallest altitude of the triangle at a corner. Zero or negative if the corner is flat or reflex.
    [[nodiscard]] double altitude(std::size_t i) const {
        const Vec2 a = at(before(i)), b = at(i), c = at(after(i));
        const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
        return longest > 0.0 ? cross(b - a, c - a) / longest : 0.0;
    }

    [[nodiscard]] bool isClear(std::size_t i, double clearance) const {
        const std::size_t p = before(i), n = after(i);
        const Vec2 corners[3] = {at(p), at(i), at(n)};
        Vec2 inward[3];
        for (int k = 0; k < 3; ++k) {
            const Vec2 edge = corners[(k + 1) % 3] - corners[k];
            inward[k] = Vec2(-edge.y, edge.x) / std::max(glm::length(edge), 1e-300);
        }
        for (std::size_t j = 0; j < ring_.size(); ++j) {
            if (j == p || j == i || j == n)
                continue;
            bool inside = true;
            for (int k = 0; k < 3 && inside; ++k)
                inside = glm::dot(at(j) - corners[k], inward[k]) >= -clearance;
            if (inside)
                return false;
        }
        return true;
    }

    /// The altitude of an ear, 0 for a corner that is none. A negative clearance accepts every convex corner.
    [[nodiscard]] double rated(std::size_t i, double clearance) const {
        const double height = altitude(i);
        if (height <= (clearance < 0.0 ? 0.0 : kFlat))
            return 0.0;
        return clearance < 0.0 || isClear(i, clearance) ? height : 0.0;
    }

    void rate(double clearance) {
        for (std::size_t i = 0; i < ring_.size(); ++i)
            quality_[i] = rated(i, clearance);
    }

    [[nodiscard]] std::size_t bestEar() const {
        return static_cast<std::size_t>(std::max_element(quality_.begin(), quality_.end()) -
                                        quality_.begin());
    }

    void cut(std::size_t i) {
        LIMEN_ASSERT(i < ring_.size() && ring_.size() == quality_.size(), "a rating for each corner left");
        out_.push_back({ring_[before(i)], ring_[i], ring_[after(i)]});
        ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(i));
        quality_.erase(quality_.begin() + static_cast<std::ptrdiff_t>(i));
        const std::size_t n = i == ring_.size() ? 0 : i;
        quality_[n] = rated(n, kClearance);
        quality_[before(n)] = rated(before(n), kClearance);
    }

    std::vector<Vec2> points_;
    std::vector<std::uint32_t> ring_; ///< the corners that remain
    std::vector<double> quality_;     ///< by position in ring_
    std::vector<TriangleCorners>& out_;
};

} // namespace

void triangulate(std::span<const Vec3> points, std::vector<TriangleCorners>& out) {
    const Vec3 n = planeOf(points).n;
    if (n != Vec3(0.0))
        triangulate(points, n, out);
}

void triangulate(std::span<const Vec3> points, const Vec3& n, std::vector<TriangleCorners>& out) {
    const Vec3 helper = std::abs(n.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(helper, n)), v = glm::cross(n, u);
    std::vector<Vec2> flat;
    flat.reserve(points.size());
    for (const Vec3& p : points)
        flat.emplace_back(glm::dot(p - points[0], u), glm::dot(p - points[0], v));
    EarClipper(std::move(flat), out).run();
}

} // namespace limen::world
