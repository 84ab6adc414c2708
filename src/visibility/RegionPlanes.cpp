#include "visibility/RegionPlanes.h"

#include "visibility/Region.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace limen::visibility {

namespace {

const std::array<Vec3, 4> kScreen{Vec3(-1, -1, 1), Vec3(1, -1, 1), Vec3(1, 1, 1), Vec3(-1, 1, 1)};

/// The area, in NDC, of the part of the screen inside all edges but one.
double areaWithout(std::span<const Vec3> edges, std::size_t omitted) {
    std::vector<Vec3> part(kScreen.begin(), kScreen.end()), next;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i == omitted)
            continue;
        clipByEyePlane(part, edges[i], next);
        part.swap(next);
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Vec3 &a = part[i], &b = part[i + 1 == part.size() ? 0 : i + 1];
        twice += a.x * b.y - a.y * b.x; // w is 1: a part of the screen
    }
    return std::abs(twice) / 2.0;
}

/// Whether the whole screen is inside the edge, but for rounding.
bool isAlongTheScreen(const Vec3& edge) {
    return std::all_of(kScreen.begin(), kScreen.end(), [&](const Vec3& corner) {
        return glm::dot(edge, corner) >= -1e-12 * glm::length(edge);
    });
}

} // namespace

void clipPlanesOf(std::span<const Vec3> region, const View& view, std::size_t most, std::vector<Plane>& out) {
    out.clear();
    std::vector<Vec3> edges;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const Vec3 edge = glm::cross(region[i], region[i + 1 == region.size() ? 0 : i + 1]);
        if (glm::dot(edge, edge) > 0.0)
            edges.push_back(edge);
    }
    if (edges.size() > most)
        std::erase_if(edges, isAlongTheScreen);
    while (edges.size() > most) {
        std::size_t best = 0;
        double least = areaWithout(edges, 0);
        for (std::size_t i = 1; i < edges.size(); ++i) {
            const double area = areaWithout(edges, i);
            if (area < least) {
                best = i;
                least = area;
            }
        }
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(best));
    }
    const Mat3 normals = glm::transpose(view.screenFromEye());
    for (const Vec3& edge : edges) {
        const Vec3 n = glm::normalize(normals * edge);
        out.push_back({n, -glm::dot(n, view.eye)});
    }
}

void trianglesOf(std::span<const Vec3> region, std::vector<Vec4f>& out) {
    out.clear();
    const auto position = [](const Vec3& corner) {
        return Vec4f(static_cast<float>(corner.x), static_cast<float>(corner.y), 0.0f,
                     static_cast<float>(corner.z));
    };
    for (std::size_t i = 2; i < region.size(); ++i)
        out.insert(out.end(), {position(region[0]), position(region[i - 1]), position(region[i])});
}

} // namespace limen::visibility
