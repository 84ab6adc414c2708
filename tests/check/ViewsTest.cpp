#include "check/views/Views.h"

#include "check/House.h"
#include "check/Report.h"
#include "cli/Parse.h"
#include "cli/ShotRequest.h"
#include "motion/Locate.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <set>

namespace limen::check {
namespace {

using test::House;

std::vector<View> allViews(const Surroundings& around) {
    std::vector<View> views;
    addRandomViews(around, ViewKind::Random, 20, views);
    addOutsideViews(around, 20, views);
    addTourViews(around, 30, views);
    addWalkViews(around, 120, views);
    addSweepViews(around, 200, views);
    addStraddleViews(around, 40, views);
    addLensViews(around, ViewKind::Telephoto, 20, views);
    addLensViews(around, ViewKind::Wide, 20, views);
    return views;
}

TEST(Views, followFromTheSeedAlone) {
    const House house;
    const std::vector<View> a = allViews(house.around(5)), b = allViews(house.around(5)),
                            c = allViews(house.around(6));
    ASSERT_EQ(a.size(), b.size());
    ASSERT_GT(a.size(), 300u);
    std::size_t others = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(shotOptions(a[i]), shotOptions(b[i]));
        others += i < c.size() && shotOptions(a[i]) != shotOptions(c[i]) ? 1 : 0;
    }
    EXPECT_GT(others, a.size() / 2) << "another seed gives others";
}

TEST(Views, allLoadTheBlockTheyBelongTo) {
    const House house;
    for (const View& view : allViews(house.around()))
        EXPECT_EQ(centreOf(view), house.source.home()) << view.about;
}

TEST(Views, randomOnesLieInEveryCell) {
    const House house;
    std::vector<View> views;
    addRandomViews(house.around(), ViewKind::Random, 20, views);
    ASSERT_EQ(views.size(), 20u);
    std::set<dat::RecordId> cells;
    for (const View& view : views) {
        cells.insert(view.root);
        EXPECT_TRUE(motion::cellContains(house.world, world::findCell(house.world, view.root), view.eye));
    }
    EXPECT_EQ(cells.size(), 2u);
}

TEST(Views, straddlingOnesAreAtOpeningsOnBothSides) {
    const House house;
    std::vector<View> views;
    addStraddleViews(house.around(), 400, views);
    ASSERT_GT(views.size(), 380u);
    std::size_t before = 0, past = 0, close = 0;
    for (const View& view : views) {
        const world::SpaceIndex root =
            view.root == 0 ? world::kOutside : world::findCell(house.world, view.root);
        double off = 1.0;
        const world::Space& space = house.world.spaces[root];
        for (std::uint32_t p = space.firstPortal; p < space.firstPortal + space.portalCount; ++p) {
            const double side = house.world.portals[p].plane.signedDistance(view.eye);
            off = std::abs(side) < std::abs(off) ? side : off;
        }
        EXPECT_LE(std::abs(off), 0.0100001) << view.about;
        EXPECT_GE(off, -kInPlaneTolerance - 1e-9) << view.about;
        before += off > 0.0 ? 1 : 0;
        past += off < 0.0 ? 1 : 0;
        close += std::abs(off) < 1e-5 ? 1 : 0;
    }
    EXPECT_GT(before, 200u);
    EXPECT_GT(past, 50u);
    EXPECT_GT(close, 50u);
}

TEST(Views, lensesAreLongOrWide) {
    const House house;
    std::vector<View> views;
    addLensViews(house.around(), ViewKind::Telephoto, 10, views);
    addLensViews(house.around(), ViewKind::Wide, 10, views);
    ASSERT_EQ(views.size(), 20u);
    for (const View& view : views)
        EXPECT_TRUE(view.kind == ViewKind::Wide ? view.fov >= 150.0 && view.fov <= 170.0
                                                : view.fov >= 2.0 && view.fov <= 10.0);
}

TEST(Views, randomOnesAreFoundInACellWithoutATree) {
    limen::test::TestWorld source;
    limen::test::TestWorld::CellOptions bare;
    bare.bsp = false;
    const auto a = source.addBox({10, 10, 10}, {14, 14, 13}, "red", bare);
    const auto b = source.addBox({14, 10, 10}, {18, 14, 13}, "blue", bare);
    source.link(a, limen::test::rectangle({14, 11, 10}, {14, 12, 12}), b);
    const world::World world = limen::test::loadTestWorld(source);
    const reference::Scene scene(world);
    std::vector<View> views;
    addRandomViews({world, scene, source.home()}, ViewKind::Random, 10, views);
    EXPECT_GE(views.size(), 8u);
    for (const View& view : views)
        EXPECT_TRUE(world.spaces[world::findCell(world, view.root)].bounds.contains(view.eye));
}

TEST(Viewpoints, randomOnesKeepClearOfWallsAndOpenings) {
    limen::test::TestWorld source;
    const auto flat = source.addBox({0, 0, 0}, {4, 4, 0.006}, "brown");
    const world::World world = limen::test::loadTestWorld(source);
    const reference::Scene scene(world);
    const Surroundings around{world, scene, source.home(), 1, 32, 18, {}};
    const world::SpaceIndex cell = world::findCell(world, source.id(flat));
    for (std::uint64_t i = 0; i < 50; ++i) {
        RandomGenerator random(1, {i});
        const auto eye = viewpointInCell(around, cell, random);
        ASSERT_TRUE(eye.has_value());
        EXPECT_GE(eye->z, 0.0017);
        EXPECT_LE(eye->z, 0.0043);
    }
}

TEST(Views, outsideOnesStandInTheOpen) {
    const House house;
    std::vector<View> views;
    addOutsideViews(house.around(), 60, views);
    ASSERT_GT(views.size(), 50u);
    for (const View& view : views) {
        EXPECT_EQ(view.root, 0u);
        EXPECT_EQ(motion::locate(house.world, view.eye).space, world::kOutside);
        const double height = view.eye.z - world::terrainHeight(house.world, view.eye.x, view.eye.y);
        EXPECT_TRUE(height > 0.29 && height < 20.01) << height;
    }
}

TEST(Viewpoints, anEyeInsideASolidIsNotFree) {
    House house;
    const auto box = house.source.addModel(limen::test::boxExterior({-1, -1, -1}, {1, 1, 1}));
    house.source.addObject(box, limen::test::frameAt({110, 90, 12}));
    const world::World world = limen::test::loadTestWorld(house.source);
    const reference::Scene scene(world);
    const Surroundings around{world, scene, house.source.home()};
    RandomGenerator random(1, {});
    EXPECT_FALSE(isFreeViewpoint(around, world::kOutside, house.at({110.2, 90.1, 12.3}), random))
        << "in the box";
    EXPECT_TRUE(isFreeViewpoint(around, world::kOutside, house.at({113, 90, 12}), random));
    EXPECT_FALSE(isFreeViewpoint(around, world::kOutside, house.at({93, 83, 11}), random))
        << "in the house, said outside";
    EXPECT_TRUE(isFreeViewpoint(around, house.space(house.front), house.at({93, 83, 11}), random));
}

TEST(Viewpoints, aWalkEndsAtAWallAndGoesThroughADoor) {
    const House house;
    const Surroundings around = house.around();
    const world::SpaceIndex front = house.space(house.front);
    EXPECT_EQ(walk(around, front, house.at({93, 82.5, 11}), house.at({98, 82.5, 11})),
              house.space(house.rear));
    EXPECT_EQ(walk(around, front, house.at({93, 82.5, 11}), house.at({94, 82.5, 11})), front);
    EXPECT_EQ(walk(around, front, house.at({93, 84.5, 11}), house.at({98, 84.5, 11})), std::nullopt);
    EXPECT_EQ(walk(around, world::kOutside, house.at({92.5, 90, 11}), house.at({92.5, 84, 11})), front);
}

TEST(Views, theTourGoesThroughBothDoors) {
    const House house;
    std::vector<View> views;
    addTourViews(house.around(), 40, views);
    ASSERT_EQ(views.size(), 40u);
    EXPECT_EQ(views.front().root, 0u);
    EXPECT_EQ(views.back().root, house.source.id(house.rear));
    std::set<dat::RecordId> roots;
    for (const View& view : views)
        roots.insert(view.root);
    EXPECT_EQ(roots.size(), 3u);
}

TEST(Views, walksTakeStepsOfACentimetreAndChangeRooms) {
    const House house;
    std::vector<View> views;
    addWalkViews(house.around(), 400, views);
    ASSERT_GT(views.size(), 300u);
    std::size_t steps = 0, changes = 0;
    for (std::size_t i = 1; i < views.size(); ++i) {
        const double length = glm::length(views[i].eye - views[i - 1].eye);
        if (length > 0.0101)
            continue; // another walk
        ++steps;
        changes += views[i].root != views[i - 1].root ? 1 : 0;
    }
    EXPECT_GT(steps, 250u);
    EXPECT_GE(changes, 2u);
}

TEST(Views, sweepsComeCloseFromBothSidesAndTouchThePlane) {
    const House house;
    std::vector<View> views;
    addSweepViews(house.around(), 4000, views);
    ASSERT_GT(views.size(), 3500u);
    std::set<dat::RecordId> roots;
    std::size_t inPlane = 0, tiny = 0, nearer = 0, far = 0;
    for (const View& view : views) {
        roots.insert(view.root);
        const double door = std::abs(view.eye.x - house.at({96, 0, 0}).x);
        inPlane += door == 0.0 ? 1 : 0;
        tiny += door > 0.0 && door < 0.0003 ? 1 : 0;
        nearer += door >= 0.0003 && door < 0.0201 ? 1 : 0;
        far += door > 0.1 && door < 0.31 ? 1 : 0;
    }
    EXPECT_EQ(roots.size(), 3u);
    EXPECT_GT(inPlane, 5u);
    EXPECT_GT(tiny, 50u);
    EXPECT_GT(nearer, 300u);
    EXPECT_GT(far, 200u);
}

/// Calls `see` with the request that `limen shot` reads from a command.
void readAsShot(const std::string& command, const std::function<void(const engine::ViewRequest&)>& see) {
    const auto words = cli::splitArguments(command);
    ASSERT_TRUE(words);
    ASSERT_EQ((*words)[0], "limen");
    ASSERT_EQ((*words)[1], "shot");
    CLI::App program;
    cli::ViewArguments arguments;
    cli::OutputPaths outputs;
    cli::addViewOptions(program, arguments);
    cli::addOutputOptions(program, outputs);
    std::vector<std::string> rest(words->rbegin(), words->rend() - 2); // CLI11 expects reversed order
    program.parse(rest);
    EXPECT_EQ(outputs.ids, "ids.npy");
    const auto request = cli::checkView(arguments);
    ASSERT_TRUE(request) << request.error().message();
    see(*request);
}

TEST(Views, theReproducingCommandGivesTheSameViewToTheBit) {
    const House house;
    for (const View& view : allViews(house.around())) {
        readAsShot(shotCommand(view, ""), [&](const engine::ViewRequest& request) {
            ASSERT_TRUE(request.place.empty() && request.yaw && request.pitch && request.root);
            EXPECT_EQ(request.eye, view.eye);
            EXPECT_EQ(*request.yaw, view.yaw);
            EXPECT_EQ(*request.pitch, view.pitch);
            EXPECT_EQ(request.fov, view.fov);
            EXPECT_EQ(request.size.width, view.width);
            EXPECT_EQ(request.size.height, view.height);
            EXPECT_EQ(request.root->rule == engine::RootChoice::Rule::Cell ? request.root->cell : 0,
                      view.root);
        });
    }
}

} // namespace
} // namespace limen::check
