#include "output/Probe.h"
#include "support/SmallWorld.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace limen::output {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kCell = "0xA9B40105";

// A cell, and the outside seen through its opening.
struct Probed {
    world::World world = test::smallWorld();
    visibility::VisibleSet visible = test::twoVisits();
    frame::FramePlan plan;
    engine::FrameRequest eye;
    Probe probe;
    std::uint64_t frame = 0;

    Probed() {
        world.blocks.resize(1);
        world.blocks[0].coord = {0xA9, 0xB4};
        eye.root = 1;
        eye.camera.eye = {1, 2, 3};
        plan.stages = {{frame::StageKind::Ownership, 0, 1}, {frame::StageKind::Solid, 1, 4}};
        plan.counts.instancesDrawn = 17;
    }

    /// By event.
    std::map<std::string, json> see() {
        const std::string text = probe.see({frame++, 0.5, world, eye, visible, plan, 39});
        std::map<std::string, json> events;
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            json event = json::parse(line);
            const std::string name = event["event"];
            EXPECT_TRUE(events.emplace(name, std::move(event)).second) << line;
        }
        return events;
    }
    static std::vector<std::string> namesOf(const std::map<std::string, json>& events) {
        std::vector<std::string> names;
        for (const auto& [name, event] : events)
            names.push_back(name);
        return names;
    }
};

TEST(Probe, theFirstFrameTellsAllThatIsDecided) {
    Probed f;
    const auto events = f.see();
    EXPECT_THAT(Probed::namesOf(events),
                ElementsAre("loaded", "outside", "root", "seen", "stages", "visits"));
    EXPECT_EQ(events.at("root")["root"], kCell);
    EXPECT_TRUE(events.at("root")["was"].is_null());
    EXPECT_EQ(events.at("visits")["came"], json({kCell, kCell + " -2-> outside"}));
    EXPECT_EQ(events.at("seen")["came"], json({kCell, "outside"}));
    EXPECT_EQ(events.at("outside")["seen"], true);
    EXPECT_EQ(events.at("stages")["stages"], "ownership 1, solid 4");
    EXPECT_EQ(events.at("loaded")["blocks"], "1 blocks from 0xA9B4FFFF to 0xA9B4FFFF");
    for (const auto& [name, event] : events) {
        EXPECT_EQ(event["frame"], 0);
        EXPECT_EQ(event["seconds"], 0.5);
        EXPECT_EQ(event["drawn"], 17);
        EXPECT_EQ(event["gl_calls"], 39);
        EXPECT_EQ(event["cells"], 2);
    }
}

TEST(Probe, aChangeOfTheGateOrOfItsSpacesIsOneLine) {
    Probed f;
    EXPECT_FALSE(f.see().contains("vis")) << "ownership alone has no such line";
    f.plan.gate = frame::Gate::Planes;
    f.plan.spaces = {{0, 2, 8, 1}, {1, 1, 0, 0}};
    const auto events = f.see();
    EXPECT_THAT(Probed::namesOf(events), ElementsAre("vis"));
    const json& vis = events.at("vis");
    EXPECT_EQ(vis["gate"], "planes");
    EXPECT_EQ(vis["root"], kCell);
    EXPECT_EQ(vis["outside_regions"], 2);
    EXPECT_EQ(vis["spaces"][0],
              (json{{"space", "outside"}, {"regions", 2}, {"planes", 8}, {"fallbacks", 1}}));
    EXPECT_EQ(vis["spaces"][1]["space"], kCell);
    EXPECT_THAT(f.see(), IsEmpty());
    f.plan.spaces[0].planes = 7;
    EXPECT_THAT(Probed::namesOf(f.see()), ElementsAre("vis"));
    f.plan.gate = frame::Gate::Ownership;
    f.plan.spaces.clear();
    EXPECT_EQ(f.see().at("vis")["gate"], "ownership");
    EXPECT_THAT(f.see(), IsEmpty());
}

TEST(Probe, aFrameLikeTheOneBeforeTellsNothing) {
    Probed f;
    f.see();
    f.eye.camera.eye.x += 1; // the decisions stay the same
    f.plan.counts.instancesDrawn = 5;
    EXPECT_THAT(f.see(), IsEmpty());
}

