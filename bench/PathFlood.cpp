#include "PathFlood.h"

#include "geometry/ConvexPolygon.h"

namespace limen::bench {

std::uint32_t PathFlood::run(const visibility::Graph& graph, const visibility::View& view) {
    graph_ = &graph;
    eye_ = view.eye;
    admitted_ = 0;
    seen_.assign(graph.spaces().size(), 0);
    const auto side = [&](const Vec3& n) { return Plane{glm::normalize(n), 0.0}; };
    const std::vector<Plane> screen{
        side(view.right + view.forward * view.tanHalfX), side(view.forward * view.tanHalfX - view.right),
        side(view.up + view.forward * view.tanHalfY), side(view.forward * view.tanHalfY - view.up)};
    enter(view.root, nullptr, screen);
    return admitted_;
}

void PathFlood::enter(std::uint32_t index, const Step* path, const std::vector<Plane>& planes) {
    seen_[index] = 1;
    const visibility::Graph::Space& space = graph_->spaces()[index];
    for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
        const visibility::Graph::Portal& portal = graph_->portals()[p];
        if (portal.plane.signedDistance(eye_) <= 0.0)
            continue;
        bool walked = false;
        for (const Step* s = path; s != nullptr && !walked; s = s->previous)
            walked = s->portal == p;
        if (walked)
            continue;
        std::vector<Vec3> winding;
        std::vector<Vec3> clipped;
        for (const Vec3& v : graph_->polygon(portal))
            winding.push_back(v - eye_);
        for (const Plane& plane : planes) {
            clipPolygon(winding, plane, 0.0, clipped);
            winding.swap(clipped);
        }
        if (winding.size() < 3)
            continue;
        ++admitted_;
        std::vector<Plane> next;
        for (std::size_t i = 0; i < winding.size(); ++i) {
            const Vec3 n = glm::cross(winding[(i + 1) % winding.size()], winding[i]);
            const double length = glm::length(n);
            if (length > 1e-12)
                next.push_back({n / length, 0.0});
        }
        // The edges are counter-clockwise seen from the eye: the middle of the opening is inside.
        Vec3 middle(0.0);
        for (const Vec3& v : winding)
            middle += v;
        for (Plane& plane : next)
            plane = plane.signedDistance(middle) < 0.0 ? plane.flipped() : plane;
        const Step step{path, p};
        enter(portal.destination, &step, next);
    }
}

} // namespace limen::bench
