// Bodies that walk, run, jump and use doors at random for a minute each. None may leave the world, overlap a
// wall, be stuck where there is room, or be in a space that its position contradicts. LIMEN_TEST_BODIES:
// number of bodies in each kind of world (48). LIMEN_TEST_SHARE=K/N: only the K-th part of N, from 0.
// LIMEN_TEST_BODY: only the body with this number.
#include "geometry/Compass.h"
#include "motion/DoorUse.h"
#include "motion/Locate.h"
#include "worlds/Demo.h"
#include "worlds/GeneratedWorlds.h"

#include <cstdlib>
#include <fmt/format.h>
#include <random>

namespace limen::motion {
namespace {

using world::kOutside;
using worlds::GeneratedKind;
using worlds::test::GeneratedWorld;

constexpr double kBodyFrame = 1.0 / 30.0;
constexpr int kFrames = 1800, kFramesEach = 15; ///< of a life; of one random action
constexpr double kMostDeep = 0.01;              ///< metres of overlap: the skin, and Bullet's rounding
constexpr double kLeastWay = 0.1;               ///< metres that a body moves if it is not stuck
constexpr double kBorder = 6.0;                 ///< metres from the end of the land where bodies turn back

const Vec3 kUp(0.0, 0.0, 1.0);

/// A part of a world, loaded around one of its blocks.
struct Part {
    Part(const dat::Archive& archive, dat::BlockCoord around, const world::WorldFile& of)
        : centre(around), file(of), world(*world::loadWorld(archive, around, {.radius = 1}, of.moving)),
          collisions(world, *world::loadSolids(archive, world, around, 1)) {}
    dat::BlockCoord centre;
    const world::WorldFile& file;
    world::World world;
    Collisions collisions;
};

/// One body with its random generator.
class Life {
public:
    Life(const Part& part, std::uint32_t number) : part_(part), random_(number) {}

    /// False: no free position was found.
    [[nodiscard]] bool begin() {
        if (random() < 0.3)
            use_.putAll(part_.world, 1.0);
        use_.write(part_.world, doors_);
        for (int i = 0; i < 400; ++i) {
            const std::optional<Standing> place = somewhere();
            if (!place || wayOut(*place) > 0.0)
                continue;
            body_ = bodyAt(*place);
            body_.safe = *place;
            return true;
        }
        return false;
    }

    /// Lives for a minute. Returns the fault; empty: none.
    [[nodiscard]] std::string live() {
        std::string wrong;
        for (int frame = 0; frame < kFrames && wrong.empty(); ++frame) {
            if (frame % kFramesEach == 0)
                choose();
            step();
            if (frame % 3 == 0)
                wrong = fault();
        }
        return wrong.empty() && isStuck() ? "is stuck" : wrong;
    }

    [[nodiscard]] const BodyState& body() const { return body_; }

private:
    double random(double least = 0.0, double most = 1.0) {
        return std::uniform_real_distribution<>(least, most)(random_);
    }
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }
    [[nodiscard]] Vec3 middle(const Standing& at) const { return shape_.capsule.middle(at.feet); }
    [[nodiscard]] double wayOut(const Standing& at) const {
        return glm::length(part_.collisions.wayOut(shape_.capsule, at, doors_));
    }

    std::optional<Standing> somewhere() {
        const double what = random();
        if (what < 0.4)
            return atAPlace();
        return what < 0.8 && part_.world.spaces.size() > 1 ? inACell() : fromTheSky();
    }
    std::optional<Standing> atAPlace() {
        if (part_.file.places.empty())
            return {};
        const world::Place& place = part_.file.places[below(part_.file.places.size())];
        const world::SpaceIndex space =
            place.cell != 0 ? world::findCell(part_.world, place.cell) : locate(part_.world, place.eye).space;
        if (space == world::kNone || (space == kOutside && !isLand(place.eye)))
            return {};
        const Vec3 feet = place.eye - kUp * shape_.eyeHeight;
        const Vec3 to = shape_.capsule.middle(feet);
        return Standing{feet, sweep(part_.world, space, place.eye, to)};
    }
    std::optional<Standing> inACell() {
        const auto space = static_cast<world::SpaceIndex>(1 + below(part_.world.spaces.size() - 1));
        const world::Space& cell = part_.world.spaces[space];
        if (!(dat::blockOf(cell.cellId) == part_.centre) || cell.portalCount == 0)
            return {};
        const std::span<const Vec3> door =
            world::cornersOf(part_.world, part_.world.portals[cell.firstPortal + below(cell.portalCount)]);
        if (door.empty())
            return {};
        const Vec3 at = door[below(door.size())] + Vec3(random(-6, 6), random(-6, 6), random(-3, 3));
        // Where the hulls of two cells overlap, one of the two may have no floor.
        for (world::SpaceIndex s = 1; s < part_.world.spaces.size(); ++s)
            if (cellContains(part_.world, s, at) != (s == space))
                return {};
        return Standing{at - kUp * (0.5 * shape_.capsule.height), space};
    }
    std::optional<Standing> fromTheSky() {
        const Vec3 corner = Vec3(part_.centre.x, part_.centre.y, 0.0) * world::kBlockSize;
        const Vec3 at = corner + Vec3(random(0, world::kBlockSize), random(0, world::kBlockSize), 0.0);
        if (!isLand(at))
            return {};
        return Standing{{at.x, at.y, world::terrainHeight(part_.world, at.x, at.y) + 40.0}, kOutside};
    }

