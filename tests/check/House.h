#pragma once

#include "check/views/Viewpoints.h"
#include "support/LoadTestWorld.h"

#include <memory>

namespace limen::check::test {

/// A house of two rooms with a door between them and one to the outside, on flat ground, and a tour through
/// both doors.
struct House {
    limen::test::TestWorld source;
    limen::test::TestWorld::Cell front = source.addBox({90, 80, 10}, {96, 86, 13}, "brown"),
                                 rear = source.addBox({96, 80, 10}, {100, 86, 13}, "blue");
    world::World world;
    std::unique_ptr<reference::Scene> scene;
    std::vector<world::Place> tour;

    House() {
        using limen::test::rectangle;
        source.link(front, rectangle({96, 82, 10}, {96, 83, 12}), rear);
        const auto exit = source.openOutside(front, rectangle({92, 86, 10.1}, {93.2, 86, 12.1}));
        source.addBuilding(limen::test::boxExterior({90, 80, 10}, {100, 86, 13}), {exit});
        source.setFlatTerrain(source.home(), 5);
        world = limen::test::loadTestWorld(source);
        scene = std::make_unique<reference::Scene>(world);
        const auto place = [&](const Vec3& local, double yaw, dat::RecordId cell) {
            world::Place p;
            p.eye = at(local);
            p.yaw = yaw;
            p.cell = cell;
            tour.push_back(p);
        };
        place({92.5, 95, 11.7}, 180, 0);
        place({92.5, 82.5, 11.7}, 90, source.id(front));
        place({99, 82.5, 11.7}, 350, source.id(rear));
    }
    [[nodiscard]] Vec3 at(const Vec3& local) const { return limen::test::toGlobal(source, local); }
    [[nodiscard]] Surroundings around(std::uint64_t seed = 1) const {
        return {world, *scene, source.home(), seed, 32, 18, tour};
    }
    [[nodiscard]] world::SpaceIndex space(limen::test::TestWorld::Cell cell) const {
        return world::findCell(world, source.id(cell));
    }
};

} // namespace limen::check::test
