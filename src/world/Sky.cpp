#include "world/Sky.h"

#include "core/Assert.h"
#include "geometry/Angles.h"

#include <algorithm>
#include <charconv>

namespace limen::world {
namespace {

double fractionOf(double time) {
    const double f = time - std::floor(time);
    return std::isfinite(f) ? f : 0.0;
}

const dat::DayGroup* groupOf(const Sky& sky, std::uint32_t& dayGroup) {
    if (sky.desc.dayGroups.empty())
        return nullptr;
    dayGroup = std::min(dayGroup, static_cast<std::uint32_t>(sky.desc.dayGroups.size() - 1));
    LIMEN_ASSERT(dayGroup < sky.desc.dayGroups.size(), "the number is clamped");
    return &sky.desc.dayGroups[dayGroup];
}

/// The two keyframes around a time, and the fraction of the time between them, 0..1.
struct Between {
    const dat::SkyTimeOfDay* from = nullptr;
    const dat::SkyTimeOfDay* to = nullptr;
    double f = 0.0;
};

/// Keyframes may be stored in any order. Those with the same begin count in the order of storage.
Between keyframesAt(const dat::DayGroup& group, double t) {
    if (group.times.empty())
        return {};
    const auto before = [](const dat::SkyTimeOfDay& a, const dat::SkyTimeOfDay& b) {
        return a.begin != b.begin ? a.begin < b.begin : &a < &b;
    };
    const dat::SkyTimeOfDay* first = &group.times[0];
    const dat::SkyTimeOfDay* last = first;
    const dat::SkyTimeOfDay* from = nullptr;
    for (const dat::SkyTimeOfDay& frame : group.times) {
        first = before(frame, *first) ? &frame : first;
        last = before(*last, frame) ? &frame : last;
        if (static_cast<double>(frame.begin) <= t && (from == nullptr || before(*from, frame)))
            from = &frame;
    }
    from = from == nullptr ? last
                           : from; // before the first keyframe of the day, the last of the day before counts
    const dat::SkyTimeOfDay* to = nullptr;
    for (const dat::SkyTimeOfDay& frame : group.times)
        if (before(*from, frame) && (to == nullptr || before(frame, *to)))
            to = &frame;
    to = to == nullptr ? first : to;
    const double b1 = from->begin, b2 = to->begin;
    const double span = b2 > b1 ? b2 - b1 : 1.0 - b1 + b2;
    const double passed = t >= b1 ? t - b1 : t + 1.0 - b1;
    return {from, to, span > 1e-9 ? std::clamp(passed / span, 0.0, 1.0) : 0.0};
}

double mixed(float a, float b, double f) {
    return static_cast<double>(a) + (static_cast<double>(b) - static_cast<double>(a)) * f;
}

constexpr float kDarkest = 0.2f;      ///< least brightness of ambient light
constexpr double kNotPinned = -120.0; ///< z of weather without kAtViewer, global, metres

// SkyObject::properties
constexpr std::uint32_t kOverLand = 1, kWeather = 4, kAtViewer = 8;

/// Mixes byte by byte, and cuts to bytes.
Vec3f mixedColour(dat::Colour a, dat::Colour b, double f) {
    const auto channel = [&](int shift) {
        const double from = a.argb >> shift & 255u, to = b.argb >> shift & 255u;
        return static_cast<float>(std::floor(from + (to - from) * f)) / 255.0f;
    };
    return {channel(16), channel(8), channel(0)};
}

/// A mixed value of two replacements, in hundredths. No value: one of them does not set it.
template <class IsSet>
std::optional<float> mixedHundredths(float from, float to, double f, const IsSet& isSet) {
    if (!isSet(from) || !isSet(to))
        return std::nullopt;
    return static_cast<float>(std::clamp(mixed(from, to, f) / 100.0, 0.0, 1.0));
}

/// Degrees along the object's arc.
double arcAngle(const dat::SkyObject& object, double t) {
    const double begin = object.beginTime, span = object.endTime - object.beginTime;
    return mixed(object.beginAngle, object.endAngle,
                 span > 1e-9 ? std::clamp((t - begin) / span, 0.0, 1.0) : 0.0);
}

const dat::SkyObjectReplace* replaceOf(const dat::SkyTimeOfDay* frame, std::uint32_t object) {
    if (frame == nullptr)
        return nullptr;
    const auto found = std::find_if(frame->replaces.begin(), frame->replaces.end(),
                                    [&](const dat::SkyObjectReplace& r) { return r.objectIndex == object; });
    return found == frame->replaces.end() ? nullptr : &*found;
}

/// `axis`: 1 for y, 2 for z.
glm::mat3 rotationAbout(int axis, double radians) {
    LIMEN_ASSERT(axis == 1 || axis == 2, "sky objects rotate about y and z");
    const auto c = static_cast<float>(std::cos(radians)), s = static_cast<float>(std::sin(radians));
    if (axis == 2)
        return {Vec3f(c, s, 0.0f), Vec3f(-s, c, 0.0f), Vec3f(0.0f, 0.0f, 1.0f)};
    return {Vec3f(c, 0.0f, -s), Vec3f(0.0f, 1.0f, 0.0f), Vec3f(s, 0.0f, c)};
}

/// Sets the values that both keyframes replace.
void replaceValues(const dat::SkyObjectReplace* from, const dat::SkyObjectReplace* to, double f,
                   SkyPlacement& out) {
    if (from == nullptr || to == nullptr)
        return;
    const auto isPositive = [](float value) { return value > 0.0f; };
    const auto isNotNegative = [](float value) { return value >= 0.0f; };
    out.transparent = mixedHundredths(from->transparent, to->transparent, f, isNotNegative).value_or(0.0f);
    out.luminosity = mixedHundredths(from->luminosity, to->luminosity, f, isPositive).value_or(0.0f);
    out.diffuse = mixedHundredths(from->maxBright, to->maxBright, f, isPositive).value_or(1.0f);
}

/// From the eye to the origin of a sky object's model. Weather follows the eye, but may have a height of its own.
Vec3f offsetOf(const dat::SkyObject& object, const SkyView& view) {
    if ((object.properties & kWeather) == 0)
        return Vec3f(view.origin);
    const bool hasHeight = (object.properties & kAtViewer) == 0;
    return {0.0f, 0.0f, hasHeight ? static_cast<float>(kNotPinned - view.eyeZ) : 0.0f};
}

double lastTick(const Sky& sky, double time, double tickSeconds) {
    const double day = sky.time.dayLength;
    if (!(tickSeconds > 0.0) || !(day > tickSeconds))
        return time;
    constexpr double kRounding = 1e-9; // of a time that is a tick
    return std::floor(time * day / tickSeconds + kRounding) * tickSeconds / day;
}

} // namespace

SkyState skyAt(const Sky& sky, std::uint32_t dayGroup, double time) {
    SkyState state;
    const dat::DayGroup* group = groupOf(sky, dayGroup);
    if (group == nullptr)
        return state;
    const Between at = keyframesAt(*group, fractionOf(time));
    if (at.from == nullptr) {
        state.sunDirection = glm::normalize(Vec3f(0.5f, 0.0f, 0.8f));
        state.sunBright = glm::length(Vec3f(0.5f, 0.0f, 0.8f));
        state.sunColour = Vec3f(state.sunBright);
        state.ambient = Vec3f(0.3f);
        return state;
    }
    const dat::SkyTimeOfDay &a = *at.from, &b = *at.to;
    const double pitch = mixed(a.dirPitch, b.dirPitch, at.f) * kDegree;
    const double heading = mixed(a.dirHeading, b.dirHeading, at.f) * kDegree;
    state.sunDirection = Vec3f(
        Vec3(std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch), std::sin(pitch)));
    state.sunBright = static_cast<float>(mixed(a.dirBright, b.dirBright, at.f));
    state.sunColour = mixedColour(a.dirColour, b.dirColour, at.f) * state.sunBright;
    state.ambientColour = mixedColour(a.ambColour, b.ambColour, at.f);
    state.ambient =
        state.ambientColour * std::max(static_cast<float>(mixed(a.ambBright, b.ambBright, at.f)), kDarkest);
    state.fogColour = mixedColour(a.fogColour, b.fogColour, at.f);
    if (a.fogMode != 0 && b.fogMode != 0) {
        state.fogNear = static_cast<float>(mixed(a.minFog, b.minFog, at.f));
        state.fogFar = static_cast<float>(mixed(a.maxFog, b.maxFog, at.f));
    }
    return state;
}