    /// Whether there is ground on all sides.
    [[nodiscard]] bool isLand(const Vec3& at) const {
        for (const Vec2& way : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec3 there = at + Vec3(way * kBorder, 0.0);
            const world::Block* block = world::findBlock(part_.world, world::blockAt(there));
            if (std::min(there.x, there.y) < 0.0 || block == nullptr || !block->hasTerrain)
                return false;
        }
        return true;
    }

    void choose() {
        input_.forward = random() < 0.85 ? 1.0 : std::floor(random(-1.0, 2.0));
        input_.right = random() < 0.2 ? std::floor(random(-1.0, 2.0)) : 0.0;
        input_.yaw = random() < 0.4 ? 360.0 * random() : input_.yaw;
        input_.run = random() < 0.5;
        input_.jump = random() < 0.15;
        const bool uses = random() < 0.2;
        if (body_.standing.space == kOutside && !isLand(body_.standing.feet)) {
            const Vec3 home =
                (Vec3(part_.centre.x, part_.centre.y, 0.0) + 0.5) * world::kBlockSize - body_.standing.feet;
            input_.yaw = glm::degrees(std::atan2(home.x, home.y));
            input_.forward = 1.0;
            input_.right = 0.0;
        }
        const BodyEye eye = eyeOf(body_, part_.world, shape_);
        const auto door =
            uses ? doorInReach(part_.world, eye.space, eye.position, turnedTo(input_.yaw) * Vec3(0, 1, 0))
                 : std::nullopt;
        if (door)
            use_.use(part_.world.doors[*door]);
    }

    void step() {
        use_.pass(kBodyFrame, part_.collisions, body_, shape_);
        use_.write(part_.world, doors_);
        body_ = moved(body_, input_, kBodyFrame, part_.collisions, doors_, shape_);
        input_.jump = false;
    }

    [[nodiscard]] std::string fault() const {
        const Standing& at = body_.standing;
        if (body_.recoveries != 0)
            return "fell out of the world";
        if (at.space == kOutside &&
            world::terrainHeight(part_.world, at.feet.x, at.feet.y) - at.feet.z > 0.35)
            return "is under the ground";
        if (const double depth = wayOut(at); depth > kMostDeep)
            return fmt::format("is {:.4f} m in a wall", depth);
        return isElsewhere() ? "is in another space than it says" : "";
    }

    [[nodiscard]] bool isElsewhere() const {
        constexpr double kAside = 0.001; // metres: in the plane between two spaces either is right
        const Vec3 at = middle(body_.standing);
        for (const Vec3& way : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                Vec3(0, 0, 1), Vec3(0, 0, -1)})
            if (mayBeAt(at + way * kAside))
                return false;
        return true;
    }
    /// A body on terrain that passes through a cell is outside, though the cell contains it: only openings
    /// lead in.
    [[nodiscard]] bool isCrossedByGround(world::SpaceIndex cell, const Vec3& at) const {
        constexpr double kAboveFloor = 0.5; // metres: floors of houses on the ground are no lower
        return world::terrainHeight(part_.world, at.x, at.y) >
               part_.world.spaces[cell].bounds.min.z + kAboveFloor;
    }
    [[nodiscard]] bool mayBeAt(const Vec3& at) const {
        const world::SpaceIndex space = body_.standing.space;
        if (space == kOutside) {
            const world::SpaceIndex cell = locate(part_.world, at).space;
            return cell == kOutside || isCrossedByGround(cell, at);
        }
        return part_.world.spaces[space].bspNodeCount == 0 || cellContains(part_.world, space, at);
    }

    /// The body cannot move in any direction, walking or jumping, though a slimmer body could.
    [[nodiscard]] bool isStuck() const {
        Capsule slim = shape_.capsule;
        slim.radius -= 0.02;
        slim.height -= 0.04;
        const Standing lifted{body_.standing.feet + kUp * 0.02, body_.standing.space};
        bool isRoom = false;
        for (int way = 0; way < 8; ++way) {
            const double yaw = 45.0 * way;
            const Vec3 to = lifted.feet + turnedTo(yaw) * Vec3(0.0, 0.3, 0.0);
            isRoom = isRoom || !part_.collisions.sweep(slim, lifted, to, doors_);
            BodyState tries = body_;
            for (int frame = 0; frame < 45; ++frame) {
                const BodyInput input{.forward = 1.0, .yaw = yaw, .run = true, .jump = frame == 0};
                tries = moved(tries, input, kBodyFrame, part_.collisions, doors_, shape_);
                if (glm::length(tries.standing.feet - body_.standing.feet) > kLeastWay + 1.0)
                    break;
            }
            if (glm::length(tries.standing.feet - body_.standing.feet) > kLeastWay)
                return false;
        }
        return isRoom;
    }

