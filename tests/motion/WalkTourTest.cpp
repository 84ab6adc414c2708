// A body walks the built-in world's tour, through rooms, up and down stairs, into a cellar, an inn, a tower,
// a cave and a dungeon, and over the land between them.
#include "motion/Body.h"
#include "motion/Locate.h"
#include "support/LoadTestWorld.h"
#include "world/Places.h"
#include "worlds/Demo.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

/// The part of the world around a body, and the body.
class Wanderer {
public:
    explicit Wanderer(const dat::Archive& archive) : archive_(archive) {}

    void put(const world::Place& place) {
        loadAround(place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye));
        const world::SpaceIndex space = place.cell != 0 ? world::findCell(here_->world, place.cell)
                                                        : locate(here_->world, place.eye).space;
        const Vec3 feet = place.eye - Vec3(0.0, 0.0, shape_.eyeHeight);
        body = bodyAt({feet, sweep(here_->world, space, place.eye, shape_.capsule.middle(feet))});
    }

    /// Walks straight to a place. False if the body gets stuck, or ends above or below.
    [[nodiscard]] bool goTo(const world::Place& place) {
        const Standing& at = body.standing;
        const dat::RecordId cell = here_->world.spaces[at.space].cellId;
        loadAround(at.space == world::kOutside ? world::blockAt(at.feet) : dat::blockOf(cell));
        const Vec3 feet = place.eye - Vec3(0.0, 0.0, shape_.eyeHeight);
        for (double stuck = 0.0; stuck < 1.0;) {
            const double before = levelDistance(feet);
            if (before < 0.15)
                return std::abs(at.feet.z - feet.z) < 0.5;
            const Vec3 way = feet - at.feet;
            body = moved(body, {.forward = 1.0, .yaw = glm::degrees(std::atan2(way.x, way.y))}, 0.03,
                         here_->collisions, {});
            stuck = levelDistance(feet) < before - 0.005 ? 0.0 : stuck + 0.03;
        }
        return false;
    }

    /// Walks straight ahead, until it is in a cell. False if it is outside after `seconds`.
    [[nodiscard]] bool entersWithin(double seconds, double yaw) {
        for (double t = 0.0; t < seconds && body.standing.space == world::kOutside; t += 0.03)
            body = moved(body, {.forward = 1.0, .yaw = yaw}, 0.03, here_->collisions, {});
        return body.standing.space != world::kOutside;
    }

    /// Whether the body's space fits its position; true for cells without a tree.
    [[nodiscard]] bool isWhereItSays() const {
        const Vec3 middle = shape_.capsule.middle(body.standing.feet);
        const world::Space& space = here_->world.spaces[body.standing.space];
        if (body.standing.space == world::kOutside)
            return locate(here_->world, middle).space == world::kOutside;
        return space.bspNodeCount == 0 || cellContains(here_->world, body.standing.space, middle);
    }

    BodyState body;

private:
    struct LoadedPart {
        LoadedPart(const dat::Archive& archive, dat::BlockCoord around)
            : centre(around), world(*world::loadWorld(archive, around, {.radius = 1})),
              collisions(world, *world::loadSolids(archive, world, around, 1)) {}
        dat::BlockCoord centre;
        world::World world;
        Collisions collisions;
    };

    [[nodiscard]] double levelDistance(const Vec3& to) const {
        return std::hypot(to.x - body.standing.feet.x, to.y - body.standing.feet.y);
    }

    void loadAround(dat::BlockCoord centre) {
        if (here_ && here_->centre == centre)
            return;
        auto next = std::make_unique<LoadedPart>(archive_, centre);
        for (Standing* standing : {&body.standing, &body.safe})
            if (here_ && standing->space != world::kOutside)
                standing->space = world::findCell(next->world, here_->world.spaces[standing->space].cellId);
        here_ = std::move(next);
    }
    const dat::Archive& archive_;
    std::unique_ptr<LoadedPart> here_;
    const BodyShape shape_;
};

/// Way points that a body cannot reach on foot: the camera passes over a table in the inn, and flies from the
/// tower's top to the cave.
bool isFlown(std::size_t point) {
    return (point >= 787 && point <= 788) || (point >= 1389 && point <= 1565);
}

struct BuiltIn {
    BuiltIn() {
        EXPECT_TRUE(worlds::writeBuiltInWorld(directory.path()));
        archive = dat::Archive::open(directory.path());
        file = world::loadWorldFile(directory.path());
        EXPECT_TRUE(archive && file);
    }
    test::TempDir directory;
    Result<dat::Archive> archive = Failure(Error());
    Result<world::WorldFile> file = Failure(Error());
};

TEST(WalkTour, walkingAheadFromTheStartEntersAHouse) {
    const BuiltIn builtIn;
    const std::vector<world::Place>& places = builtIn.file->places;
    const auto start = std::find_if(places.begin(), places.end(), [&](const world::Place& place) {
        return place.name == builtIn.file->start;
    });
    ASSERT_NE(start, places.end());
    Wanderer wanderer(*builtIn.archive);
    wanderer.put(*start);
    ASSERT_EQ(wanderer.body.standing.space, world::kOutside);
    EXPECT_TRUE(wanderer.entersWithin(10.0, start->yaw));
}

TEST(WalkTour, reachesEveryWayPointThatIsNotFlownTo) {
    const BuiltIn builtIn;
    const std::vector<world::Place>& tour = builtIn.file->tour;
    ASSERT_EQ(tour.size(), 1704u) << "isFlown counts them";
    Wanderer wanderer(*builtIn.archive);
    wanderer.put(tour.front());
    for (std::size_t i = 1; i < tour.size(); ++i) {
        const world::Place& point = tour[i];
        if (isFlown(i)) {
            wanderer.put(point);
            continue;
        }
        ASSERT_TRUE(wanderer.goTo(point))
            << "way point " << i << ": " << point.eye.x << " " << point.eye.y << " " << point.eye.z;
        ASSERT_TRUE(wanderer.isWhereItSays()) << "way point " << i;
        ASSERT_EQ(wanderer.body.recoveries, 0u);
    }
}

} // namespace
} // namespace limen::motion
