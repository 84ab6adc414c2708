#pragma once

#include "geometry/Vec.h"
#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <cstdint>
#include <span>
#include <vector>

// Decisions of the gates that draw without an ownership test: which spaces they draw, in which order, and which
// openings they write into depth. Pure functions of a flood in which every space is a zone of its own
// (frame/WorldGraph.h): each of its visits is one convex region of one space.
namespace limen::frame {

/// Numbers of the visits from far to near: each after all visits beyond it, and far siblings first.
[[nodiscard]] std::vector<std::uint32_t> farToNear(std::span<const visibility::Visit> visits);

/// The building exteriors of a world.
struct Exteriors {
    std::vector<world::InstanceIndex> all;
    /// By portal: for the outside's, the exterior of its block whose vertices are nearest to the opening's corners.
    /// world::kNone for others, and for blocks without exteriors.
    std::vector<world::InstanceIndex> ofOpening;
};
[[nodiscard]] Exteriors exteriorsOf(const world::World& world);

/// A building that the eye sees into, in Gate::Depth.
struct SeenBuilding {
    world::InstanceIndex exterior = world::kNone;
    std::uint32_t block = 0;
    std::vector<std::uint32_t> visits;   ///< to its cells, far to near
    std::vector<std::uint32_t> openings; ///< the visits that enter it from outside, each portal once
};

/// One step of drawing the landscape in Gate::Depth.
struct LandscapeStep {
    enum class Kind : std::uint8_t {
        Block,    ///< the ground of a block
        Exterior, ///< of a building that is not seen into
        Building  ///< its openings, its cells, then its exterior
    } kind = Kind::Block;
    std::uint32_t index = 0; ///< into World::blocks; World::instances; DepthViews::buildings
    friend bool operator==(const LandscapeStep&, const LandscapeStep&) = default;
};

/// The parts of a frame in Gate::Depth. A visit to the outside through the cells of a building is in no part: the
/// landscape has been drawn before.
struct DepthViews {
    std::vector<std::uint32_t> landscape; ///< visits to the outside, far to near; empty: not seen
    std::vector<SeenBuilding> buildings;  ///< far to near
    std::vector<LandscapeStep> steps;     ///< far to near; each block, followed by its buildings
    std::vector<std::uint32_t> inside;    ///< visits to cells without going outside, far to near
    std::vector<std::uint32_t> fences;    ///< visits from those cells to the outside, each portal once
    [[nodiscard]] bool clearsDepth() const { return !fences.empty(); }
};

/// `exteriors`: of the world. `eye`: global. Blocks are ordered by the distance of their nearest point,
/// buildings of a block by the distance of the nearest point of their bounds.
[[nodiscard]] DepthViews depthViews(const world::World& world, const Exteriors& exteriors,
                                    std::span<const visibility::Visit> visits, const Vec3& eye);

/// The spaces of visits that are in order far to near, each once, where its last visit is.
[[nodiscard]] std::vector<std::uint32_t> spacesOf(std::span<const visibility::Visit> visits,
                                                  std::span<const std::uint32_t> order);

} // namespace limen::frame
