#pragma once

#include "dat/Archive.h"
#include "engine/report/IdTable.h"
#include "frame/Planner.h"
#include "frame/StaticScene.h"
#include "motion/DynamicStateBuilder.h"
#include "visibility/Graph.h"
#include "world/Loader.h"

#include <memory>

namespace limen::engine {

/// Identifies a part of the world: the blocks around `centre`, with loading options.
struct PartTarget {
    dat::BlockCoord centre;
    world::LoadOptions options;
    friend bool operator==(const PartTarget&, const PartTarget&) = default;
};

/// A part of a world in memory. Immutable, so that threads may share it. Never moves: `ids` and `scene` refer
/// to `world`.
struct LoadedPart {
    LoadedPart(world::World loaded, visibility::Graph portals, const PartTarget& asked)
        : world(std::move(loaded)), graph(std::move(portals)), ids(world), scene(world), target(asked) {}
    LoadedPart(const LoadedPart&) = delete;
    LoadedPart& operator=(const LoadedPart&) = delete;

    const world::World world;
    const visibility::Graph graph;
    const IdTable ids;
    const frame::StaticScene scene;
    const PartTarget target; ///< as it was requested
};

/// Reads the blocks around `target.centre`. Errors: the loader's; portals that the graph refuses.
[[nodiscard]] Result<std::shared_ptr<const LoadedPart>> loadPart(const dat::Archive& archive,
                                                                 const PartTarget& target,
                                                                 const world::MovingEntries& moving = {},
                                                                 const world::LoadHelp& help = {});
/// Makes a part of a world that is in memory already. Errors: portals that the graph refuses.
[[nodiscard]] Result<std::shared_ptr<const LoadedPart>> partOf(world::World world,
                                                               const PartTarget& target = {});

/// A part, and the memory for planning its frames. For one thread at a time.
struct PartPlanner {
    explicit PartPlanner(std::shared_ptr<const LoadedPart> loaded)
        : part(std::move(loaded)), planner(part->scene), dynamics(part->world) {}

    const std::shared_ptr<const LoadedPart> part; // first: the others refer to it
    frame::Planner planner;
    motion::DynamicStateBuilder dynamics;
};

/// The block to load around an eye in the cell `cell` (0: outside). For an eye outside above a dungeon's
/// block, it is the centre of `shown`: that block has no landscape, and the dungeon is not visible from
/// outside.
[[nodiscard]] dat::BlockCoord blockAround(const dat::Archive& archive, const LoadedPart& shown,
                                          dat::RecordId cell, const Vec3& eye);

/// The record id of the cell of a space; 0: the outside.
[[nodiscard]] dat::RecordId cellOf(const world::World& world, world::SpaceIndex space);

/// The eye's space in another part of the world. `cell`: the record id of the cell it was in (0: outside).
[[nodiscard]] world::SpaceIndex rootIn(const LoadedPart& part, dat::RecordId cell, const Vec3& eye);

/// The first defect found in a world's data, as one line of text; empty if there is none.
[[nodiscard]] std::string findingsLine(const world::World& world);

} // namespace limen::engine
