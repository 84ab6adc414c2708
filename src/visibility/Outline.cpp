#include "visibility/Outline.h"

#include "geometry/ConvexPolygon.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// True if `p` is outside the edge from `a` to `b` of a polygon that is counter-clockwise from the eye, the
/// origin.
bool isOutside(const Vec3& a, const Vec3& p, const Vec3& b) {
    return glm::dot(glm::cross(a, b), p) > 0.0;
}

/// The index of a vertex inside the edge between its neighbours, or the polygon's size.
std::size_t findDent(std::span<const Vec3> polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        if (!isOutside(polygon[i == 0 ? n - 1 : i - 1], polygon[i], polygon[i + 1 == n ? 0 : i + 1]))
            return i;
    return n;
}

} // namespace

void hullSeenFrom(const Vec3& eye, std::span<const Vec3> polygon, const Vec3& normal, std::vector<Vec3>& out,
                  std::vector<Vec3>& swap) {
    out.clear();
    for (const Vec3& vertex : polygon)
        out.push_back(vertex - eye);
    const auto isBefore = [&](const Vec3& v) { return glm::dot(normal, v) < 0.0; };
    if (!std::all_of(out.begin(), out.end(), isBefore)) {
        swap.swap(out);
        clipPolygon(swap, {-normal, 0.0}, 0.0, out);
        return;
    }
    for (std::size_t dent = findDent(out); out.size() > 3 && dent < out.size(); dent = findDent(out))
        out.erase(out.begin() + static_cast<std::ptrdiff_t>(dent));
}

} // namespace limen::visibility
