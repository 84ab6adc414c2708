#include "world/assemble/Cycles.h"

#include "core/Assert.h"
#include "world/records/Pose.h"

#include <algorithm>

namespace limen::world {
namespace {

// Substates of a style. Ref: MotionCommand in the record schema of Chorizite's DatReaderWriter (dats.xml).
constexpr std::uint32_t kWalkForward = 0x45000005, kRunForward = 0x44000007;

/// Frames a second of a Setup's own animation. No record has this rate (docs/retail.md).
constexpr float kDefaultRate = 30.0f;

template <class Value>
const Value* findKey(const dat::MotionTable::Keyed<Value>& list, std::uint32_t key) {
    const auto found =
        std::find_if(list.begin(), list.end(), [key](const auto& entry) { return entry.first == key; });
    return found != list.end() ? &found->second : nullptr;
}

/// The first frame of a range in an animation of `frameCount` > 0 frames.
std::uint32_t lowOf(const dat::AnimationRange& range, std::uint32_t frameCount) {
    LIMEN_ASSERT(frameCount > 0, "the animation has frames");
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(range.low, 0, std::int64_t{frameCount} - 1));
}

bool isNear(const PartFrame& of, const PosedPart& posed, const Instance& resting) {
    constexpr double kNear = 1e-4; // metres for the origin, and a difference of unit vectors for the axes
    const PartFrame frame = posedAt(of, posed);
    Mat3 linear = glm::mat3_cast(frame.orientation);
    bool near = glm::length(frame.origin - Vec3(resting.origin)) < kNear;
    for (int axis = 0; axis < 3; ++axis)
        near = near && glm::length(linear[axis] * posed.scale[axis] - Vec3(resting.linear[axis])) < kNear;
    return near;
}

} // namespace

std::array<std::uint32_t, kGaits> Cycles::of(dat::RecordId model, dat::RecordId motionTable) {
    const auto [entry, fresh] =
        bySetup_.try_emplace(std::pair(model, motionTable), std::array{kNone, kNone, kNone});
    if (!fresh || !isSetup(model))
        return entry->second;
    if (const dat::Setup* setup = records_.setup(model))
        entry->second = read(*setup, motionTable != 0 ? motionTable : setup->motionTable);
    return entry->second;
}

std::array<std::uint32_t, kGaits> Cycles::read(const dat::Setup& setup, dat::RecordId motionTable) {
    std::array<std::uint32_t, kGaits> cycles{kNone, kNone, kNone};
    const auto stand = static_cast<std::size_t>(Gait::Stand);
    const dat::MotionTable* table = motionTable != 0 ? records_.motionTable(motionTable) : nullptr;
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
        if (const std::optional<Stretch> stretch = stretchOf(range)) {
            world_.stretches.push_back(*stretch);
            sources_.push_back(
                {records_.animation(range.animation), lowOf(range, framesOf(range.animation).frameCount)});
        }
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
    const std::int64_t low = lowOf(range, frames.frameCount);
    const std::int64_t high =
        range.high == -1 ? last : std::max(low, std::clamp<std::int64_t>(range.high, 0, last));
    Stretch stretch;
    stretch.firstPartFrame = frames.first + static_cast<std::uint32_t>(low) * frames.partCount;
    stretch.partCount = frames.partCount;
    stretch.frameCount = static_cast<std::uint32_t>(high - low + 1);
    if (std::isfinite(range.fps))
        stretch.rate = static_cast<double>(range.fps);
    else
        records_.report({range.animation, "is played at a rate that is not a number: it stands still"});
    return stretch;
}

const Cycles::Frames& Cycles::framesOf(dat::RecordId animation) {
    const auto [entry, fresh] = byAnimation_.try_emplace(animation);
    Frames& frames = entry->second;
    const dat::Animation* record = fresh ? records_.animation(animation) : nullptr;
    if (record == nullptr)
        return frames;
    if (record->frames.empty())
        records_.report(
            {animation, "the animation has no frames: the parts it would move keep their resting poses"});
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

Vec3 Cycles::spinOf(dat::RecordId model, dat::RecordId motionTable) {
    const dat::Setup* setup = isSetup(model) ? records_.setup(model) : nullptr;
    const dat::RecordId id = setup == nullptr ? 0 : motionTable != 0 ? motionTable : setup->motionTable;
    const dat::MotionTable* table = id != 0 ? records_.motionTable(id) : nullptr;
    const std::uint32_t* substate =
        table != nullptr ? findKey(table->styleDefaults, table->defaultStyle) : nullptr;
    const dat::MotionData* data = substate != nullptr
                                      ? findKey(table->cycles, dat::motionKey(table->defaultStyle, *substate))
                                      : nullptr;
    if (data == nullptr || (data->flags & dat::MotionData::kOmega) == 0)
        return Vec3(0.0);
    const Vec3 spin(data->omega);
    return isFinite(spin) ? spin : Vec3(0.0);
}

void Cycles::addHooks(std::uint32_t stretch, double begin, double period, std::vector<Hook>& out) const {
    LIMEN_ASSERT(sources_.size() == world_.stretches.size(), "a source for each stretch");
    const Stretch& played = world_.stretches[stretch];
    const Source& source = sources_[stretch];
    const double rate = std::abs(played.rate);
    for (std::uint32_t step = 0; step < played.frameCount; ++step) {
        const dat::AnimationFrame& frame = source.animation->frames[source.low + frameAt(played, step)];
        for (const dat::AnimationHook& hook : frame.hooks) {
            const bool passes = hook.direction == 0 || (hook.direction > 0) == (played.rate > 0.0);
            if (passes) // a frame is passed when the next one begins
                out.push_back({&hook, begin + (step + 1) / rate, period});
        }
    }
}

std::vector<Cycles::Hook> Cycles::hooksOf(std::uint32_t cycle) const {
    LIMEN_ASSERT(cycle < world_.cycles.size(), "the cycle is in the world");
    std::vector<Hook> hooks;
    const Cycle& all = world_.cycles[cycle];
    double begin = 0.0;
    for (std::uint32_t s = all.firstStretch; s < all.firstStretch + all.stretchCount; ++s) {
        const Stretch& stretch = world_.stretches[s];
        if (stretch.rate == 0.0)
            break; // a stretch without a rate never ends
        const double length = stretch.frameCount / std::abs(stretch.rate);
        const bool isLast = s + 1 == all.firstStretch + all.stretchCount;
        addHooks(s, begin, isLast ? length : 0.0, hooks);
        begin += length;
    }
    return hooks;
}

bool isAtRest(const World& world, const MovingBody& body, std::uint32_t cycle) {
    LIMEN_ASSERT(body.firstPosed != kNone || body.partCount == 0, "a body with a cycle has posed parts");
    const Cycle& all = world.cycles[cycle];
    for (std::uint32_t s = all.firstStretch; s < all.firstStretch + all.stretchCount; ++s) {
        const Stretch& stretch = world.stretches[s];
        const std::uint32_t steps = stretch.rate != 0.0 ? stretch.frameCount : 1;
        for (std::uint32_t i = 0; i < body.partCount; ++i) {
            const PosedPart& posed = world.posedParts[body.firstPosed + i];
            for (std::uint32_t step = 0; step < steps && posed.part < stretch.partCount; ++step) {
                const PartFrame& frame =
                    world.partFrames[stretch.firstPartFrame + frameAt(stretch, step) * stretch.partCount +
                                     posed.part];
                if (!isNear(frame, posed, world.movingParts[body.firstPart + i]))
                    return false;
            }
        }
    }
    return true;
}

} // namespace limen::world
