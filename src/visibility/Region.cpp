#include "visibility/Region.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace limen::visibility {

void clipByEyePlane(std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out) {
    out.clear();
    if (polygon.empty())
        return;
    Vec3 previous = polygon.back();
    double previousSide = glm::dot(normal, previous);
    for (const Vec3& current : polygon) {
        const double side = glm::dot(normal, current);
        if ((side >= 0.0) != (previousSide >= 0.0))
            out.push_back(previous + (current - previous) * (previousSide / (previousSide - side)));
        if (side >= 0.0)
            out.push_back(current);
        previous = current;
        previousSide = side;
    }
}

double coneSize(std::span<const Vec3> region) {
    Vec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < region.size(); ++i)
        sum += glm::cross(region[i] - region[0], region[i + 1] - region[0]);
    return std::sqrt(glm::dot(sum, sum));
}

void tidyRegion(std::vector<Vec3>& region) {
    for (Vec3& v : region) {
        const double length = std::sqrt(glm::dot(v, v));
        v = length > 0.0 ? v / length : v;
    }
    // Vertices closer than 10⁻¹² rad are equal but for rounding, and an edge between them would have no
    // direction.
    const auto same = [](const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b) < 1e-24; };
    region.erase(std::unique(region.begin(), region.end(), same), region.end());
    while (region.size() > 1 && same(region.front(), region.back()))
        region.pop_back();
    if (region.size() < 3 || coneSize(region) < kEmptyCone)
        region.clear();
}

namespace {

/// Clips a polygon by one plane after the other, on the stack. Writes nothing for planes that do not cut it.
class StackClipper {
public:
    static constexpr std::size_t kMost = 32; ///< vertices before a clip

    explicit StackClipper(std::span<const Vec3> polygon) : from_(polygon.data()), count_(polygon.size()) {}

    /// As clipByEyePlane. False, without a change, for more than kMost vertices.
    [[nodiscard]] bool clip(const Vec3& normal) {
        if (count_ > kMost)
            return false;
        std::array<double, kMost> sides;
        Bits inside = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            sides[i] = glm::dot(normal, from_[i]);
            inside |= static_cast<Bits>(sides[i] >= 0.0) << i;
        }
        if (inside == 0)
            count_ = 0;
        else if (inside != allBits())
            cut(sides, inside);
        return true;
    }
    [[nodiscard]] std::span<const Vec3> result() const { return {from_, count_}; }

private:
    using Bits = std::uint32_t; ///< by vertex

    [[nodiscard]] Bits allBits() const { return ~Bits{0} >> (kMost - count_); }

    void cut(const std::array<double, kMost>& sides, Bits inside) {
        const Bits changes = inside ^ (inside << 1 | inside >> (count_ - 1));
        Vec3* const to = from_ == first_.data() ? second_.data() : first_.data();
        std::size_t found = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            if ((changes >> i & 1) != 0) {
                const std::size_t p = i == 0 ? count_ - 1 : i - 1;
                to[found++] = from_[p] + (from_[i] - from_[p]) * (sides[p] / (sides[p] - sides[i]));
            }
            to[found] = from_[i]; // overwritten if it is outside
            found += inside >> i & 1;
        }
        from_ = to;
        count_ = found;
    }

    /// Without a constructor, which would clear all elements.
    union Buffer {
        Buffer() {} // NOLINT(modernize-use-equals-default): that would be deleted
        Vec3* data() { return vertices.data(); }
        std::array<Vec3, 2 * kMost + 1> vertices; ///< a cut adds at most one vertex to each
    };
    const Vec3* from_;
    std::size_t count_;
    Buffer first_, second_;
};

} // namespace

void clipByRegion(std::span<const Vec3> polygon, std::span<const Vec3> region, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap) {
    // Each edge adds at most one vertex. The swaps may leave the result in either vector, so both get the
    // full capacity: then the next equal frame allocates nothing.
    out.reserve(polygon.size() + region.size());
    swap.reserve(polygon.size() + region.size());
    const auto edge = [&](std::size_t i) {
        return glm::cross(region[i], region[i + 1 == region.size() ? 0 : i + 1]);
    };
    StackClipper clipper(polygon);
    std::size_t i = 0;
    while (i < region.size() && !clipper.result().empty() && clipper.clip(edge(i)))
        ++i;
    out.assign(clipper.result().begin(), clipper.result().end());
    for (; i < region.size() && !out.empty(); ++i) { // too many vertices for the stack
        clipByEyePlane(out, edge(i), swap);
        out.swap(swap);
    }
    tidyRegion(out);
}

Rect boundsOf(std::span<const Vec3> region) {
    Rect rect;
    for (const Vec3& v : region) {
        // On the eye plane only the signs of x and y are known, so the screen's edge is used.
        const double x = v.z > 0.0 ? std::clamp(v.x / v.z, -1.0, 1.0) : (v.x > 0.0 ? 1.0 : -1.0);
        const double y = v.z > 0.0 ? std::clamp(v.y / v.z, -1.0, 1.0) : (v.y > 0.0 ? 1.0 : -1.0);
        rect.minX = std::min(rect.minX, x);
        rect.maxX = std::max(rect.maxX, x);
        rect.minY = std::min(rect.minY, y);
        rect.maxY = std::max(rect.maxY, y);
    }
    return rect;
}

} // namespace limen::visibility
