#include "world/LevelRange.h"

#include "core/Assert.h"
#include "world/World.h"

#include <algorithm>
#include <cmath>

namespace limen::world {
namespace {

std::int64_t stepsOf(double metres) {
    return static_cast<std::int64_t>(std::floor(metres * kRangeSteps));
}

std::int64_t localSteps(float metres) {
    constexpr double kMost = static_cast<double>(kMostLocalSteps) / kRangeSteps;
    return stepsOf(std::clamp(static_cast<double>(metres), -kMost, kMost));
}

std::uint32_t squareOf(std::int64_t steps) {
    const auto most = static_cast<std::int64_t>(kMostRangeSteps);
    const auto away = static_cast<std::uint32_t>(std::min(std::abs(steps), most));
    return away * away;
}

} // namespace

std::uint16_t levelRangeLimit(double metres) {
    const double steps = std::round(metres * kRangeSteps);
    if (!(steps <= kMostRangeSteps)) // also true for NaN
        return LevelRange::kEndless;
    return static_cast<std::uint16_t>(std::max(steps, 0.0));
}

RangeSteps rangeStepsOf(const Vec3& global) {
    return {stepsOf(global.x), stepsOf(global.y), stepsOf(global.z)};
}

bool isInLevelRange(const World& world, const Instance& instance, const RangeSteps& eye) {
    if (instance.levelRange.isEndless())
        return true;
    LIMEN_ASSERT(instance.block < world.blocks.size(), "the origin is local to a block");
    const Vec3 block = world.blocks[instance.block].origin(); // whole metres
    const std::uint32_t away = squareOf(stepsOf(block.x) + localSteps(instance.origin.x) - eye.x) +
                               squareOf(stepsOf(block.y) + localSteps(instance.origin.y) - eye.y) +
                               squareOf(stepsOf(block.z) + localSteps(instance.origin.z) - eye.z);
    const std::uint32_t beyond = instance.levelRange.beyond, upTo = instance.levelRange.upTo;
    return (beyond == 0 || away > beyond * beyond) && away <= upTo * upTo;
}

} // namespace limen::world
