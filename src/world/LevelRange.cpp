#include "world/LevelRange.h"

#include "core/Assert.h"
#include "world/World.h"

#include <algorithm>
#include <cmath>

namespace limen::world {
namespace {

constexpr std::int32_t kLandcellSteps = 24 * kRangeSteps;

std::int64_t stepsOf(double metres) {
    return static_cast<std::int64_t>(std::floor(metres * kRangeSteps));
}

std::int32_t localSteps(double metres) {
    constexpr double kMost = static_cast<double>(kMostLocalSteps) / kRangeSteps;
    return static_cast<std::int32_t>(stepsOf(std::clamp(metres, -kMost, kMost)));
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

std::array<std::int32_t, 3> localRangeSteps(const Vec3& local) {
    return {localSteps(local.x), localSteps(local.y), localSteps(local.z)};
}

std::int32_t landcellMiddle(std::int32_t localSteps) {
    constexpr std::int32_t kToPositive = 4096; // landcells: division then rounds down
    static_assert(kToPositive * kLandcellSteps > kMostLocalSteps);
    const std::int32_t cell = (localSteps + kToPositive * kLandcellSteps) / kLandcellSteps - kToPositive;
    return cell * kLandcellSteps + kLandcellSteps / 2;
}

LevelDistance levelDistance(LevelMeasure measure, const std::array<std::int32_t, 3>& origin,
                            const RangeSteps& eye) {
    if (measure == LevelMeasure::Landcell) {
        constexpr std::uint32_t kBeyond = kLandcellBeyond * kRangeSteps;
        const std::uint32_t squared =
            squareOf(landcellMiddle(origin[0]) - eye.x) + squareOf(landcellMiddle(origin[1]) - eye.y);
        if (squared > kBeyond * kBeyond)
            return {squared, true};
    }
    return {squareOf(origin[0] - eye.x) + squareOf(origin[1] - eye.y) + squareOf(origin[2] - eye.z), false};
}

bool isInLevelRange(const World& world, const Instance& instance, const RangeSteps& eye,
                    const LevelShare& share) {
    if (instance.level == kNone)
        return true;
    LIMEN_ASSERT(instance.block < world.blocks.size(), "the origin is local to a block");
    LIMEN_ASSERT(instance.level < world.levels.size(), "a level of the world");
    const Level& level = world.levels[instance.level];
    const RangeSteps block = rangeStepsOf(world.blocks[instance.block].origin()); // whole metres
    const RangeSteps local{eye.x - block.x, eye.y - block.y, eye.z - block.z};
    return level.range.contains(share.seen(levelDistance(level.measure, level.origin, local).squared));
}

} // namespace limen::world
