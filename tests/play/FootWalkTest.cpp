#include "play/FootWalk.h"

#include "gpu/device/NullDevice.h"
#include "play/PathWalk.h"
#include "support/TemporaryDirectory.h"
#include "worlds/Generated.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::play {
namespace {

/// The walk along the tour that the records of a generated town give. Its doors are in world.json.
FootWalk walkThroughTown(std::uint32_t seed, bool withDoors, bool furnished = false) {
    const test::TemporaryDirectory directory;
    worlds::GeneratedSpec spec{worlds::GeneratedKind::Town, 8, seed};
    spec.furnished = furnished;
    EXPECT_TRUE(worlds::writeGeneratedWorld(spec, directory.path()));
    if (!withDoors)
        std::filesystem::remove(directory / "world.json");
    Result<engine::WorldSource> source = engine::openWorldSource(directory.path().string());
    const std::vector<world::Place> tour = engine::tourOf(*source).value();
    std::vector<engine::ViewRequest> points;
    for (const world::Place& place : tour)
        points.push_back(engine::requestAt(place));
    gpu::NullDevice device;
    const engine::SessionOptions options;
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), options, device);
    PathRequest request;
    request.size = {64, 36};
    request.frames = 1;
    const Result<PathStart> start = startPath(session, points, request);
    EXPECT_TRUE(start);
    return walkOnFoot(session, start->frame, points, {}).value();
}

void expectReachesAll(const FootWalk& walk) {
    EXPECT_THAT(walk.missed, testing::IsEmpty());
    EXPECT_THAT(walk.jumps, testing::IsEmpty());
    EXPECT_GT(walk.record.frames.size(), 1000u);
}

// Sills under low lintels, leaves that are shut, ajar and open, and rooms hardly deeper than a leaf (13).
TEST(FootWalk, reachesEveryWayPointOfATownsTour) {
    for (const std::uint32_t seed : {1u, 3u, 7u, 11u, 13u, 16u, 19u, 42u}) {
        SCOPED_TRACE(seed);
        expectReachesAll(walkThroughTown(seed, true));
    }
}

// Tables, chairs, candlesticks and narrow gaps between shelves stand on the straight ways.
TEST(FootWalk, goesAroundFurniture) {
    for (const std::uint32_t seed : {2u, 3u}) {
        SCOPED_TRACE(seed);
        expectReachesAll(walkThroughTown(seed, true, true));
    }
}

TEST(FootWalk, reachesEveryWayPointOfATownWithoutDoors) {
    expectReachesAll(walkThroughTown(3, false));
}

} // namespace
} // namespace limen::play
