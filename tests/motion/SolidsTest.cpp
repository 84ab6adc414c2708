#include "world/Solids.h"

#include "motion/Walker.h"

namespace limen::world {
namespace {

using test::boxExterior;
using test::frameAt;
using test::TestWorld;

/// The solids of one kind in the home block.
std::vector<Solid> ofKind(const Solids& solids, InstanceKind kind) {
    std::vector<Solid> found;
    for (const Solid& solid : solids.solids)
        if (solid.kind == kind)
            found.push_back(solid);
    return found;
}

Aabb boundsOf(const Solids& solids, const Solid& solid) {
    Aabb box;
    for (std::uint32_t i = 3 * solid.firstTriangle; i < 3 * (solid.firstTriangle + solid.triangleCount); ++i)
        box.include(solids.corners[i]);
    return box;
}

Solids read(TestWorld& source, World& world) {
    const test::TempDir directory;
    EXPECT_TRUE(source.write(directory.path()));
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    Result<World> loaded = loadWorld(*archive, source.home(), {.radius = 1});
    EXPECT_TRUE(loaded);
    world = std::move(*loaded);
    Result<Solids> solids = loadSolids(*archive, world, source.home(), 1);
    EXPECT_TRUE(solids);
    return std::move(*solids);
}

TEST(Solids, cellsGroundAndExteriorsAreMetInTheirSpaces) {
    TestWorld source;
    const auto room = source.addBox({10, 10, 2}, {14, 14, 5});
    const auto door = source.openOutside(room, test::rectangle({10, 11, 2}, {10, 12, 4}));
    source.addBuilding(boxExterior({10, 10, 2}, {14, 14, 5.2}), {door});
    source.setFlatTerrain(source.home(), 1);
    World world;
    const Solids solids = read(source, world);
    const auto shells = ofKind(solids, InstanceKind::Shell), grounds = ofKind(solids, InstanceKind::Terrain),
               exteriors = ofKind(solids, InstanceKind::Exterior);
    ASSERT_EQ(shells.size(), 1u);
    EXPECT_EQ(solids.members[shells[0].firstMember], findCell(world, source.id(room)));
    EXPECT_NEAR(boundsOf(solids, shells[0]).max.z, 5.0, 1e-6);
    ASSERT_EQ(grounds.size(), 1u);
    EXPECT_EQ(solids.members[grounds[0].firstMember], kOutside);
    EXPECT_EQ(grounds[0].triangleCount, 64u * 64u * 2u);
    ASSERT_EQ(exteriors.size(), 1u);
    EXPECT_EQ(solids.members[exteriors[0].firstMember], kOutside);
    EXPECT_NEAR(boundsOf(solids, exteriors[0]).max.z, 5.2, 1e-6);
}

// Bodies walk on full meshes, at every distance: levels of detail are of the picture alone.
TEST(Solids, areThoseOfTheNearestLevelOfDetail) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    constexpr float kEndless = std::numeric_limits<float>::max();
    const std::uint32_t card = source.addModel({{test::rectangle({-9, 0, 0}, {9, 0, 9}), "leaf", true}});
    const std::uint32_t box = source.addModel(
        boxExterior({-1, -1, 0}, {1, 1, 3}),
        {{TestWorld::kItself, 1, 0, 0, 10}, {card, 5, 0, 0, 20}, {0, 1, kEndless, kEndless, kEndless}});
    dat::Setup setup;
    setup.parts = {box};
    setup.flags |= dat::Setup::kPhysicsBsp;
    source.addObject(source.addSetup(setup), frameAt({50, 50, 2}));
    source.addObject(box, frameAt({60, 50, 2}));
    World world;
    const Solids solids = read(source, world);
    const auto objects = ofKind(solids, InstanceKind::Static);
    ASSERT_EQ(objects.size(), 2u);
    for (const Solid& solid : objects)
        EXPECT_EQ(boundsOf(solids, solid).max - boundsOf(solids, solid).min, Vec3(2, 2, 3));
}

TEST(Solids, groundLiesOnTheTrianglesThatAreDrawn) {
    TestWorld source;
    dat::LandBlock& land = source.terrain(source.home());
    for (std::size_t i = 0; i < land.heights.size(); ++i)
        land.heights[i] = static_cast<std::uint8_t>((i * 37) % 11);
    World world;
    const Solids solids = read(source, world);
    const Solid ground = ofKind(solids, InstanceKind::Terrain).at(0);
    for (std::uint32_t i = 3 * ground.firstTriangle; i < 3 * (ground.firstTriangle + ground.triangleCount);
         i += 3) {
        const Vec3 middle =
            (solids.corners[i] + solids.corners[i + 1] + solids.corners[i + 2]) / 3.0 + solids.origin;
        ASSERT_NEAR(terrainHeight(world, middle.x, middle.y), middle.z, 1e-6) << i / 3;
    }
}

TEST(Solids, setupsAreTheirPartsOrCylindersOrSpheres) {
    TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    const std::uint32_t box = source.addModel(boxExterior({-1, -1, 0}, {1, 1, 2}));
    dat::Setup parts, cylinder, sphere, none;
    parts.flags = dat::Setup::kPhysicsBsp;
    for (dat::Setup* setup : {&parts, &cylinder, &sphere, &none})
        setup->parts = {box};
    cylinder.cylSpheres = {{{0, 0, 0.5f}, 0.4f, 3.0f}};
    sphere.spheres = {{{0, 0, 1.0f}, 0.7f}};
    const std::array heights{4.0, 5.5, 3.7};
    const std::array widths{2.0, 0.8, 1.4};
    double x = 20;
    for (dat::Setup* setup : {&parts, &cylinder, &sphere, &none}) {
        source.addObject(source.addSetup(*setup), frameAt({x, 30, 2}));
        x += 10;
    }
    World world;
    const Solids solids = read(source, world);
    const auto statics = ofKind(solids, InstanceKind::Static);
    ASSERT_EQ(statics.size(), 3u) << "the last has no shape";
    for (std::size_t i = 0; i < 3; ++i) {
        const Aabb bounds = boundsOf(solids, statics[i]);
        EXPECT_NEAR(bounds.max.z, heights[i], 1e-5) << i;
        EXPECT_NEAR(bounds.max.x - bounds.min.x, widths[i], 1e-5) << i;
        EXPECT_NEAR(bounds.centre().x, 20.0 + 10.0 * static_cast<double>(i), 1e-5) << i;
    }
}

} // namespace
} // namespace limen::world
