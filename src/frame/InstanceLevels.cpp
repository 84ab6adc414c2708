#include "frame/InstanceLevels.h"

#include "core/Assert.h"
#include "world/World.h"

namespace limen::frame {

InstanceLevels::InstanceLevels(const world::World& world, const Clusters& clusters) {
    LIMEN_ASSERT(world.blocks.size() < 1u << 24, "a block's number has 24 bits");
    entries_.resize(clusters.order.size());
    for (std::size_t position = 0; position < entries_.size(); ++position) {
        const world::Instance& instance = world.instances[clusters.order[position]];
        if (instance.level == world::kNone)
            continue;
        const world::Level& level = world.levels[instance.level];
        Entry& entry = entries_[position];
        entry.origin = level.origin;
        entry.range = level.range;
        entry.block = instance.block & 0xFFFFFFu;
        entry.measure = static_cast<std::uint8_t>(level.measure);
    }
}

void LevelTests::prepare(const Vec3& eye, world::LevelShare share) {
    share_ = share;
    eyes_.clear();
    const world::RangeSteps steps = world::rangeStepsOf(eye);
    for (const world::Block& block : world_.blocks) {
        const world::RangeSteps corner = world::rangeStepsOf(block.origin()); // whole metres
        eyes_.push_back({steps.x - corner.x, steps.y - corner.y, steps.z - corner.z});
    }
}

bool LevelTests::contains(const InstanceLevels::Entry& entry) const {
    const auto measure = static_cast<world::LevelMeasure>(entry.measure);
    return entry.range.contains(
        share_.seen(world::levelDistance(measure, entry.origin, eyes_[entry.block]).squared));
}

} // namespace limen::frame
