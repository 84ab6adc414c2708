#include "world/assemble/Cycles.h"

#include "core/Assert.h"

#include <algorithm>

namespace limen::world {
namespace {

/// A sphere around spheres. Its centre is that of their bounding box.
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

/// The sphere of a part's mesh with the part's scale, in the space of the Setup's part that poses it.
Sphere sphereOf(const World& world, const Instance& part, const PosedPart& posed) {
    const Sphere& mesh = world.meshes[part.mesh].bounds;
    const Vec3 scale = glm::abs(posed.scale);
    const double most = std::max({scale.x, scale.y, scale.z});
    if (part.facing != Facing::Fixed) // in every turn
        return {posed.grip.origin, (glm::length(mesh.centre) + mesh.radius) * most};
    return {posed.grip.origin + posed.grip.orientation * (posed.scale * mesh.centre), mesh.radius * most};
}

/// Between two frames, a point at `distance` from a part's origin moves on an arc. This is the arc's greatest
/// distance from the straight line, metres: the remainder of linear interpolation, an eighth of the second
/// derivative.
double offTheStraight(const PartFrame& from, const PartFrame& to, double distance) {
    const double cosine = std::min(std::abs(glm::dot(from.orientation, to.orientation)), 1.0);
    const double turn = 2.0 * std::acos(cosine);
    return distance * turn * turn / 8.0;
}

/// Adds the spheres of one part in all frames of a stretch, enlarged by the arc to the next frame. The sphere
/// around two of them contains the straight line between.
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
            continue; // the part does not move towards a frame that lacks it
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
    LIMEN_ASSERT(body.firstPosed + body.partCount <= world.posedParts.size(), "a pose for each part");
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
