// A fast frame from outside that is drawn root first is the frame that tests every fragment (decision 216).
#include "picture/CaseHelp.h"
#include "support/PlacedHut.h"
#include "worlds/GeneratedWorlds.h"

#include <random>

namespace limen::test {
namespace {

/// One world, drawn both ways.
struct BothWays {
    BothWays(const std::filesystem::path& directory, dat::BlockCoord centre, bool mergeZones)
        : tested(directory, centre, options(false, mergeZones)),
          cleared(directory, centre, options(true, mergeZones)) {}
    BothWays(TestWorld& world, const PictureOptions& of)
        : tested(world, with(of, false)), cleared(world, with(of, true)) {}

    static PictureOptions with(PictureOptions options, bool rootFirst) {
        options.drawing = gpu::Drawing::Fast;
        options.rootFirst = rootFirst;
        return options;
    }
    static PictureOptions options(bool rootFirst, bool mergeZones) {
        return with({.mergeZones = mergeZones}, rootFirst);
    }

    /// Expects the same picture both ways. True if openings were cleared.
    bool compare(const frame::FrameView& frame, const gpu::RenderOptions& options) {
        const Picture before = tested.shoot(frame, options), after = cleared.shoot(frame, options);
        EXPECT_FALSE(before.isCleared);
        std::size_t ids = 0, colours = 0;
        for (std::size_t i = 0; i < before.ids.size(); ++i) {
            ids += options.wantIds && before.ids[i] != after.ids[i] ? 1 : 0;
            colours +=
                std::equal(&before.colour[4 * i], &before.colour[4 * i] + 4, &after.colour[4 * i]) ? 0 : 1;
        }
        EXPECT_EQ(ids, 0u);
        EXPECT_EQ(colours, 0u);
        EXPECT_LE(after.glCalls, 40u);
        pixels += before.ids.size();
        return after.isCleared;
    }

    PictureWorld tested, cleared;
    std::size_t pixels = 0;
};

/// From close to the ground beside an instance to high above it.
frame::FrameView viewFromOutside(const PictureWorld& pictures, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto& instances = pictures.world().instances;
    const world::Instance& near = instances[random() % instances.size()];
    const double closeness = unit(random);
    const double away = near.bounds.radius + 20.0 * closeness * unit(random);
    const double angle = 2.0 * M_PI * unit(random);
    const double rise = 0.6 * unit(random) - 0.1;
    const double yaw = 90.0 - glm::degrees(angle) + 180.0 + 40.0 * (unit(random) - 0.5);
    const Vec3 eye = near.bounds.centre + away * Vec3(std::cos(angle), std::sin(angle), rise);
    return pictures.look(eye - pictures.homeOrigin(), yaw, -20.0 * unit(random), world::kOutside);
}

TEST(RootFirst, isTheSamePicture_inGeneratedTowns) {
    std::size_t cleared = 0, views = 0;
    bool areCleared = false; // without a card
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const worlds::test::GeneratedWorld files({worlds::GeneratedKind::Town, 40, seed});
        BothWays both(files.directory(), files.blocks()[files.blocks().size() / 2], seed % 2 == 0);
        for (PictureWorld* pictures : {&both.tested, &both.cleared}) {
            pictures->width = 160;
            pictures->height = 90;
        }
        areCleared = both.cleared.drawsOnProcessor();
        std::mt19937 random(seed);
        for (int i = 0; i < 24; ++i, ++views) {
            const frame::FrameView frame = viewFromOutside(both.tested, random);
            SCOPED_TRACE(::testing::Message() << "seed " << seed << ", view " << i);
            cleared += both.compare(frame, {.wantIds = i % 2 == 0}) ? 1 : 0;
        }
    }
    if (areCleared)
        EXPECT_GT(cleared, views / 4) << "of " << views;
}

struct RootFirstDoors : ZoneCases {};
LIMEN_BOTH_ZONINGS(RootFirstDoors);

TEST_P(RootFirstDoors, areTheSamePicture_shutAndOpen) {
    PlacedHut placed;
    dat::Setup door; // with a side in its plane
    door.parts = {placed.hut.source.addModel(boxExterior({0, 0, 0}, {0.04, 1, 2}, "wood"))};
    placed.setup = placed.hut.source.addSetup(door);
    placed.placeDoors();
    // Exteriors in the doorway: one reaches from before it into the room, one has a side in the plane of the door.
    for (const auto& [low, high] :
         {std::pair(Vec3(9.6, 11.2, 2.0), Vec3(11.5, 11.4, 3.2)), {{10.0, 11.6, 2.2}, {10.4, 11.9, 3.0}}})
        static_cast<void>(placed.hut.source.addBuilding(boxExterior(low, high, "red"), {}));
    BothWays both(placed.hut.source, options(placed.hut.moving));
    std::size_t cleared = 0;
    for (const double doors : {0.0, 0.004, 0.35, 1.0}) {
        for (const auto& [eye, yaw] :
             {std::pair(Vec3(2.5, 11.4, 3.4), 90.0), {{4.4, 11.9, 3.6}, 80.0}, {{3.0, 3.2, 4.4}, 40.0}}) {
            SCOPED_TRACE(::testing::Message() << "doors " << doors << ", eye " << eye.x << " " << eye.y);
            const frame::FrameView frame = both.tested.look(eye, yaw, -4, world::kOutside);
            both.tested.setDynamics(dynamicsFor(frame, 1.0, doors));
            both.cleared.setDynamics(dynamicsFor(frame, 1.0, doors));
            for (const gpu::Shading shading : {gpu::Shading::Lit, gpu::Shading::FlatIds})
                cleared += both.compare(frame, {.shading = shading}) ? 1 : 0;
        }
    }
    if (both.cleared.drawsOnProcessor())
        EXPECT_GT(cleared, 0u);
}

} // namespace
} // namespace limen::test