double timeOfLight(const Sky& sky, double time) {
    return lastTick(sky, time, sky.desc.lightTickSize);
}

double timeOfSky(const Sky& sky, double time) {
    return lastTick(sky, time, sky.desc.tickSize);
}

bool isShown(const dat::SkyObject& object, double time) {
    const double t = fractionOf(time);
    return object.beginTime == object.endTime || (object.beginTime < t && t < object.endTime);
}

std::optional<std::uint32_t> dayGroupNamed(const dat::SkyDesc& sky, std::string_view text) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc() && end == text.data() + text.size())
        return number < std::max<std::size_t>(sky.dayGroups.size(), 1) ? std::make_optional(number)
                                                                       : std::nullopt;
    const auto isSame = [](char a, char b) {
        const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return lower(a) == lower(b);
    };
    for (std::uint32_t group = 0; group < sky.dayGroups.size(); ++group) {
        const std::string& name = sky.dayGroups[group].name;
        if (std::equal(name.begin(), name.end(), text.begin(), text.end(), isSame))
            return group;
    }
    return std::nullopt;
}

std::uint32_t rainyDayGroup(const dat::SkyDesc& sky, std::uint32_t dayGroup) {
    const auto rains = [](const dat::DayGroup& group) {
        return std::any_of(group.objects.begin(), group.objects.end(), [](const dat::SkyObject& object) {
            return (object.properties & (kOverLand | kWeather)) == (kOverLand | kWeather) &&
                   object.texVelocityY != 0.0f;
        });
    };
    if (dayGroup < sky.dayGroups.size() && rains(sky.dayGroups[dayGroup]))
        return dayGroup;
    const auto found = std::find_if(sky.dayGroups.begin(), sky.dayGroups.end(), rains);
    return found != sky.dayGroups.end() ? static_cast<std::uint32_t>(found - sky.dayGroups.begin())
                                        : dayGroup;
}

