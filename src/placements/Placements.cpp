#include "placements/Placements.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace limen::placements {
namespace {

constexpr std::array<std::pair<TemplateType, const char*>, 10> kTypeNames{{
    {TemplateType::Generic, "generic"},
    {TemplateType::Portal, "portal"},
    {TemplateType::Creature, "creature"},
    {TemplateType::Vendor, "vendor"},
    {TemplateType::Door, "door"},
    {TemplateType::Chest, "chest"},
    {TemplateType::Container, "container"},
    {TemplateType::PressurePlate, "pressure plate"},
    {TemplateType::Lifestone, "lifestone"},
    {TemplateType::Switch, "switch"},
}};
constexpr std::string_view kNumbered = "type ";

} // namespace

std::string typeName(std::int32_t type) {
    for (const auto& [known, name] : kTypeNames)
        if (static_cast<std::int32_t>(known) == type)
            return name;
    return std::string(kNumbered) + std::to_string(type);
}

std::optional<std::int32_t> parseType(const std::string& name) {
    for (const auto& [known, text] : kTypeNames)
        if (name == text)
            return static_cast<std::int32_t>(known);
    const std::string_view digits =
        std::string_view(name).substr(name.starts_with(kNumbered) ? kNumbered.size() : 0);
    std::int32_t type = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), type);
    if (error != std::errc() || end != digits.data() + digits.size())
        return std::nullopt;
    return type;
}

std::size_t countPlacements(const Content& content) {
    std::size_t count = 0;
    for (const auto& [id, landblock] : content.landblocks)
        count += landblock.placements.size();
    return count;
}

} // namespace limen::placements