    const Part& part_;
    const BodyShape shape_;
    std::mt19937 random_;
    DoorUse use_;
    std::vector<double> doors_;
    BodyState body_;
    BodyInput input_;
};

std::uint32_t asked(const char* name, std::uint32_t otherwise) {
    const char* text = std::getenv(name);
    return text != nullptr ? static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

/// The selection of bodies to run.
struct Share {
    Share() {
        if (const char* text = std::getenv("LIMEN_TEST_SHARE")) {
            char* end = nullptr;
            which = static_cast<std::uint32_t>(std::strtoul(text, &end, 10));
            of = std::max<std::uint32_t>(static_cast<std::uint32_t>(std::strtoul(end + 1, nullptr, 10)), 1);
        }
    }
    std::uint32_t all = asked("LIMEN_TEST_BODIES", 48), which = 0, of = 1;
};

/// Lives that begin around one block; `number` identifies a life in every run.
void liveIn(const Part& part, const std::string& name, std::uint32_t first, std::uint32_t end,
            std::uint32_t by, std::uint32_t& lived) {
    const std::uint32_t only = asked("LIMEN_TEST_BODY", world::kNone);
    for (std::uint32_t number = first; number < end; number += by) {
        if (only != world::kNone && number != only)
            continue;
        Life life(part, number);
        if (!life.begin())
            continue;
        ++lived;
        const std::string wrong = life.live();
        const BodyState& body = life.body();
        const dat::RecordId cell = part.world.spaces[body.standing.space].cellId;
        EXPECT_EQ(wrong, "") << name << ", body " << number
                             << fmt::format(" at {:.3f} {:.3f} {:.3f} in {:08X}", body.standing.feet.x,
                                            body.standing.feet.y, body.standing.feet.z, cell);
    }
}

std::vector<dat::BlockCoord> blocksOfPlaces(const world::WorldFile& file) {
    std::vector<dat::BlockCoord> blocks;
    for (const world::Place& place : file.places) {
        const dat::BlockCoord block = place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
        if (std::find(blocks.begin(), blocks.end(), block) == blocks.end())
            blocks.push_back(block);
    }
    return blocks;
}

TEST(RandomBodies, stayInTheBuiltInWorld) {
    const Share share;
    const test::TempDir directory;
    ASSERT_TRUE(worlds::writeBuiltInWorld(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    const Result<world::WorldFile> file = world::loadWorldFile(directory.path());
    ASSERT_TRUE(archive && file);
    const std::vector<dat::BlockCoord> blocks = blocksOfPlaces(*file);
    const auto count = static_cast<std::uint32_t>(blocks.size());
    std::uint32_t lived = 0;
    for (std::uint32_t b = 0; b < count; ++b) {
        const Part part(*archive, blocks[b], *file);
        // Body n begins at block n % count; the share's are those of its rank there.
        liveIn(part, "built-in", b + count * share.which, share.all, count * share.of, lived);
    }
    RecordProperty("bodies", static_cast<int>(lived));
    EXPECT_GT(lived, 0u);
}

class RandomBodiesInGenerated : public ::testing::TestWithParam<GeneratedKind> {};
std::string pluralOf(const ::testing::TestParamInfo<GeneratedKind>& info) {
    constexpr const char* kNames[] = {"dungeons", "towns", "complexes", "terrains"};
    return kNames[static_cast<std::size_t>(info.param)];
}
INSTANTIATE_TEST_SUITE_P(Kinds, RandomBodiesInGenerated,
                         ::testing::Values(GeneratedKind::Dungeon, GeneratedKind::Town,
                                           GeneratedKind::Complex, GeneratedKind::Terrain),
                         pluralOf);

TEST_P(RandomBodiesInGenerated, stayInTheirWorlds) {
    constexpr std::uint32_t kBodiesEach = 8; // of a world
    const Share share;
    std::uint32_t lived = 0;
    for (std::uint32_t w = share.which; w * kBodiesEach < share.all; w += share.of) {
        const std::uint32_t sizes[] = {20 + w % 40, 4 + w % 7, 10 + w % 27, 3 + w % 6};
        const GeneratedWorld generated({GetParam(), sizes[static_cast<std::size_t>(GetParam())], w + 1});
        const std::vector<dat::BlockCoord> blocks = blocksOfPlaces(generated.file());
        ASSERT_FALSE(blocks.empty());
        const Part part(generated.archive(), blocks[w % blocks.size()], generated.file());
        liveIn(part, worlds::test::nameOf(generated.spec()), w * kBodiesEach,
               std::min((w + 1) * kBodiesEach, share.all), 1, lived);
    }
    RecordProperty("bodies", static_cast<int>(lived));
    EXPECT_GT(lived, 0u);
}

} // namespace
} // namespace limen::motion
