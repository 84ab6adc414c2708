#include "engine/report/FrameReport.h"

#include "engine/CheckView.h"
#include "engine/report/IdTable.h"
#include "output/FrameJson.h"
#include "output/RegionOverlay.h"
#include "support/SmallWorld.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace limen::engine {
namespace {

using test::smallWorld;
using test::twoVisits;

nlohmann::ordered_json reportOf(std::span<const std::uint32_t> ids) {
    const world::World world = smallWorld();
    const IdTable table(world);
    FrameRequest request;
    request.camera.eye = {1, 2, 3};
    request.root = 1;
    FrameFigures figures;
    figures.driver = "a driver";
    figures.stages = {{"solid", 3, 0.5, std::numeric_limits<double>::quiet_NaN()}};
    return output::frameJson(world, table, request, {}, twoVisits(), {}, figures, ids);
}

TEST(IdTable, tellsEveryIdApart) {
    const world::World world = smallWorld();
    const IdTable table(world);
    EXPECT_EQ(table.meaning(0), (IdMeaning{"none", "void", "0x00000000", "", 0}));
    EXPECT_EQ(table.meaning(1), (IdMeaning{"outside", "sky", "0x00000000", "", 0}));
    EXPECT_EQ(table.meaning(3), (IdMeaning{"outside", "terrain", "0xA9B4FFFF", "0000000000000033", 1}));
    EXPECT_EQ(table.meaning(6), (IdMeaning{"0xA9B40105", "shell", "0xA9B40105", "0000000000001122", 30}));
    EXPECT_EQ(table.meaning(7).kind, "unknown");
    EXPECT_EQ(table.meaning(0xFFFFFFFF).kind, "unknown");
}

TEST(IdTable, particlesHaveIdsInTheDynamicStateOnly) {
    const world::World world = smallWorld();
    const IdTable table(world);
    world::DynamicState dynamics;
    world::Instance particle = world.instances.back();
    particle.idBase = 1000;
    particle.kind = world::InstanceKind::Dynamic;
    dynamics.instances.push_back(particle);
    ASSERT_EQ(table.meaning(1000).kind, "unknown");
    EXPECT_EQ(table.meaning(1000, dynamics).kind, "dynamic");
    EXPECT_EQ(table.meaning(1000, dynamics).record, dat::idText(particle.record));
    const std::uint32_t polygons = world.meshes[particle.mesh].polygonCount;
    EXPECT_EQ(table.meaning(1000 + polygons, dynamics).kind, "unknown");
}

TEST(FrameReport, hasTheAgreedShape) {
    const std::vector<std::uint32_t> ids{0, 1, 4, 4, 2, 0};
    const auto json = reportOf(ids);
    EXPECT_EQ(json["root"], "0xA9B40105");
    EXPECT_EQ(json["eye"], (nlohmann::ordered_json{1.0, 2.0, 3.0}));
    EXPECT_EQ(json["cells"], (nlohmann::ordered_json::array({"0xA9B40105"})));
    EXPECT_EQ(json["void_pixels"], 2);
    ASSERT_EQ(json["ids"].size(), 4u);
    EXPECT_EQ(json["ids"]["0"]["space"], "none");
    EXPECT_EQ(json["ids"]["4"]["kind"], "shell");
    EXPECT_EQ(json["ids"]["4"]["polygon"], 10);
    ASSERT_EQ(json["visits"].size(), 2u);
    EXPECT_EQ(json["visits"][0]["parent"], -1);
    EXPECT_TRUE(json["visits"][0]["portal"].is_null());
    EXPECT_EQ(json["visits"][0]["region"].size(), 4u);
    EXPECT_EQ(json["visits"][1]["parent"], 0);
    EXPECT_EQ(json["visits"][1]["portal"]["space"], "0xA9B40105");
    EXPECT_EQ(json["visits"][1]["portal"]["index"], 2);
    // The corner at the eye (w = 0) is left out; the others are divided by w.
    EXPECT_EQ(json["visits"][1]["region"],
              (nlohmann::ordered_json::array({{0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}})));
    EXPECT_EQ(json["stages"][0]["name"], "solid");
    EXPECT_EQ(json["stages"][0]["draws"], 3);
    EXPECT_TRUE(json["stages"][0]["gpu_ms"].is_null());
    EXPECT_EQ(json["driver"], "a driver");
}

TEST(FrameReport, readsBackAsJson) {
    const std::vector<std::uint32_t> ids{1};
    EXPECT_EQ(nlohmann::ordered_json::parse(reportOf(ids).dump()).dump(), reportOf(ids).dump());
}

TEST(FrameReport, withoutAnIdImageItSaysNothingOfIds) {
    EXPECT_FALSE(reportOf({}).contains("ids"));
    EXPECT_FALSE(reportOf({}).contains("void_pixels"));
}

TEST(FrameReport, reproductionNamesTheRoot) {
    FrameRequest request;
    request.camera.eye = {-1.25, 2, 0.1};
    request.camera.heading = {30, -5};
    request.root = 1;
    request.scene.player = request.camera.eye;
    EXPECT_EQ(reproduction(smallWorld(), request, " --dat d"),
              "limen shot --dat d --eye=-1.25,2,0.1 --yaw=30 --pitch=-5 --fov=60 --size=1280x720 "
              "--root=0xA9B40105 --day=0");
    request.scene.player = {1, 2, 3};
    request.scene.seconds = 2.5;
    request.scene.doors = 0.5;
    request.scene.dayGroup = 3;
    request.scene.weather = Weather::Rain;
    request.scene.time = 0.25;
    EXPECT_TRUE(
        reproduction(smallWorld(), request, "")
            .ends_with(" --time=0.25 --seconds=2.5 --doors=0.5 --day=3 --weather=rain --player=1,2,3"));
}

TEST(RegionOverlay, distancesAreDarkerTheFartherTheyAre) {
    const float none = std::numeric_limits<float>::infinity();
    const std::vector<float> distances{0.05f, 0.1f, 1.0f, 10.0f, 1e4f, 1e6f, none};
    const output::Picture picture = output::pictureOfDistances(7, 1, distances);
    std::vector<int> greys;
    for (std::size_t i = 0; i < 6; ++i) {
        greys.push_back(picture.rgb[3 * i]);
        EXPECT_EQ(picture.rgb[3 * i], picture.rgb[3 * i + 2]);
    }
    EXPECT_THAT(greys, testing::ElementsAre(255, 255, 204, 153, 0, 0));
    EXPECT_NE(picture.rgb[18], picture.rgb[20]) << "no distance";
}

TEST(RegionOverlay, outlinesEveryVisitInItsColour) {
    output::Picture picture(64, 64);
    output::drawRegions(picture, twoVisits());
    EXPECT_EQ(picture.at(0, 30), output::distinctColour(0));  // the root's left edge
    EXPECT_EQ(picture.at(48, 20), output::distinctColour(1)); // x = 0.5: the opening's right edge
}

} // namespace
} // namespace limen::engine
