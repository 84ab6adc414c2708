#include "motion/BodyInstances.h"

#include "core/Assert.h"
#include "geometry/Compass.h"
#include "motion/Villagers.h"

#include <cmath>
#include <numbers>

namespace limen::motion {

Quat orientationOf(const world::IdleObject& idle, double seconds) {
    const double rate = glm::length(idle.spin);
    if (!(rate > 0.0))
        return idle.orientation;
    return idle.orientation *
           glm::angleAxis(std::remainder(rate * seconds, 2.0 * std::numbers::pi), idle.spin / rate);
}

void addVillagers(const DynamicStateInput& input, DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (const world::Villager& villager : world.villagers) {
        const VillagerPlace place = placeOf(world, villager, input.seconds);
        const BodyPose pose{turnedTo(place.yaw), place.feet};
        const CyclePoint point = cyclePointOf(world, villager, input.seconds);
        const std::size_t first = instances.addBody(villager.body, pose, point, place.space);
        instances.setSpaces(first, instances.reachedFrom(place.space, pose.placed(villager.body.bounds)));
    }
}

void addPlayer(const DynamicStateInput& input, DynamicInstances& instances) {
    if (!input.player || !(input.player->opacity > 0.0))
        return;
    const PlayerBody& player = *input.player;
    LIMEN_ASSERT(isFinite(player.feet), "the player is at a finite position");
    const bool isSolid = player.opacity >= 1.0;
    const world::World& world = instances.world();
    const world::MovingBody& body = isSolid ? world.player.solid : world.player.ghost;
    const BodyPose pose{turnedTo(player.yaw), player.feet};
    const CyclePoint point =
        cyclePoint(world, body, gaitAt(world, body, player.speed), player.metres, input.seconds);
    const std::size_t first = instances.addBody(body, pose, point, player.space);
    for (std::size_t i = first; i < instances.count() && !isSolid; ++i)
        instances.state().instances[i].opacity = static_cast<float>(player.opacity);
    instances.setSpaces(first, instances.reachedFrom(player.space, pose.placed(body.bounds)));
}

void addIdleObjects(const DynamicStateInput& input, DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (const world::IdleObject& idle : world.idleObjects) {
        const BodyPose pose{glm::mat3_cast(orientationOf(idle, input.seconds)) * idle.scale, idle.origin};
        const CyclePoint point = cyclePoint(world, idle.body, world::Gait::Stand, 0.0, input.seconds);
        const std::size_t first = instances.addBody(idle.body, pose, point, idle.space);
        for (std::size_t i = first; i < instances.count() && idle.opacity < 1.0; ++i)
            instances.state().instances[i].opacity = static_cast<float>(idle.opacity);
        Sphere bounds = pose.placed(idle.body.bounds);
        bounds.radius *= idle.scale;
        instances.setSpaces(first, idle.isAlone ? instances.only(idle.space)
                                                : instances.reachedFrom(idle.space, bounds));
    }
}

void addLooseObjects(DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (const world::LooseObject& object : world.looseObjects) {
        LIMEN_ASSERT(object.instanceCount > 0, "a loose object has instances");
        const auto statics = std::span(world.instances).subspan(object.firstInstance, object.instanceCount);
        const std::size_t first = instances.addCopies(statics, object.origin);
        instances.setSpaces(first, instances.reachedFrom(statics.front().placedIn, object.bounds));
    }
}

} // namespace limen::motion
