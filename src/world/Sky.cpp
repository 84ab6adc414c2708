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

/// Interpolates angles in degrees along the shorter arc.
double mixedAngle(float a, float b, double f) {
    const double turn = std::remainder(static_cast<double>(b) - static_cast<double>(a), 360.0);
    return static_cast<double>(a) + turn * f;
}

Vec3f colourOf(dat::Colour colour) {
    const auto channel = [&](int shift) { return static_cast<float>(colour.argb >> shift & 255u) / 255.0f; };
    return {channel(16), channel(8), channel(0)};
}

float asFraction(double value) {
    return static_cast<float>(std::clamp(value > 1.0 ? value / 100.0 : value, 0.0, 1.0));
}

/// Degrees along the object's arc.
double arcAngle(const dat::SkyObject& object, double t) {
    const double begin = object.beginTime, end = object.endTime;
    if (begin == end)
        return object.beginAngle;
    const double span = end > begin ? end - begin : 1.0 - begin + end;
    const double passed = t >= begin ? t - begin : t + 1.0 - begin;
    return mixed(object.beginAngle, object.endAngle, span > 1e-9 ? std::clamp(passed / span, 0.0, 1.0) : 0.0);
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

} // namespace

SkyState skyAt(const Sky& sky, std::uint32_t dayGroup, double time) {
    SkyState state;
    const dat::DayGroup* group = groupOf(sky, dayGroup);
    const Between at = group != nullptr ? keyframesAt(*group, fractionOf(time)) : Between();
    if (at.from == nullptr)
        return state;
    const dat::SkyTimeOfDay &a = *at.from, &b = *at.to;
    const auto f = static_cast<float>(at.f);
    const double pitch = mixedAngle(a.dirPitch, b.dirPitch, at.f) * kDegree;
    const double heading = mixedAngle(a.dirHeading, b.dirHeading, at.f) * kDegree;
    state.sunDirection = Vec3f(
        Vec3(std::cos(pitch) * std::cos(heading), std::cos(pitch) * std::sin(heading), std::sin(pitch)));
    state.sunColour = glm::mix(colourOf(a.dirColour) * a.dirBright, colourOf(b.dirColour) * b.dirBright, f);
    state.ambient = glm::mix(colourOf(a.ambColour) * a.ambBright, colourOf(b.ambColour) * b.ambBright, f);
    state.fogColour = glm::mix(colourOf(a.fogColour), colourOf(b.fogColour), f);
    if (a.maxFog > 0.0f && b.maxFog > 0.0f) {
        state.fogNear = static_cast<float>(mixed(a.minFog, b.minFog, at.f));
        state.fogFar = static_cast<float>(mixed(a.maxFog, b.maxFog, at.f));
    }
    return state;
}

bool isShown(const dat::SkyObject& object, double time) {
    const double t = fractionOf(time);
    const double begin = object.beginTime, end = object.endTime;
    if (begin == end)
        return true;
    return begin < end ? begin <= t && t <= end : t >= begin || t <= end;
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

void skyPlacements(const Sky& sky, std::uint32_t dayGroup, double time, double seconds,
                   std::vector<SkyPlacement>& out) {
    out.clear();
    const dat::DayGroup* group = groupOf(sky, dayGroup);
    if (group == nullptr)
        return;
    const double t = fractionOf(time);
    const Between at = keyframesAt(*group, t);
    for (std::uint32_t i = 0; i < sky.parts.size(); ++i) {
        const SkyPart& part = sky.parts[i];
        if (part.dayGroup != dayGroup || !isShown(part.object, t))
            continue;
        const dat::SkyObjectReplace* from = replaceOf(at.from, part.objectIndex);
        if (part.replacement != (from != nullptr ? from->gfxObj : 0))
            continue;
        SkyPlacement placement;
        placement.part = i;
        double turn = 0.0;
        if (from != nullptr) {
            const dat::SkyObjectReplace* to = replaceOf(at.to, part.objectIndex);
            to = to != nullptr ? to : from;
            turn = mixedAngle(from->rotate, to->rotate, at.f);
            placement.transparent = asFraction(mixed(from->transparent, to->transparent, at.f));
            const double bright = mixed(from->luminosity, to->luminosity, at.f);
            const double most = mixed(from->maxBright, to->maxBright, at.f);
            placement.luminosity = bright > 0.0 ? asFraction(bright) : most > 0.0 ? asFraction(most) : 1.0f;
        }
        placement.rotation =
            rotationAbout(1, -arcAngle(part.object, t) * kDegree) * rotationAbout(2, -turn * kDegree);
        placement.uvOffset = {
            static_cast<float>(std::fmod(static_cast<double>(part.object.texVelocityX) * seconds, 1.0)),
            static_cast<float>(std::fmod(static_cast<double>(part.object.texVelocityY) * seconds, 1.0))};
        out.push_back(placement);
    }
}

} // namespace limen::world
