#include "world/records/DoorMotion.h"

#include <algorithm>
#include <cmath>

namespace limen::world {
namespace {

// Substates of a style. Ref: MotionCommand in the record schema of Chorizite's DatReaderWriter (dats.xml).
constexpr std::uint32_t kSubstateOn = 0x4000000B, kSubstateOff = 0x4000000C;

constexpr std::size_t kMostKeys = 512;
constexpr double kSlowest = 60.0; ///< seconds: a slower door counts as damaged data

using Key = std::vector<Pose>;

template <class Value>
const Value* findValue(const dat::MotionTable::Keyed<Value>& list, std::uint32_t key) {
    const auto found =
        std::find_if(list.begin(), list.end(), [key](const auto& entry) { return entry.first == key; });
    return found != list.end() ? &found->second : nullptr;
}

bool isSame(const Key& a, const Key& b) {
    constexpr double kNear = 1e-5; // metres, and a difference of unit quaternions
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Pose& x, const Pose& y) {
        return glm::length(x.origin - y.origin) < kNear &&
               std::abs(glm::dot(x.orientation, y.orientation)) > 1.0 - kNear * kNear;
    });
}

/// Collects the frames of motions as keys.
class KeyReader {
public:
    KeyReader(const dat::Setup& setup, Records& records) : records_(records) {
        for (std::size_t part = 0; part < setup.parts.size(); ++part)
            rest_.push_back(restOf(setup, part));
    }

    [[nodiscard]] const Key& rest() const { return rest_; }

    /// The frames of a motion in the order in which they are played, at most kMostKeys. `seconds`: the time of all is
    /// added.
    [[nodiscard]] std::vector<Key> framesOf(const dat::MotionData& motion, double& seconds) {
        std::vector<Key> keys;
        for (const dat::AnimationRange& range : motion.animations) {
            const dat::Animation* animation = records_.animation(range.animation);
            if (animation == nullptr || animation->frames.empty())
                continue;
            const auto last = static_cast<std::int64_t>(animation->frames.size()) - 1;
            const std::int64_t low = std::clamp<std::int64_t>(range.low, 0, last);
            const std::int64_t high =
                range.high == -1 ? last : std::clamp<std::int64_t>(range.high, low, last);
            const bool isForward = !(range.fps < 0.0f);
            for (std::int64_t i = 0; i <= high - low && keys.size() < kMostKeys; ++i)
                keys.push_back(
                    keyOf(animation->frames[static_cast<std::size_t>(isForward ? low + i : high - i)]));
            const double rate = std::abs(static_cast<double>(range.fps));
            if (rate > 0.0 && std::isfinite(rate))
                seconds += static_cast<double>(high - low + 1) / rate;
        }
        return keys;
    }

private:
    [[nodiscard]] Key keyOf(const dat::AnimationFrame& frame) const {
        Key key = rest_;
        for (std::size_t part = 0; part < std::min(key.size(), frame.parts.size()); ++part)
            key[part] = poseOf(frame.parts[part]);
        return key;
    }

    Records& records_;
    Key rest_;
};

/// Adds keys, without the first one if it equals the last one that is there.
void append(const std::vector<Key>& more, std::vector<Key>& keys) {
    const bool isSeam = !keys.empty() && !more.empty() && isSame(keys.back(), more.front());
    keys.insert(keys.end(), more.begin() + (isSeam ? 1 : 0), more.end());
}

} // namespace

DoorMotion doorMotionOf(const dat::Setup& setup, dat::RecordId motionTable, Records& records) {
    KeyReader reader(setup, records);
    DoorMotion motion;
    const dat::RecordId id = motionTable != 0 ? motionTable : setup.motionTable;
    const dat::MotionTable* table = id != 0 ? records.motionTable(id) : nullptr;
    double ignored = 0.0, seconds = 0.0;
    if (table != nullptr) {
        const std::uint32_t off = dat::motionKey(table->defaultStyle, kSubstateOff);
        const auto* links = findValue(table->links, off);
        const dat::MotionData* shut = findValue(table->cycles, off);
        const dat::MotionData* open =
            findValue(table->cycles, dat::motionKey(table->defaultStyle, kSubstateOn));
        const dat::MotionData* link = links != nullptr ? findValue(*links, kSubstateOn) : nullptr;
        std::vector<Key> ends[2];
        if (shut != nullptr)
            ends[0] = reader.framesOf(*shut, ignored);
        if (open != nullptr)
            ends[1] = reader.framesOf(*open, ignored);
        for (const std::vector<Key>& end : ends)
            motion.isStill = motion.isStill && std::all_of(end.begin(), end.end(), [&](const Key& key) {
                                 return isSame(key, end.front());
                             });
        if (!ends[0].empty())
            motion.keys.push_back(ends[0].front());
        if (link != nullptr)
            append(reader.framesOf(*link, seconds), motion.keys);
        if (!ends[1].empty())
            append({ends[1].front()}, motion.keys);
    }
    if (motion.keys.empty())
        motion.keys.push_back(reader.rest());
    if (seconds > 0.0)
        motion.seconds = std::min(seconds, kSlowest);
    return motion;
}

} // namespace limen::world
