#include "world/Cycles.h"

#include "world/Models.h"

#include <algorithm>

namespace limen::world {
namespace {

// Substates of a style. ref: MotionCommand in the record schema of Chorizite's DatReaderWriter (dats.xml).
constexpr std::uint32_t kWalkForward = 0x45000005, kRunForward = 0x44000007;

/// Frames a second of a Setup's own animation, of which no record tells the rate (docs/uncertain.md).
constexpr float kDefaultRate = 30.0f;

template <class Value>
const Value* findKey(const dat::MotionTable::Keyed<Value>& list, std::uint32_t key) {
    const auto found =
        std::find_if(list.begin(), list.end(), [key](const auto& entry) { return entry.first == key; });
    return found != list.end() ? &found->second : nullptr;
}

} // namespace

std::array<std::uint32_t, kGaits> Cycles::of(dat::RecordId model) {
    const auto [entry, fresh] = bySetup_.try_emplace(model, std::array{kNone, kNone, kNone});
    if (!fresh || model >> 24 != 0x02)
        return entry->second;
    if (const dat::Setup* setup = records_.setup(model))
        entry->second = read(*setup);
    return entry->second;
}

std::array<std::uint32_t, kGaits> Cycles::read(const dat::Setup& setup) {
    std::array<std::uint32_t, kGaits> cycles{kNone, kNone, kNone};
    const auto stand = static_cast<std::size_t>(Gait::Stand);
    const dat::MotionTable* table =
        setup.motionTable != 0 ? records_.motionTable(setup.motionTable) : nullptr;
    if (table != nullptr) {
        if (const std::uint32_t* substate = findKey(table->styleDefaults, table->defaultStyle))
            cycles[stand] = addCycle(*table, *substate);
        cycles[static_cast<std::size_t>(Gait::Walk)] = addCycle(*table, kWalkForward);
        cycles[static_cast<std::size_t>(Gait::Run)] = addCycle(*table, kRunForward);
    }
    if (cycles[stand] == kNone && setup.animation != 0) {
        const dat::AnimationRange whole{setup.animation, 0, -1, kDefaultRate};
        cycles[stand] = addCycle({&whole, 1}, Vec3(0.0));
    }
    return cycles;
}

std::uint32_t Cycles::addCycle(const dat::MotionTable& table, std::uint32_t substate) {
    const dat::MotionData* data = findKey(table.cycles, dat::motionKey(table.defaultStyle, substate));
    if (data == nullptr)
        return kNone;
    const Vec3 velocity = (data->flags & dat::MotionData::kVelocity) != 0 ? Vec3(data->velocity) : Vec3(0.0);
    return addCycle(data->animations, isFinite(velocity) ? velocity : Vec3(0.0));
}

std::uint32_t Cycles::addCycle(std::span<const dat::AnimationRange> ranges, const Vec3& velocity) {
    Cycle cycle{static_cast<std::uint32_t>(world_.stretches.size()), 0, velocity};
    for (const dat::AnimationRange& range : ranges) {
        if (const std::optional<Stretch> stretch = stretchOf(range))
            world_.stretches.push_back(*stretch);
    }
    cycle.stretchCount = static_cast<std::uint32_t>(world_.stretches.size()) - cycle.firstStretch;
    if (cycle.stretchCount == 0)
        return kNone;
    world_.cycles.push_back(cycle);
    return static_cast<std::uint32_t>(world_.cycles.size() - 1);
}

std::optional<Stretch> Cycles::stretchOf(const dat::AnimationRange& range) {
    const Frames& frames = framesOf(range.animation);
    if (frames.frameCount == 0)
        return std::nullopt;
    const std::int64_t last = std::int64_t{frames.frameCount} - 1;
    const std::int64_t low = std::clamp<std::int64_t>(range.low, 0, last);
    const std::int64_t high =
        range.high == -1 ? last : std::max(low, std::clamp<std::int64_t>(range.high, 0, last));
    Stretch stretch;
    stretch.firstPartFrame = frames.first + static_cast<std::uint32_t>(low) * frames.partCount;
    stretch.partCount = frames.partCount;
    stretch.frameCount = static_cast<std::uint32_t>(high - low + 1);
    if (std::isfinite(range.fps))
        stretch.rate = static_cast<double>(range.fps);
    else
        note(records_.findings(), range.animation, "is played at a rate that is no number: it stands still");
    return stretch;
}

const Cycles::Frames& Cycles::framesOf(dat::RecordId animation) {
    const auto [entry, fresh] = byAnimation_.try_emplace(animation);
    Frames& frames = entry->second;
    const dat::Animation* record = fresh ? records_.animation(animation) : nullptr;
    if (record == nullptr)
        return frames;
    if (record->frames.empty())
        note(records_.findings(), animation, "an animation without frames: what it would move rests");
    frames = {static_cast<std::uint32_t>(world_.partFrames.size()), record->partCount,
              static_cast<std::uint32_t>(record->frames.size())};
    for (const dat::AnimationFrame& frame : record->frames) {
        for (const dat::Frame& part : frame.parts) {
            const Pose pose = poseOf(part);
            world_.partFrames.push_back({pose.orientation, pose.origin});
        }
    }
    return frames;
}

} // namespace limen::world
