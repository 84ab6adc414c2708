#include "world/Cycles.h"

#include <algorithm>

namespace limen::world {
namespace {

/// The ball around balls: about the middle of their box.
Sphere ballAround(std::span<const Sphere> balls) {
    Aabb box;
    for (const Sphere& ball : balls) {
        box.include(ball.centre - Vec3(ball.radius));
        box.include(ball.centre + Vec3(ball.radius));
    }
    if (box.empty())
        return {};
    Sphere all{box.centre(), 0.0};
    for (const Sphere& ball : balls)
        all.radius = std::max(all.radius, glm::length(ball.centre - all.centre) + ball.radius);
    return all;
}

/// A part's mesh at its size, in part space.
Sphere ballOf(const World& world, const Instance& part, const PosedPart& posed) {
    const Sphere& mesh = world.meshes[part.mesh].bounds;
    const Vec3 scale = glm::abs(posed.scale);
    return {posed.scale * mesh.centre, mesh.radius * std::max({scale.x, scale.y, scale.z})};
}

/// How far a point at `distance` from a part's origin is at most, between two frames, from where it would be if it went straight: the
/// rest of a linear interpolation, an eighth of the arc's second derivative.
double offTheStraight(const PartFrame& from, const PartFrame& to, double distance) {
    const double cosine = std::min(std::abs(glm::dot(from.orientation, to.orientation)), 1.0);
    const double turn = 2.0 * std::acos(cosine);
    return distance * turn * turn / 8.0;
}

/// One part's balls in all frames of a stretch, each large enough for the way to the next.
void addBalls(const World& world, const Cycle& cycle, std::uint32_t number, std::uint32_t part,
              const Sphere& ball, std::vector<Sphere>& balls) {
    const Stretch& stretch = world.stretches[cycle.firstStretch + number];
    if (part >= stretch.partCount || ball.radius < 0.0)
        return;
    const auto frameOf = [&](const Stretch& s, std::uint32_t step) -> const PartFrame& {
        return world.partFrames[s.firstPartFrame + frameAt(s, step) * s.partCount + part];
    };
    const double distance = glm::length(ball.centre);
    for (std::uint32_t step = 0; step < stretch.frameCount; ++step) {
        const PartFrame& from = frameOf(stretch, step);
        balls.push_back({from.origin + from.orientation * ball.centre, ball.radius});
        const NextFrame next = nextFrame(cycle, stretch, number, step);
        const Stretch& then = world.stretches[cycle.firstStretch + next.stretch];
        if (part >= then.partCount)
            continue; // it does not turn on the way
        const PartFrame& to = frameOf(then, next.step);
        const double radius = ball.radius + offTheStraight(from, to, distance);
        balls.back().radius = radius;
        balls.push_back({to.origin + to.orientation * ball.centre, radius});
    }
}

} // namespace

Sphere boundsInMotion(const World& world, const MovingBody& body) {
    if (body.firstPosed == kNone)
        return body.bounds;
    std::vector<Sphere> balls;
    if (body.bounds.radius >= 0.0)
        balls.push_back(body.bounds);
    for (std::uint32_t i = 0; i < body.partCount; ++i) {
        const PosedPart& posed = world.posedParts[body.firstPosed + i];
        const Sphere ball = ballOf(world, world.movingParts[body.firstPart + i], posed);
        for (const std::uint32_t cycle : body.cycles) {
            if (cycle == kNone)
                continue;
            for (std::uint32_t s = 0; s < world.cycles[cycle].stretchCount; ++s)
                addBalls(world, world.cycles[cycle], s, posed.part, ball, balls);
        }
    }
    return ballAround(balls);
}

} // namespace limen::world
