#include "motion/DynamicStateBuilder.h"

#include "motion/Billboards.h"
#include "motion/BodyInstances.h"
#include "motion/DoorInstances.h"
#include "motion/EffectInstances.h"
#include "motion/WeatherInstances.h"

namespace limen::motion {

void DynamicStateBuilder::build(const DynamicStateInput& input, world::DynamicState& out) {
    shutPortals(world_, input, out); // first: shut portals stop membership
    instances_.begin(input.eye, input.levels, input.between, out);
    addDoors(input, instances_);
    addVillagers(input, instances_);
    addPlayer(input, instances_);
    addIdleObjects(input, instances_);
    addLooseObjects(instances_);
    addBillboards(instances_);
    addSprites(input, instances_);
    addParticles(input, instances_);
    addWeather(input, instances_);
    world::listBySpace(world_.spaces.size(), out);
}

} // namespace limen::motion
