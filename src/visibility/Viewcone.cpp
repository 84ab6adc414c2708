#include "visibility/Viewcone.h"

#include "geometry/Tolerances.h"

#include <algorithm>

namespace limen::visibility {

struct Viewcones::CoversTheGate {
    static_assert(kToleranceShare > kEntryPlaneToleranceSlope && kTolerance > kInPlaneTolerance);
};

void Viewcones::prepare(const View& view, const VisibleSet& set, double pixel) {
    view_ = view;
    pixel_ = pixel;
    cones_.clear();
    edges_.clear();
    const Mat3 normals = glm::transpose(view.screenFromEye());
    for (const Visit& visit : set.visits) {
        Cone cone{visit.entryPlane, static_cast<std::uint32_t>(edges_.size()), (visit.vertexCount + 3) / 4,
                  visit.parent};
        if (visit.depth == 0)
            cone.entry = {Vec3(0.0), 1e30}; // the root has no entry plane
        const auto region = set.region(visit);
        edges_.resize(edges_.size() + cone.edgesCount);
        for (std::size_t i = 0; i < std::size_t{4} * cone.edgesCount; ++i) {
            const std::size_t edge = std::min(i, region.size() - 1);
            const Vec3 n = normals * glm::cross(region[edge], region[(edge + 1) % region.size()]);
            const double length = std::sqrt(glm::dot(n, n));
            edges_[cone.firstEdges + i / 4].set(i % 4, length > 0.0 ? n / length : Vec3(0.0));
        }
        cones_.push_back(cone);
    }
}

bool Viewcones::descends(std::uint32_t visit, std::uint32_t ancestor) const {
    while (visit > ancestor) // parents come before children
        visit = cones_[visit].parent;
    return visit == ancestor;
}

bool Viewcones::isCovered(std::uint32_t visit, const SeenSphere& sphere) const {
    for (std::uint32_t later = visit + 1; later < cones_.size(); ++later) {
        const Cone& cone = cones_[later];
        if (classifyOnScreen(cone, sphere) == Containment::Outside)
            continue;
        const bool before = cone.entry.signedDistance(sphere.centre) < -sphere.radius - sphere.tolerance;
        if (!before || !descends(later, visit))
            return true;
    }
    return false;
}

FourEdges Viewcones::edgesOf(const Rect& rect) const {
    const Mat3 screen = view_.screenFromEye();
    const Vec3 right(screen[0][0], screen[1][0], screen[2][0]);
    const Vec3 up(screen[0][1], screen[1][1], screen[2][1]);
    FourEdges edges;
    edges.set(0, glm::normalize(right - view_.forward * rect.minX));
    edges.set(1, glm::normalize(view_.forward * rect.maxX - right));
    edges.set(2, glm::normalize(up - view_.forward * rect.minY));
    edges.set(3, glm::normalize(view_.forward * rect.maxY - up));
    return edges;
}

} // namespace limen::visibility
