#include "visibility/Viewcone.h"

#include <algorithm>
#include <limits>

namespace limen::visibility {

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

// Where on the screen, however far.
inline Containment Viewcones::classifyOnScreen(const Cone& cone, const SeenBall& ball) const {
    const double far = ball.radius + ball.reach;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t e = cone.firstEdge; e < cone.firstEdge + cone.edgeCount; ++e) {
        least = std::min(least, glm::dot(edges_[e], ball.centre));
        if (least < -far) {
            return Containment::Outside;
        }
    }
    return least > far ? Containment::Inside : Containment::Partial;
}

inline Containment Viewcones::classifyAlone(const Cone& cone, const SeenBall& ball) const {
    const double reach = cone.entry.signedDistance(ball.centre);
    if (reach < -ball.radius - ball.slack) {
        return Containment::Outside;
    }
    const Containment onScreen = classifyOnScreen(cone, ball);
    return onScreen == Containment::Inside && reach <= ball.radius + ball.slack ? Containment::Partial
                                                                                : onScreen;
}

bool Viewcones::descends(std::uint32_t visit, std::uint32_t ancestor) const {
    while (visit > ancestor) { // parents come before children
        visit = cones_[visit].parent;
    }
    return visit == ancestor;
}

Containment Viewcones::classify(std::uint32_t visit, const SeenBall& ball) const {
    const Containment alone = classifyAlone(cones_[visit], ball);
    if (alone != Containment::Inside) {
        return alone;
    }
    for (std::uint32_t later = visit + 1; later < cones_.size(); ++later) {
        const Cone& cone = cones_[later];
        if (classifyOnScreen(cone, ball) == Containment::Outside) {
            continue;
        }
        const bool before = cone.entry.signedDistance(ball.centre) < -ball.radius - ball.slack;
        if (!before || !descends(later, visit)) {
            return Containment::Partial;
        }
    }
    return Containment::Inside;
}

RectCone Viewcones::coneOf(const Rect& rect) const {
    const Mat3 screen = view_.screenFromEye();
    const Vec3 right(screen[0][0], screen[1][0], screen[2][0]);
    const Vec3 up(screen[0][1], screen[1][1], screen[2][1]);
    return {{glm::normalize(right - view_.forward * rect.minX),
             glm::normalize(view_.forward * rect.maxX - right), glm::normalize(up - view_.forward * rect.minY),
             glm::normalize(view_.forward * rect.maxY - up)}};
}

Containment Viewcones::classify(const RectCone& rect, const SeenBall& ball) {
    const double far = ball.radius + ball.reach;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& inwards : rect.inwards) {
        least = std::min(least, glm::dot(inwards, ball.centre));
    }
    return least < -far ? Containment::Outside : least > far ? Containment::Inside : Containment::Partial;
}

} // namespace limen::visibility
