#include "viewer/inspect/FrozenFlood.h"

#include "engine/Projection.h"

#include <algorithm>

namespace limen::viewer {
namespace {

constexpr double kFarthest = 1e4;  // metres from the flood's eye, the limit for openings seen nearly edge-on
constexpr double kParallel = 1e-9; // cosine of a ray parallel to the opening, which enters at the eye

/// The distance along a unit vector at which a ray of the region enters the visit, metres.
double entryAlong(const visibility::Visit& visit, const Vec3& direction) {
    const double towards = glm::dot(visit.entryPlane.n, direction);
    return towards > kParallel ? std::clamp(-visit.entryPlane.d / towards, 0.0, kFarthest) : 0.0;
}

struct Edge {
    Vec3 start{0.0}, end{0.0}; ///< global
};

std::vector<Edge> edgesOf(const FrozenFlood& flood, const visibility::Visit& visit, double metres) {
    const visibility::View& view = flood.view;
    std::vector<Edge> edges;
    for (const Vec3& corner : flood.visible.region(visit)) {
        const Vec3 way = view.right * (corner.x * view.tanHalfX) + view.up * (corner.y * view.tanHalfY) +
                         view.forward * corner.z;
        const double length = glm::length(way);
        if (!(length > 0.0))
            continue; // a corner at the eye
        const double entry = entryAlong(visit, way / length);
        edges.push_back({view.eye + way * (entry / length), view.eye + way * ((entry + metres) / length)});
    }
    return edges;
}

} // namespace

std::vector<PyramidLine> pyramidLines(const FrozenFlood& flood, const visibility::View& eye, double metres) {
    std::vector<PyramidLine> lines;
    for (std::uint32_t v = 0; v < flood.visible.visits.size(); ++v) {
        const std::vector<Edge> edges = edgesOf(flood, flood.visible.visits[v], metres);
        const auto add = [&](const Vec3& a, const Vec3& b) {
            if (const auto line = engine::projectLine(a, b, eye))
                lines.push_back({line->first, line->second, v});
        };
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Edge& next = edges[(i + 1) % edges.size()];
            add(edges[i].start, next.start);
            add(edges[i].start, edges[i].end);
            add(edges[i].end, next.end);
        }
    }
    return lines;
}

} // namespace limen::viewer
