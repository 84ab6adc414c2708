#include "world/Cycles.h"

#include <algorithm>

namespace limen::world {
namespace {

/// The ball around balls: about the middle of their box.
Sphere sphereAround(std::span<const Sphere> spheres) {
    Aabb box;
    for (const Sphere& sphere : spheres) {
        box.include(sphere.centre - Vec3(sphere.radius));
        box.include(sphere.centre + Vec3(sphere.radius));
    }
    if (box.empty())
        return {};
    Sphere all{box.centre(), 0.0};
    for (const Sphere& sphere : spheres)
        all.radius = std::max(all.radius, glm::length(sphere.centre - all.centre) + sphere.radius);
    return all;
}

/// A part's mesh at its size, in part space.
Sphere sphereOf(const World& world, const Instance& part, const PosedPart& posed) {
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
void addSpheres(const World& world, const Cycle& cycle, std::uint32_t number, std::uint32_t part,
                const Sphere& sphere, std::vector<Sphere>& spheres) {
    const Stretch& stretch = world.stretches[cycle.firstStretch + number];
    if (part >= stretch.partCount || sphere.radius < 0.0)
        return;
    const auto frameOf = [&](const Stretch& s, std::uint32_t step) -> const PartFrame& {
        return world.partFrames[s.firstPartFrame + frameAt(s, step) * s.partCount + part];
    };
    const double distance = glm::length(sphere.centre);
    for (std::uint32_t step = 0; step < stretch.frameCount; ++step) {
        const PartFrame& from = frameOf(stretch, step);
        spheres.push_back({from.origin + from.orientation * sphere.centre, sphere.radius});
        const NextFrame next = nextFrame(cycle, stretch, number, step);
        const Stretch& then = world.stretches[cycle.firstStretch + next.stretch];
        if (part >= then.partCount)
            continue; // it does not turn on the way
        const PartFrame& to = frameOf(then, next.step);
        const double radius = sphere.radius + offTheStraight(from, to, distance);
        spheres.back().radius = radius;
        spheres.push_back({to.origin + to.orientation * sphere.centre, radius});
    }
}

} // namespace

Sphere boundsInMotion(const World& world, const MovingBody& body) {
    if (body.firstPosed == kNone)
        return body.bounds;
    std::vector<Sphere> spheres;
    if (body.bounds.radius >= 0.0)
        spheres.push_back(body.bounds);
    for (std::uint32_t i = 0; i < body.partCount; ++i) {
        const PosedPart& posed = world.posedParts[body.firstPosed + i];
        const Sphere sphere = sphereOf(world, world.movingParts[body.firstPart + i], posed);
        for (const std::uint32_t cycle : body.cycles) {
            if (cycle == kNone)
                continue;
            for (std::uint32_t s = 0; s < world.cycles[cycle].stretchCount; ++s)
                addSpheres(world, world.cycles[cycle], s, posed.part, sphere, spheres);
        }
    }
    return sphereAround(spheres);
}

} // namespace limen::world
