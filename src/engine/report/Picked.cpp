#include "engine/report/Picked.h"

#include "core/Assert.h"
#include "engine/report/VisitTree.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace limen::engine {

Picked pickedPixel(const world::World& world, const IdTable& table, const world::DynamicState& dynamics,
                   const visibility::VisibleSet& visible, std::uint32_t id, std::uint32_t visit,
                   double distance) {
    Picked picked;
    picked.meaning = table.meaning(id, dynamics);
    picked.distance = distance;
    if (const world::Instance* instance = table.instance(id); instance != nullptr) {
        picked.object = instance->object;
        const auto placed =
            std::find_if(world.placed.begin(), world.placed.end(), [&](const world::PlacedObject& object) {
                return object.object == instance->object;
            });
        if (placed != world.placed.end())
            picked.placed = fmt::format("{}, template {}", placed->name, placed->templateId);
        picked.isLandscape = instance->kind == world::InstanceKind::Terrain;
    }
    while (visit < visible.visits.size()) {
        picked.chain.push_back(visitLabel(world, visible, visit));
        const std::uint32_t parent = visible.visits[visit].parent;
        LIMEN_ASSERT(parent < visit || parent >= visible.visits.size(), "parents come before children");
        visit = parent;
    }
    std::reverse(picked.chain.begin(), picked.chain.end());
    return picked;
}

std::vector<std::string> pickedLines(const Picked& picked) {
    const IdMeaning& meaning = picked.meaning;
    std::vector<std::string> lines;
    if (!picked.placed.empty())
        lines.push_back(picked.placed);
    if (meaning.object.empty()) {
        lines.push_back(meaning.kind);
    } else {
        lines.push_back(fmt::format("{} {}, polygon {}", meaning.kind, meaning.record, meaning.polygon));
        lines.push_back(fmt::format("object {}, placed in {}", meaning.object, meaning.space));
    }
    if (std::isfinite(picked.distance))
        lines.push_back(fmt::format("{:.2f} m away", picked.distance));
    lines.insert(lines.end(), picked.chain.begin(), picked.chain.end());
    return lines;
}

} // namespace limen::engine
