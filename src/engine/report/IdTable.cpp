#include "engine/report/IdTable.h"

#include "core/Assert.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::engine {
namespace {

constexpr std::array<const char*, 8> kKindNames{"shell",  "terrain", "exterior", "scenery",
                                                "static", "dynamic", "filling",  "sky"};

std::uint32_t polygonCount(const world::World& world, const world::Instance& instance) {
    return instance.mesh < world.meshes.size() ? world.meshes[instance.mesh].polygonCount : 0;
}

/// The dynamic instance that an id belongs to; null: none.
const world::Instance* instanceIn(const world::World& world, const world::DynamicState& dynamics,
                                  std::uint32_t id) {
    const auto found = std::find_if(
        dynamics.instances.begin(), dynamics.instances.end(), [&](const world::Instance& instance) {
            return id >= instance.idBase && id - instance.idBase < polygonCount(world, instance);
        });
    return found == dynamics.instances.end() ? nullptr : &*found;
}

} // namespace

std::string spaceName(const world::World& world, world::SpaceIndex space) {
    if (space == world::kOutside)
        return "outside";
    return space < world.spaces.size() ? dat::idText(world.spaces[space].cellId) : "none";
}

IdTable::IdTable(const world::World& world) : world_(world) {
    for (const auto* instances : {&world.instances, &world.movingParts}) {
        for (const world::Instance& instance : *instances)
            if (polygonCount(world, instance) > 0)
                byId_.push_back(&instance);
    }
    std::sort(byId_.begin(), byId_.end(), [](const auto* a, const auto* b) { return a->idBase < b->idBase; });
}

const world::Instance* IdTable::instance(std::uint32_t id) const {
    const auto after =
        std::upper_bound(byId_.begin(), byId_.end(), id,
                         [](std::uint32_t wanted, const world::Instance* i) { return wanted < i->idBase; });
    if (after == byId_.begin())
        return nullptr;
    const world::Instance* found = *(after - 1);
    return id - found->idBase < polygonCount(world_, *found) ? found : nullptr;
}

IdMeaning IdTable::meaning(std::uint32_t id, const world::DynamicState& dynamics) const {
    if (id == kVoidPixel)
        return {"none", "void", dat::idText(0), "", 0};
    if (id == kSkyPixel)
        return {"outside", "sky", dat::idText(0), "", 0};
    const world::Instance* moving = instanceIn(world_, dynamics, id);
    const world::Instance* known = moving != nullptr ? moving : instance(id);
    if (known == nullptr)
        return {"none", "unknown", dat::idText(0), "", id};
    const world::Instance& found = *known;
    const std::uint32_t number = id - found.idBase;
    LIMEN_ASSERT(found.mesh < world_.meshes.size(), "the dynamic state is of this world");
    const std::size_t info = world_.meshes[found.mesh].firstPolygonInfo + std::size_t{number};
    const std::uint32_t polygon = info < world_.polygonIds.size() ? world_.polygonIds[info] : number;
    return {spaceName(world_, found.placedIn), kKindNames.at(static_cast<std::size_t>(found.kind)),
            dat::idText(found.record), fmt::format("{:016X}", found.object), polygon};
}

} // namespace limen::engine
