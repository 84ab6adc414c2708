#include "engine/DayGroup.h"

#include "core/Assert.h"
#include "core/Nearest.h"
#include "world/Sky.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::engine {
namespace {

std::string labels(const dat::SkyDesc& sky) {
    std::string text;
    for (std::uint32_t group = 0; group < sky.dayGroups.size(); ++group)
        text += (group > 0 ? ", " : "") + dayGroupLabel(sky, group);
    return text;
}

} // namespace

std::string dayGroupLabel(const dat::SkyDesc& sky, std::uint32_t group) {
    LIMEN_ASSERT(group < sky.dayGroups.size(), "a day group of this sky");
    const std::string& name = sky.dayGroups[group].name;
    const auto alike = std::count_if(sky.dayGroups.begin(), sky.dayGroups.end(),
                                     [&](const dat::DayGroup& other) { return other.name == name; });
    if (name.empty())
        return std::to_string(group);
    return alike > 1 ? fmt::format("{} ({})", name, group) : name;
}

Result<std::uint32_t> dayGroupOf(const dat::SkyDesc& sky, const dat::GameTime& calendar,
                                 const DayChoice& choice) {
    const std::string& text = choice.day;
    if (text.empty())
        return world::dayGroupOn(choice.date, calendar, sky.dayGroups.size());
    if (const std::optional<std::uint32_t> group = world::dayGroupNamed(sky, text))
        return *group;
    if (sky.dayGroups.empty())
        return fail(ErrorCode::NotFound, "--day", "this world has no kinds of days; leave --day out");
    std::vector<std::string> names;
    for (const dat::DayGroup& group : sky.dayGroups)
        names.push_back(group.name);
    const std::vector<std::string> similar = nearest(text, names, 1);
    return fail(ErrorCode::NotFound, "--day",
                fmt::format("unknown kind of day '{}'; this world has {}{}", text, labels(sky),
                            similar.empty() ? "" : "." + didYouMean(similar)));
}

} // namespace limen::engine
