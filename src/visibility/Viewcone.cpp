#include "visibility/Viewcone.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// The ownership test's own tolerance (1 mm and a share of the distance) and float rounding on the GPU, with
/// room to spare, in metres per metre of distance and in metres: "inside" must hold under it, "outside"
/// beyond it.
constexpr double kSlackShare = 2e-6;
constexpr double kSlack = 0.004;

} // namespace

void Viewcones::prepare(const View& view, const VisibleSet& set, double pixel) {
    view_ = view;
    pixel_ = pixel;
    cones_.clear();
    edges_.clear();
    const Mat3 normals = glm::transpose(view.screenFromEye());
    for (const Visit& visit : set.visits) {
        Cone cone{visit.entryPlane, static_cast<std::uint32_t>(edges_.size()), visit.vertexCount,
                  visit.parent};
        if (visit.depth == 0) {
            cone.entry = {Vec3(0.0), 1e30}; // everything is beyond where the eye is
        }
        const auto region = set.region(visit);
        for (std::size_t i = 0; i < region.size(); ++i) {
            const Vec3 n = normals * glm::cross(region[i], region[(i + 1) % region.size()]);
            const double length = std::sqrt(glm::dot(n, n));
            edges_.push_back(length > 0.0 ? n / length : Vec3(0.0));
        }
        cones_.push_back(cone);
    }
}

Containment Viewcones::classifyAlone(const Cone& cone, const Sphere& ball) const {
    const double distance = std::sqrt(glm::dot(ball.centre, ball.centre)) + ball.radius;
    const double slack = kSlack + kSlackShare * distance;
    const double reach = cone.entry.signedDistance(ball.centre);
    if (reach < -ball.radius - slack) {
        return Containment::Outside;
    }
    bool inside = reach > ball.radius + slack;
    const double pixels = slack + 2.0 * pixel_ * distance;
    for (std::uint32_t e = cone.firstEdge; e < cone.firstEdge + cone.edgeCount; ++e) {
        const double side = glm::dot(edges_[e], ball.centre);
        if (side < -ball.radius - pixels) {
            return Containment::Outside;
        }
        inside = inside && side > ball.radius + pixels;
    }
    return inside ? Containment::Inside : Containment::Partial;
}

bool Viewcones::descends(std::uint32_t visit, std::uint32_t ancestor) const {
    while (visit > ancestor) { // parents come before children
        visit = cones_[visit].parent;
    }
    return visit == ancestor;
}

Containment Viewcones::classify(std::uint32_t visit, const Sphere& ball) const {
    const Containment alone = classifyAlone(cones_[visit], ball);
    if (alone != Containment::Inside) {
        return alone;
    }
    const double slack = kSlack + kSlackShare * (std::sqrt(glm::dot(ball.centre, ball.centre)) + ball.radius);
    for (std::uint32_t later = visit + 1; later < cones_.size(); ++later) {
        Cone onScreen = cones_[later];
        onScreen.entry = {Vec3(0.0), 1e30}; // where on the screen, however far
        if (classifyAlone(onScreen, ball) == Containment::Outside) {
            continue;
        }
        const bool before = cones_[later].entry.signedDistance(ball.centre) < -ball.radius - slack;
        if (!before || !descends(later, visit)) {
            return Containment::Partial;
        }
    }
    return Containment::Inside;
}

bool Viewcones::touches(const Rect& rect, const Sphere& ball) const {
    const double distance = std::sqrt(glm::dot(ball.centre, ball.centre)) + ball.radius;
    const double margin = ball.radius + kSlack + (kSlackShare + 2.0 * pixel_) * distance;
    const Mat3 screen = view_.screenFromEye();
    const Vec3 right(screen[0][0], screen[1][0], screen[2][0]);
    const Vec3 up(screen[0][1], screen[1][1], screen[2][1]);
    const auto behind = [&](const Vec3& n) {
        return glm::dot(n, ball.centre) < -margin * std::sqrt(glm::dot(n, n));
    };
    return !(behind(right - view_.forward * rect.minX) || behind(view_.forward * rect.maxX - right) ||
             behind(up - view_.forward * rect.minY) || behind(view_.forward * rect.maxY - up));
}

} // namespace limen::visibility
