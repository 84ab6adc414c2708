#pragma once

#include "reference/Scene.h"
#include "support/LoadTestWorld.h"
#include "support/TestWorld.h"

#include <cstring>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace limen::test {

/// Compares to the bit.
inline bool same(const reference::Answer& a, const reference::Answer& b) {
    return a.id == b.id && std::memcmp(&a.t, &b.t, sizeof a.t) == 0 && a.space == b.space &&
           a.reachedOutside == b.reachedOutside && a.spacesVisited == b.spacesVisited && a.layers == b.layers;
}

/// A world loaded from dats, and its scene. Positions are metres local to the home block.
class TracedWorld {
public:
    explicit TracedWorld(TestWorld& source, const world::LoadOptions& options = {.radius = 1},
                         const reference::RuleOptions& rule = {})
        : world_(loadTestWorld(source, options)), origin_(toGlobal(source, Vec3(0.0))), scene_(world_, rule) {
    }

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] reference::Scene& scene() { return scene_; }
    [[nodiscard]] const Vec3& origin() const { return origin_; }
    [[nodiscard]] world::SpaceIndex space(dat::RecordId cell) const {
        const world::SpaceIndex found = world::findCell(world_, cell);
        EXPECT_NE(found, world::kNone) << "no such cell";
        return found;
    }

    /// The ray from `eye` along `direction`, of any length; t counts lengths of `direction`.
    [[nodiscard]] reference::Answer trace(world::SpaceIndex root, const Vec3& eye, const Vec3& direction,
                                          double nearPlane = 0.02) const {
        return scene_.trace(root, {origin_ + eye, direction, nearPlane});
    }

    /// The world's instance with an id; kNone for void, sky and moving instances.
    [[nodiscard]] world::InstanceIndex instanceOf(std::uint32_t id) const {
        for (world::InstanceIndex i = 0; i < world_.instances.size(); ++i) {
            const world::Instance& in = world_.instances[i];
            if (id >= in.idBase && id - in.idBase < world_.meshes[in.mesh].polygonCount)
                return i;
        }
        return world::kNone;
    }
    [[nodiscard]] world::InstanceKind kindOf(std::uint32_t id) const {
        const world::InstanceIndex i = instanceOf(id);
        EXPECT_NE(i, world::kNone) << "id " << id << " belongs to no instance";
        return i == world::kNone ? world::InstanceKind::Sky : world_.instances[i].kind;
    }
    /// True if the id is of the shell of that cell.
    [[nodiscard]] bool isShell(std::uint32_t id, world::SpaceIndex cell) const {
        return instanceOf(id) != world::kNone && instanceOf(id) == world_.spaces[cell].shell;
    }

private:
    world::World world_;
    Vec3 origin_;
    reference::Scene scene_;
};

/// Two rooms, 4 × 4 × 3 m, joined by a door 1 m wide and 2 m high in the plane x = 4.
struct TwoRooms {
    TestWorld world;
    TestWorld::Cell west = world.addBox({0, 0, 10}, {4, 4, 13}, "brown");
    TestWorld::Cell east = world.addBox({4, 0, 10}, {8, 4, 13}, "blue");
    explicit TwoRooms(const TestWorld::LinkOptions& options = {}) {
        world.link(west, rectangle({4, 1.5, 10}, {4, 2.5, 12}), east, options);
    }
};

/// One room, 6 × 6 × 3 m, on flat ground at z = 0 (its floor 0.1 m higher), with a door in its northern wall
/// (y = 86) and a window in its southern one (y = 80), and its building around it.
struct House {
    TestWorld world;
    TestWorld::Cell room = world.addBox({90, 80, 0.1}, {96, 86, 3.1}, "brown");
    House() {
        world.setFlatTerrain(world.home(), 0);
        const auto door = world.openOutside(room, rectangle({92, 86, 0.1}, {94, 86, 2.1}));
        const auto window = world.openOutside(room, rectangle({92, 80, 1}, {94, 80, 2}));
        world.addBuilding(boxExterior({90, 80, -1}, {96, 86, 3.2}), {door, window});
    }
};

} // namespace limen::test
