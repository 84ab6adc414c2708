#pragma once

#include "visibility/VisibleSet.h"

#include <array>
#include <cmath>
#include <vector>

namespace limen::visibility {

enum class Containment : std::uint8_t { Outside, Partial, Inside };

/// A ball, eye-relative, with how far it is taken to reach beyond its surface; made by Viewcones::ballOf.
struct SeenBall {
    Vec3 centre{0.0};
    double radius = 0.0;
    double slack = 0.0; ///< metres, at entry planes
    double reach = 0.0; ///< metres, at planes through the eye: two pixels more
};

/// A rectangle of the screen as four planes through the eye: unit normals, positive inside.
struct RectCone {
    std::array<Vec3, 4> inwards{};
};

/// The visits of one flood as planes, for asking what of a ball can be seen in them. Reuse it: steady frames
/// allocate nothing.
class Viewcones {
public:
    /// `pixel` is the angle of one pixel in radians: balls are counted as touching a region when they come
    /// that near.
    void prepare(const View& view, const VisibleSet& set, double pixel);

    /// How the ball, eye-relative, lies to a visit's region and entry plane. Inside means more: no part of it
    /// shows in a pixel of another owner in front of it, i.e. it lies wholly within the visit, before the
    /// entry planes of all visits drawn later that it touches on the screen, and those are all below this
    /// visit. Then every fragment of it passes the ownership test, and the test may be left out.
    [[nodiscard]] Containment classify(std::uint32_t visit, const SeenBall& ball) const;
    [[nodiscard]] Containment classify(std::uint32_t visit, const Sphere& ball) const {
        return classify(visit, ballOf(ball));
    }
    [[nodiscard]] SeenBall ballOf(const Sphere& ball) const {
        const double distance = std::sqrt(glm::dot(ball.centre, ball.centre)) + ball.radius;
        const double slack = kSlack + kSlackShare * distance;
        return {ball.centre, ball.radius, slack, slack + 2.0 * pixel_ * distance};
    }

    /// A rectangle (a SeenSpace's) of the screen.
    [[nodiscard]] RectCone coneOf(const Rect& rect) const;
    /// How the ball lies to it. Outside: nothing of the ball shows within the rectangle.
    [[nodiscard]] static Containment classify(const RectCone& rect, const SeenBall& ball);

private:
    /// The ownership test's own tolerance (1 mm and a share of the distance) and float rounding on the GPU, with
    /// room to spare, in metres per metre of distance and in metres: "inside" must hold under it, "outside"
    /// beyond it.
    static constexpr double kSlackShare = 2e-6;
    static constexpr double kSlack = 0.004;
    struct Cone {
        Plane entry;
        std::uint32_t firstEdge = 0, edgeCount = 0, parent = 0;
    };
    [[nodiscard]] Containment classifyAlone(const Cone& cone, const SeenBall& ball) const;
    [[nodiscard]] Containment classifyOnScreen(const Cone& cone, const SeenBall& ball) const;
    [[nodiscard]] bool descends(std::uint32_t visit, std::uint32_t ancestor) const;
    std::vector<Cone> cones_;
    std::vector<Vec3> edges_; ///< unit normals of planes through the eye, positive inside
    View view_;
    double pixel_ = 0.0;
};

} // namespace limen::visibility
