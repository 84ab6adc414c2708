#pragma once

#include "motion/Body.h"
#include "support/LoadTestWorld.h"
#include "world/MovingEntries.h"

namespace limen::test {

inline constexpr double kYawNorth = 0.0, kYawEast = 90.0, kYawSouth = 180.0, kYawWest = 270.0; ///< degrees

/// A body in a small world.
class Walker {
public:
    explicit Walker(TestWorld& source, const world::MovingEntries& moving = {}) : source_(source) {
        const TempDir directory;
        EXPECT_TRUE(source.write(directory.path()));
        const Result<dat::Archive> archive = dat::Archive::open(directory.path());
        Result<world::World> loaded = world::loadWorld(*archive, source.home(), {.radius = 1}, moving);
        EXPECT_TRUE(loaded) << "no world";
        world_ = std::move(*loaded);
        Result<world::Solids> solids = world::loadSolids(*archive, world_, source.home(), 1);
        EXPECT_TRUE(solids) << "no solids";
        collisions_.emplace(world_, std::move(*solids));
    }

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] const motion::Collisions& collisions() const { return *collisions_; }
    [[nodiscard]] Vec3 at(double x, double y, double z) const { return toGlobal(source_, {x, y, z}); }
    [[nodiscard]] world::SpaceIndex space(TestWorld::Cell cell) const {
        return world::findCell(world_, source_.id(cell));
    }

    void put(const Vec3& local, world::SpaceIndex space) {
        body = motion::bodyAt({at(local.x, local.y, local.z), space});
    }
    /// Moves for `seconds`, in frames of 30 ms.
    void go(double yaw, double seconds, bool run = false, bool jump = false) {
        motion::BodyInput input{.forward = 1.0, .right = 0.0, .yaw = yaw, .run = run, .jump = jump};
        for (double t = 0.0; t < seconds; t += 0.03) {
            body = motion::moved(body, input, 0.03, *collisions_, doors);
            input.jump = false;
        }
    }
    void stand(double seconds) {
        for (double t = 0.0; t < seconds; t += 0.03)
            body = motion::moved(body, {}, 0.03, *collisions_, doors);
    }
    /// The feet, block-local.
    [[nodiscard]] Vec3 feet() const { return body.standing.feet - at(0, 0, 0); }

    motion::BodyState body;
    std::vector<double> doors; ///< openness of each door; beyond the end that of the world file

private:
    TestWorld& source_;
    world::World world_;
    std::optional<motion::Collisions> collisions_;
};

} // namespace limen::test
