#include "world/assemble/IdleAssembler.h"

namespace limen::world {

std::uint32_t IdleAssembler::add(const PlacedModel& object, const JoiningBlock& block) {
    const Vec3 spin = cycles_.spinOf(object.model);
    const std::uint32_t cycle = cycles_.of(object.model)[static_cast<std::size_t>(Gait::Stand)];
    if (cycle == kNone && spin == Vec3(0.0))
        return kNone;
    const std::size_t parts = world_.movingParts.size(), posed = world_.posedParts.size();
    IdleObject idle;
    idle.body = bodies_.add(object.model, object.kind, object.object, {.scale = object.scale});
    const bool rests = cycle == kNone || isAtRest(world_, idle.body, cycle);
    if (idle.body.partCount == 0 || (rests && spin == Vec3(0.0))) {
        world_.movingParts.resize(parts);
        world_.posedParts.resize(posed);
        return kNone;
    }
    if (spin != Vec3(0.0)) // the sphere around the origin holds every turn
        idle.body.bounds = {Vec3(0.0), glm::length(idle.body.bounds.centre) + idle.body.bounds.radius};
    idle.origin = block.origin + object.origin;
    idle.orientation = object.orientation;
    idle.scale = object.scale;
    idle.spin = spin;
    idle.space = block.spaceOf(object.cell);
    world_.idleObjects.push_back(idle);
    return static_cast<std::uint32_t>(world_.idleObjects.size() - 1);
}

} // namespace limen::world
