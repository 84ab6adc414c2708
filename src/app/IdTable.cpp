#include "app/IdTable.h"

#include "app/Parse.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::app {
namespace {

constexpr std::array<const char*, 8> kKindNames{"shell",  "terrain", "exterior", "scenery",
                                                "static", "dynamic", "filling",  "sky"};

std::uint32_t polygonCount(const world::World& world, world::InstanceIndex instance) {
    const std::uint32_t mesh = world.instances[instance].mesh;
    return mesh < world.meshes.size() ? world.meshes[mesh].polygonCount : 0;
}

} // namespace

std::string spaceName(const world::World& world, world::SpaceIndex space) {
    if (space == world::kOutside)
        return "outside";
    return space < world.spaces.size() ? hexId(world.spaces[space].cellId) : "none";
}

IdTable::IdTable(const world::World& world) : world_(world) {
    for (world::InstanceIndex i = 0; i < world.instances.size(); ++i) {
        if (polygonCount(world, i) > 0)
            byId_.push_back(i);
    }
    std::sort(byId_.begin(), byId_.end(),
              [&](auto a, auto b) { return world_.instances[a].idBase < world_.instances[b].idBase; });
}

world::InstanceIndex IdTable::instance(std::uint32_t id) const {
    const auto after =
        std::upper_bound(byId_.begin(), byId_.end(), id, [&](std::uint32_t wanted, world::InstanceIndex i) {
            return wanted < world_.instances[i].idBase;
        });
    if (after == byId_.begin())
        return world::kNone;
    const world::InstanceIndex found = *(after - 1);
    return id - world_.instances[found].idBase < polygonCount(world_, found) ? found : world::kNone;
}

IdMeaning IdTable::meaning(std::uint32_t id) const {
    if (id == kVoidPixel)
        return {"none", "void", hexId(0), "", 0};
    if (id == kSkyPixel)
        return {"outside", "sky", hexId(0), "", 0};
    const world::InstanceIndex index = instance(id);
    if (index == world::kNone)
        return {"none", "unknown", hexId(0), "", id};
    const world::Instance& found = world_.instances[index];
    const std::uint32_t number = id - found.idBase;
    const std::size_t info = world_.meshes[found.mesh].firstPolygonInfo + std::size_t{number};
    const std::uint32_t polygon = info < world_.polygonIds.size() ? world_.polygonIds[info] : number;
    return {spaceName(world_, found.placedIn), kKindNames.at(static_cast<std::size_t>(found.kind)),
            hexId(found.record), fmt::format("{:016X}", found.object), polygon};
}

} // namespace limen::app