TEST(Probe, tellsTheWayThatLedToAnotherRoot) {
    Probed f;
    f.see();
    f.eye.root = world::kOutside;
    f.eye.camera.eye = {1, 5, 3};
    const auto events = f.see();
    EXPECT_THAT(Probed::namesOf(events), ElementsAre("root"));
    EXPECT_EQ(events.at("root")["was"], kCell);
    EXPECT_EQ(events.at("root")["root"], "outside");
    EXPECT_EQ(events.at("root")["from"], json({1.0, 2.0, 3.0}));
    EXPECT_EQ(events.at("root")["to"], json({1.0, 5.0, 3.0}));
}

TEST(Probe, tellsWhatCameAndWhatWent) {
    Probed f;
    f.see();
    const visibility::VisibleSet both = f.visible;
    f.visible.visits.pop_back();
    f.visible.seen = {{1, 0, {}}};
    f.plan.stages[0].batchCount = 0;
    auto events = f.see();
    EXPECT_THAT(Probed::namesOf(events), ElementsAre("outside", "seen", "stages", "visits"));
    EXPECT_EQ(events.at("visits")["came"], json::array());
    EXPECT_EQ(events.at("visits")["went"], json({kCell + " -2-> outside"}));
    EXPECT_EQ(events.at("seen")["went"], json({"outside"}));
    EXPECT_EQ(events.at("outside")["seen"], false);
    f.visible = both;
    events = f.see();
    EXPECT_EQ(events.at("visits")["came"], json({kCell + " -2-> outside"}));
    EXPECT_EQ(events.at("outside")["seen"], true);
    EXPECT_FALSE(events.contains("stages"));
}

TEST(Probe, aShutOpeningAndOneThatLeadsNowhereAreTold) {
    Probed f;
    f.see();
    f.visible.visits[1].hole = true;
    f.visible.visits[1].space = world::kNone;
    EXPECT_EQ(f.see().at("visits")["came"], json({kCell + " -2-> nowhere"}));
    f.visible.visits[1].shut = true;
    EXPECT_EQ(f.see().at("visits")["came"], json({kCell + " -2-> shut"}));
}

TEST(Probe, visitsAndSpacesHaveTheirNamesWhateverPartOfTheWorldIsLoaded) {
    Probed f;
    f.see();
    world::World& world = f.world; // one more space and one more portal at the front
    world.spaces.insert(world.spaces.begin() + 1, world::Space());
    world.portals.insert(world.portals.begin(), world::Portal());
    world.portals[2].space = 2;
    world.blocks.resize(2);
    world.blocks[1].coord = {0xA9, 0xB5};
    f.eye.root = 2;
    f.visible.visits[0].space = 2;
    f.visible.visits[1].portal = 2;
    f.visible.seen = {{2, 0, {}}, {0, 1, {}}, {2, 1, {}}};
    const auto events = f.see();
    EXPECT_THAT(Probed::namesOf(events), ElementsAre("loaded"));
    EXPECT_EQ(events.at("loaded")["blocks"], "2 blocks from 0xA9B4FFFF to 0xA9B5FFFF");
}

TEST(Probe, aBudgetThatIsReachedIsTold) {
    Probed f;
    f.see();
    f.visible.counts.visitsCut = 3;
    EXPECT_EQ(f.see().at("budget")["visits_cut"], 3);
    EXPECT_THAT(f.see(), IsEmpty());
    f.visible.counts.visitsCut = 0;
    EXPECT_EQ(f.see().at("budget")["visits_cut"], 0);
}

TEST(Probe, theCamerasWayFromTheBodyIsToldWhenItChanges) {
    Probed f;
    f.eye.scene.body = motion::PlayerBody{{1, 2, 1}, 0.0, 1};
    EXPECT_EQ(f.see()["camera"]["held"], false);
    EXPECT_THAT(Probed::namesOf(f.see()), IsEmpty());
    f.eye.isHeld = true;
    const auto held = f.see();
    EXPECT_THAT(Probed::namesOf(held), ElementsAre("camera"));
    EXPECT_EQ(held.at("camera")["held"], true);
    f.eye.scene.body->space = world::kOutside; // the eye stays behind
    auto behind = f.see();
    EXPECT_THAT(Probed::namesOf(behind), ElementsAre("camera"));
    EXPECT_EQ(behind["camera"]["body"], "outside");
    EXPECT_EQ(behind["camera"]["eye"], "0xA9B40105");
    f.eye.scene.body.reset();
    f.eye.isHeld = false;
    EXPECT_TRUE(f.see()["camera"]["body"].is_null());
}

} // namespace
} // namespace limen::output