void skyPlacements(const Sky& sky, const SkyView& view, std::vector<SkyPlacement>& out) {
    out.clear();
    std::uint32_t dayGroup = view.dayGroup;
    const dat::DayGroup* group = groupOf(sky, dayGroup);
    if (group == nullptr)
        return;
    const double t = fractionOf(view.time);
    const Between at = keyframesAt(*group, t);
    for (std::uint32_t i = 0; i < sky.parts.size(); ++i) {
        const SkyPart& part = sky.parts[i];
        if (part.dayGroup != dayGroup)
            continue;
        const dat::SkyObjectReplace* from = replaceOf(at.from, part.objectIndex);
        if (part.replacement != (from != nullptr ? from->gfxObj : 0) ||
            (part.replacement == 0 && !isShown(part.object, t)))
            continue;
        SkyPlacement placement;
        placement.part = i;
        placement.isOverLand = (part.object.properties & kOverLand) != 0;
        replaceValues(from, replaceOf(at.to, part.objectIndex), at.f, placement);
        if (placement.transparent >= 1.0f || (placement.isOverLand && !view.isOutdoors))
            continue;
        const double turn = from != nullptr ? double{from->rotate} : 0.0;
        placement.rotation =
            rotationAbout(1, -arcAngle(part.object, t) * kDegree) * rotationAbout(2, -turn * kDegree);
        placement.offset = offsetOf(part.object, view);
        placement.uvOffset = {
            static_cast<float>(std::fmod(static_cast<double>(part.object.texVelocityX) * view.seconds, 1.0)),
            static_cast<float>(std::fmod(static_cast<double>(part.object.texVelocityY) * view.seconds, 1.0))};
        out.push_back(placement);
    }
}

} // namespace limen::world
