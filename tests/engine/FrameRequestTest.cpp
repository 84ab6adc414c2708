// Hard cases 18 and 23 of docs/cases.md: weather depends on the player, everything else on the eye.
#include "engine/FrameRequest.h"
#include "motion/Locate.h"
#include "support/MovingHut.h"

namespace limen::engine {
namespace {

struct HutWorld {
    test::MovingHut hut;
    world::World world = hut.load();
    Vec3 inside = hut.at({12, 12, 3.6}), outside = hut.at({6, 12, 3.6});

    [[nodiscard]] FrameRequest eye(const Vec3& at, const Vec3& player,
                                   Weather weather = Weather::Rain) const {
        FrameRequest eye;
        eye.camera.eye = at;
        eye.camera.heading = {37.0, 4.0};
        eye.root = motion::locate(world, at).space;
        eye.scene.player = player;
        eye.scene.weather = weather;
        eye.scene.seconds = 3.5;
        return eye;
    }
};

TEST(DynamicStateInput, case18_itRainsExactlyWhileThePlayerIsOutside) {
    const HutWorld f;
    ASSERT_NE(f.eye(f.inside, f.inside).root, world::kOutside);
    for (const Vec3& eye : {f.inside, f.outside}) {
        EXPECT_TRUE(dynamicsInput(f.world, f.eye(eye, f.outside)).rain);
        EXPECT_FALSE(dynamicsInput(f.world, f.eye(eye, f.inside)).rain);
        EXPECT_FALSE(dynamicsInput(f.world, f.eye(eye, f.outside, Weather::Clear)).rain);
    }
}

TEST(DynamicStateInput, case18_theRegionsWeatherFallsExactlyWhileThePlayerIsOutside) {
    HutWorld f;
    EXPECT_FALSE(dynamicsInput(f.world, f.eye(f.outside, f.outside)).weather) << "the region has no weather";
    f.world.sky.weather.resize(1);
    for (const Vec3& at : {f.inside, f.outside}) {
        FrameRequest eye = f.eye(at, f.outside, Weather::Clear);
        eye.scene.dayGroup = 2;
        eye.scene.time = 0.25;
        const auto hour = dynamicsInput(f.world, eye).weather;
        ASSERT_TRUE(hour);
        EXPECT_EQ(hour->dayGroup, 2u);
        EXPECT_EQ(hour->time, 0.25);
        EXPECT_FALSE(dynamicsInput(f.world, f.eye(at, f.inside)).weather);
    }
}

TEST(DynamicStateInput, case18_aPlayerAtTheEyeIsInTheEyesSpace) {
    const HutWorld f;
    FrameRequest eye = f.eye(f.inside, f.inside);
    eye.root = world::kOutside; // an explicit root overrides the position
    EXPECT_TRUE(dynamicsInput(f.world, eye).rain);
}

TEST(DynamicStateInput, case18_aBodyIsInTheSpaceItSays) {
    const HutWorld f;
    FrameRequest eye = f.eye(f.outside, f.outside);
    eye.scene.body = motion::PlayerBody{f.inside, 0.0, motion::locate(f.world, f.inside).space, 1.0};
    EXPECT_FALSE(dynamicsInput(f.world, eye).rain) << "the body is inside; the other inputs do not matter";
    EXPECT_EQ(dynamicsInput(f.world, eye).player, eye.scene.body);
    eye.scene.body->space = world::kOutside; // as in a cave, whose cells have no position in the landscape
    EXPECT_TRUE(dynamicsInput(f.world, eye).rain);
}

TEST(DynamicStateInput, case23_nothingButTheWeatherDependsOnThePlayer) {
    const HutWorld f;
    const motion::DynamicStateInput in = dynamicsInput(f.world, f.eye(f.outside, f.inside, Weather::Clear)),
                                    out = dynamicsInput(f.world, f.eye(f.outside, f.outside, Weather::Clear));
    EXPECT_EQ(in.seconds, out.seconds);
    EXPECT_EQ(in.eye, out.eye);
    EXPECT_EQ(in.right, out.right);
    EXPECT_EQ(in.up, out.up);
    EXPECT_EQ(in.forward, out.forward);
    EXPECT_EQ(in.rain, out.rain);
    EXPECT_EQ(in.allDoors, out.allDoors);
}

TEST(FrameInputs, theViewersLightIsAboveTheBody_andNoneOutdoors) {
    const HutWorld f;
    EXPECT_EQ(frameInputs(f.world, f.eye(f.inside, f.inside)).view.viewerLight, f.inside);
    EXPECT_EQ(frameInputs(f.world, f.eye(f.outside, f.outside)).view.viewerLight, std::nullopt);
    EXPECT_EQ(frameInputs(f.world, f.eye(f.inside, f.outside)).view.viewerLight, std::nullopt);
    FrameRequest eye = f.eye(f.outside, f.outside);
    eye.scene.body = motion::PlayerBody{f.inside, 0.0, motion::locate(f.world, f.inside).space, 1.0};
    EXPECT_EQ(frameInputs(f.world, eye).view.viewerLight, f.inside + Vec3(0, 0, 2));
}

// Ids and depth are compared with the reference, which knows neither a scaled picture nor what was planned before.
TEST(FrameInputs, judgedFramesHaveWholeDistances_andAlwaysLeaveOutWhatIsHidden) {
    const HutWorld f;
    FrameRequest half;
    scaleRequest(f.eye(f.outside, f.outside), 50, half);
    const FrameInputs shown = frameInputs(f.world, half),
                      judged = frameInputs(f.world, half, {.exactCutOuts = true});
    EXPECT_EQ(shown.view.levels, world::levelShareOf(50));
    EXPECT_EQ(shown.dynamics.levels, world::levelShareOf(50));
    EXPECT_EQ(shown.view.occlusion, frame::Occlusion::IfWorthwhile);
    EXPECT_EQ(judged.view.levels, world::LevelShare{});
    EXPECT_EQ(judged.dynamics.levels, world::LevelShare{});
    EXPECT_EQ(judged.view.occlusion, frame::Occlusion::Always);
}

TEST(FrameInputs, rainShowsADayWithRain) {
    HutWorld f;
    f.world.sky.desc.dayGroups.resize(3);
    EXPECT_EQ(frameInputs(f.world, f.eye(f.outside, f.outside)).view.dayGroup, 0u) << "none has rain";
    dat::SkyObject rain;
    rain.properties = 5;
    rain.texVelocityY = -2.0f;
    f.world.sky.desc.dayGroups[2].objects = {rain};
    EXPECT_EQ(frameInputs(f.world, f.eye(f.outside, f.outside)).view.dayGroup, 2u);
    EXPECT_EQ(frameInputs(f.world, f.eye(f.outside, f.outside, Weather::Clear)).view.dayGroup, 0u);
}

} // namespace
} // namespace limen::engine
