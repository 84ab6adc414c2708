#include "world/assemble/IdleAssembler.h"

namespace limen::world {

std::uint32_t IdleAssembler::add(const PlacedModel& object, const ObjectSite& site) {
    const Vec3 spin = cycles_.spinOf(object.model, object.motionTable);
    const std::uint32_t cycle =
        cycles_.of(object.model, object.motionTable)[static_cast<std::size_t>(Gait::Stand)];
    const bool isFaded = object.opacity < 1.0; // static instances have no opacity
    if (cycle == kNone && spin == Vec3(0.0) && !isFaded)
        return kNone;
    const std::size_t parts = world_.movingParts.size(), posed = world_.posedParts.size();
    IdleObject idle;
    idle.body = bodies_.add(object.model, object.kind, object.object,
                            {.scale = object.scale,
                             .dress = object.dress != nullptr ? *object.dress : Dress(),
                             .motionTable = object.motionTable});
    const bool rests = cycle == kNone || isAtRest(world_, idle.body, cycle);
    if (idle.body.partCount == 0 || (rests && spin == Vec3(0.0) && !isFaded)) {
        world_.movingParts.resize(parts);
        world_.posedParts.resize(posed);
        return kNone;
    }
    if (spin != Vec3(0.0)) // the sphere around the origin holds every turn
        idle.body.bounds = {Vec3(0.0), glm::length(idle.body.bounds.centre) + idle.body.bounds.radius};
    if (isFaded)
        idle.body = bodies_.addBlended(idle.body);
    idle.origin = site.blockOrigin + object.origin;
    idle.orientation = object.orientation;
    idle.scale = object.scale;
    idle.spin = spin;
    idle.space = site.space;
    idle.opacity = object.opacity;
    world_.idleObjects.push_back(idle);
    return static_cast<std::uint32_t>(world_.idleObjects.size() - 1);
}

} // namespace limen::world
