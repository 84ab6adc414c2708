#include "engine/LoadedPart.h"

#include "core/Assert.h"
#include "frame/WorldGraph.h"
#include "motion/Locate.h"

#include <fmt/format.h>
#include <utility>

namespace limen::engine {

Result<std::shared_ptr<const LoadedPart>> loadPart(const dat::Archive& archive, const PartTarget& target,
                                                   const world::MovingEntries& moving,
                                                   const world::LoadHelp& help) {
    Result<world::World> world = world::loadWorld(archive, target.centre, target.options, moving, help);
    if (!world)
        return Failure(world.error());
    return partOf(std::move(*world), target);
}

Result<std::shared_ptr<const LoadedPart>> partOf(world::World world, const PartTarget& target) {
    Result<visibility::Graph> graph = frame::visibilityGraph(world);
    if (!graph)
        return Failure(graph.error());
    return std::make_shared<const LoadedPart>(std::move(world), std::move(*graph), target);
}

dat::BlockCoord blockAround(const dat::Archive& archive, const LoadedPart& shown, dat::RecordId cell,
                            const Vec3& eye) {
    if (cell != 0)
        return dat::blockOf(cell);
    const dat::BlockCoord below = world::blockAt(eye);
    return below == shown.target.centre || !world::isDungeon(archive, below) ? below : shown.target.centre;
}

dat::RecordId cellOf(const world::World& world, world::SpaceIndex space) {
    LIMEN_ASSERT(space < world.spaces.size(), "a space of this world");
    return space == world::kOutside ? 0 : world.spaces[space].cellId;
}

world::SpaceIndex rootIn(const LoadedPart& part, dat::RecordId cell, const Vec3& eye) {
    const world::SpaceIndex root = cell == 0 ? world::kOutside : world::findCell(part.world, cell);
    // If the cell is not loaded (a damaged block, or one that was left out), the position decides.
    return root != world::kNone ? root : motion::locate(part.world, eye).space;
}

std::string findingsLine(const world::World& world) {
    if (world.findings.empty())
        return {};
    const world::Finding& first = world.findings.front();
    const std::string rest =
        world.findings.size() > 1 ? fmt::format(" (and {} more)", world.findings.size() - 1) : "";
    return fmt::format("limen: in the world's data: {}: {}{}", dat::idText(first.record), first.what, rest);
}

} // namespace limen::engine
