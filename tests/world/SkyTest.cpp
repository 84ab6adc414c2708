#include "world/Sky.h"

#include "support/LoadTestWorld.h"

namespace limen::world {
namespace {

dat::SkyTimeOfDay keyframe(float begin, float bright, float heading, float pitch) {
    dat::SkyTimeOfDay key;
    key.begin = begin;
    key.dirBright = bright;
    key.dirHeading = heading;
    key.dirPitch = pitch;
    key.dirColour.argb = 0xFFFF0000;
    key.ambBright = bright;
    key.ambColour.argb = 0xFFFFFFFF;
    key.minFog = 100.0f * bright;
    key.maxFog = 1000.0f * bright;
    key.fogMode = 1;
    return key;
}

Sky twoKeys() {
    Sky sky;
    dat::DayGroup group;
    group.times = {keyframe(0.75f, 3.0f, 350.0f, 0.0f), keyframe(0.25f, 1.0f, 10.0f, 90.0f)}; // out of order
    sky.desc.dayGroups = {group};
    return sky;
}

TEST(SkyAt, interpolatesBetweenKeyframesInTheirOrder) {
    const Sky sky = twoKeys();
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.25).sunColour.x, 1.0f);
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).sunColour.x, 2.0f);
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).ambient.y, 2.0f);
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).fogFar, 2000.0f);
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).sunColour.y, 0.0f);
}

TEST(SkyAt, interpolatesAcrossMidnight) {
    const Sky sky = twoKeys();
    EXPECT_NEAR(skyAt(sky, 0, 0.0).sunColour.x, 2.0f, 1e-6f);
    EXPECT_NEAR(skyAt(sky, 0, 0.1).sunColour.x, 3.0f - 2.0f * 0.35f / 0.5f, 1e-5f);
    EXPECT_NEAR(skyAt(sky, 0, 1.1).sunColour.x, skyAt(sky, 0, 0.1).sunColour.x, 1e-6f);
}

TEST(SkyAt, takesTheHeadingClockwiseFromNorth) {
    struct Case {
        float heading, pitch;
        Vec3f direction;
    };
    for (const auto& [heading, pitch, direction] :
         {Case{0, 0, {0, 1, 0}}, {90, 0, {1, 0, 0}}, {0, 90, {0, 0, 1}}}) {
        Sky sky;
        sky.desc.dayGroups.emplace_back();
        sky.desc.dayGroups[0].times = {keyframe(0.0f, 1.0f, heading, pitch)};
        EXPECT_LT(glm::length(skyAt(sky, 0, 0.5).sunDirection - direction), 1e-6f) << heading << " " << pitch;
    }
}

TEST(SkyAt, mixesHeadingsAsPlainNumbers) {
    const SkyState noon = skyAt(twoKeys(), 0, 0.5); // heading between 10 and 350: 180; pitch 45
    EXPECT_NEAR(noon.sunDirection.x, 0.0f, 1e-5f);
    EXPECT_NEAR(noon.sunDirection.y, -std::sqrt(0.5f), 1e-5f);
    EXPECT_NEAR(noon.sunDirection.z, std::sqrt(0.5f), 1e-5f);
}

TEST(SkyAt, takesTheKeyframesAroundATime) {
    Sky sky;
    sky.desc.dayGroups.emplace_back();
    for (const float begin : {0.0f, 0.5f, 0.8f})
        sky.desc.dayGroups[0].times.push_back(keyframe(begin, 1.0f + begin, 0.0f, 0.0f));
    EXPECT_NEAR(skyAt(sky, 0, 0.9).sunBright, 1.4f, 1e-6f) << "half way from the third to the first";
}

TEST(SkyAt, mixesColoursByBytes_apartFromTheirBrightness) {
    Sky sky = twoKeys();
    sky.desc.dayGroups[0].times[1].dirColour.argb = 0xFF010000; // at 0.25, brightness 1; then 0xFF0000 and 3
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).sunColour.x, 2.0f * 128.0f / 255.0f);
    sky.desc.dayGroups[0].times[1].dirColour.argb = 0xFF000000;
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).sunColour.x, 2.0f * 127.0f / 255.0f) << "127.5 is cut";
}

TEST(SkyAt, ambientLightIsNeverBelowAFifth_andGreaterOnThings) {
    Sky sky = twoKeys();
    for (dat::SkyTimeOfDay& time : sky.desc.dayGroups[0].times) {
        time.ambBright = 0.1f;
        time.dirBright = 0.5f;
        time.ambColour.argb = 0xFFFF00FF;
    }
    const SkyState state = skyAt(sky, 0, 0.5);
    EXPECT_FLOAT_EQ(state.ambient.x, 0.2f);
    EXPECT_FLOAT_EQ(state.ambient.y, 0.0f);
    EXPECT_FLOAT_EQ(state.thingsAmbient().x, 0.2f + 0.2f * 0.5f);
}

TEST(SkyAt, hasDefaultsOfTheOriginal) {
    const SkyState none = skyAt(Sky{}, 0, 0.5);
    EXPECT_LT(glm::length(none.sunDirection * none.sunBright - Vec3f(1.2f, 0.0f, 0.5f)), 1e-5f);
    EXPECT_FLOAT_EQ(none.ambient.x, 0.4f);
    EXPECT_NEAR(none.thingsAmbient().x, 0.66f, 1e-5f);
    Sky empty;
    empty.desc.dayGroups.emplace_back();
    const SkyState noKeyframes = skyAt(empty, 0, 0.5);
    EXPECT_LT(glm::length(noKeyframes.sunDirection * noKeyframes.sunBright - Vec3f(0.5f, 0.0f, 0.8f)), 1e-5f);
    EXPECT_FLOAT_EQ(noKeyframes.ambient.x, 0.3f);
}

TEST(SkyAt, hasFogIfBothKeyframesHave) {
    Sky sky = twoKeys();
    EXPECT_FLOAT_EQ(skyAt(sky, 0, 0.5).fogFar, 2000.0f);
    sky.desc.dayGroups[0].times[0].fogMode = 0;
    EXPECT_GT(skyAt(sky, 0, 0.5).fogFar, 1e6f);
}

TEST(SkyTimes, areThoseOfTheLastUpdate) {
    Sky sky;
    sky.time.dayLength = 7620.0f;
    sky.desc.tickSize = 0.8;
    sky.desc.lightTickSize = 15.0;
    EXPECT_DOUBLE_EQ(timeOfLight(sky, 0.25), 0.25) << "127 updates";
    EXPECT_NEAR(timeOfLight(sky, 0.25 + 14.9 / 7620.0), 0.25, 1e-12);
    EXPECT_NEAR(timeOfLight(sky, 0.25 + 15.1 / 7620.0), 0.25 + 15.0 / 7620.0, 1e-12);
    EXPECT_NEAR(timeOfSky(sky, 0.25 + 1.7 / 7620.0), 0.25 + 1.4 / 7620.0, 1e-12) << "0.25 is between two";
    EXPECT_DOUBLE_EQ(timeOfSky(Sky{}, 0.123), 0.123);
}

TEST(SkyAt, hasDefaultsWithoutASkyAndClampsTheGroup) {
    EXPECT_FLOAT_EQ(skyAt(Sky{}, 3, 0.5).ambient.x, SkyState{}.ambient.x);
    EXPECT_FLOAT_EQ(skyAt(twoKeys(), 99, 0.5).sunColour.x, 2.0f);
    Sky one = twoKeys();
    one.desc.dayGroups[0].times.resize(1);
    EXPECT_FLOAT_EQ(skyAt(one, 0, 0.1).sunColour.x, 3.0f);
    EXPECT_FLOAT_EQ(skyAt(one, 0, std::nan("")).sunColour.x, 3.0f);
}

TEST(SkyPlacements, showObjectsInTheirHoursAndMoveThemAlongTheirArc) {
    Sky sky = twoKeys();
    SkyPart sun;
    sun.object.beginTime = 0.25f;
    sun.object.endTime = 0.75f;
    sun.object.beginAngle = 0.0f;
    sun.object.endAngle = 180.0f;
    sun.object.texVelocityX = 0.5f;
    sky.parts = {sun};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, {0, 0.5, 3.0}, out);
    ASSERT_EQ(out.size(), 1u);
    const Vec3f up = out[0].rotation * Vec3f(1, 0, 0);
    EXPECT_NEAR(up.z, 1.0f, 1e-5f) << "rises in the east (+x) and is overhead half-way";
    EXPECT_NEAR(out[0].uvOffset.x, 0.5f, 1e-5f);
    skyPlacements(sky, {0, 0.2501, 0.0}, out);
    EXPECT_NEAR((out[0].rotation * Vec3f(1, 0, 0)).x, 1.0f, 1e-3f);
    skyPlacements(sky, {0, 0.8, 0.0}, out);
    EXPECT_TRUE(out.empty());
}

TEST(SkyPlacements, areShownStrictlyBetweenBeginAndEnd_neverThroughMidnight) {
    struct Case {
        float begin, end;
        double time;
        bool isShown;
    };
    for (const auto& [begin, end, time, expected] : {Case{0.25f, 0.75f, 0.25, false},
                                                     {0.25f, 0.75f, 0.5, true},
                                                     {0.25f, 0.75f, 0.75, false},
                                                     {0.75f, 0.25f, 0.9, false},
                                                     {0.5f, 0.5f, 0.1, true}}) {
        Sky sky = twoKeys();
        SkyPart part;
        part.object.beginTime = begin;
        part.object.endTime = end;
        sky.parts = {part};
        std::vector<SkyPlacement> out;
        skyPlacements(sky, {0, time, 0.0}, out);
        EXPECT_EQ(!out.empty(), expected) << begin << " " << end << " " << time;
    }
}

/// Placement of an object at 0.5, half way between two replacements.
std::vector<SkyPlacement> placedBetween(const dat::SkyObjectReplace& from, const dat::SkyObjectReplace& to) {
    Sky sky = twoKeys();
    sky.desc.dayGroups[0].times[1].replaces = {from}; // at 0.25
    sky.desc.dayGroups[0].times[0].replaces = {to};   // at 0.75
    sky.parts = {SkyPart{}};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, {0, 0.5, 0.0}, out);
    return out;
}

TEST(SkyPlacements, mixReplacedValuesInHundredths) {
    dat::SkyObjectReplace from, to;
    from.luminosity = 20.0f;
    to.luminosity = 60.0f;
    from.maxBright = 10.0f;
    to.maxBright = 50.0f;
    to.transparent = 100.0f;
    const SkyPlacement placed = placedBetween(from, to).at(0);
    EXPECT_NEAR(placed.luminosity, 0.4f, 1e-6f);
    EXPECT_NEAR(placed.diffuse, 0.3f, 1e-6f);
    EXPECT_NEAR(placed.transparent, 0.5f, 1e-6f);
}

TEST(SkyPlacements, takeValuesThatBothKeyframesSet) {
    for (const float notSet : {-1.0f, 0.0f}) {
        dat::SkyObjectReplace from, to;
        from.luminosity = from.maxBright = notSet;
        from.transparent = -1.0f;
        to.luminosity = to.maxBright = 60.0f;
        to.transparent = 100.0f;
        const SkyPlacement placed = placedBetween(from, to).at(0);
        EXPECT_EQ(placed.luminosity, 0.0f) << "the Surface's own counts";
        EXPECT_EQ(placed.diffuse, 1.0f);
        EXPECT_EQ(placed.transparent, 0.0f);
    }
    dat::SkyObjectReplace other, to;
    other.objectIndex = 7; // not this object, although in the same place of the list
    to.transparent = 100.0f;
    EXPECT_EQ(placedBetween(other, to).at(0).transparent, 0.0f);
}

TEST(SkyPlacements, thatAreWhollyTransparentAreLeftOut) {
    dat::SkyObjectReplace hidden;
    hidden.transparent = 100.0f;
    EXPECT_TRUE(placedBetween(hidden, hidden).empty());
}

TEST(SkyPlacements, turnByTheirOwnKeyframe) {
    dat::SkyObjectReplace from, to;
    from.rotate = 90.0f;
    to.rotate = 270.0f;
    EXPECT_NEAR((placedBetween(from, to).at(0).rotation * Vec3f(0, 1, 0)).x, 1.0f, 1e-5f) << "not mixed";
}

TEST(SkyPlacements, ofWeatherFollowTheViewer) {
    for (const auto& [properties, z] : {std::pair{0u, 0.0f}, {4u, -150.0f}, {12u, 0.0f}, {13u, 0.0f}}) {
        Sky sky = twoKeys();
        sky.parts = {SkyPart{}};
        sky.parts[0].object.properties = properties;
        std::vector<SkyPlacement> out;
        skyPlacements(sky, {0, 0.5, 0.0, 30.0}, out);
        ASSERT_EQ(out.size(), 1u);
        EXPECT_EQ(out[0].offset, Vec3f(0.0f, 0.0f, z)) << properties;
        EXPECT_EQ(out[0].isOverLand, properties == 13u);
    }
}

TEST(SkyPlacements, standAtTheOriginOfTheirView_butWeather) {
    for (const auto& [properties, offset] : {std::pair{0u, Vec3f(-7, 3, -30)},
                                             {1u, Vec3f(-7, 3, -30)},
                                             {4u, Vec3f(0, 0, -150)},
                                             {12u, Vec3f(0, 0, 0)}}) {
        Sky sky = twoKeys();
        sky.parts = {SkyPart{}};
        sky.parts[0].object.properties = properties;
        std::vector<SkyPlacement> out;
        skyPlacements(sky, {0, 0.5, 0.0, 30.0, true, Vec3(-7, 3, -30)}, out);
        ASSERT_EQ(out.size(), 1u);
        EXPECT_EQ(out[0].offset, offset) << properties;
    }
}

TEST(SkyPlacements, overTheLandAreForViewersOutdoors) {
    Sky sky = twoKeys();
    sky.parts = {SkyPart{}, SkyPart{}};
    sky.parts[1].object.properties = 5;
    std::vector<SkyPlacement> out;
    skyPlacements(sky, {0, 0.5, 0.0, 0.0, true}, out);
    EXPECT_EQ(out.size(), 2u);
    skyPlacements(sky, {0, 0.5, 0.0, 0.0, false}, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u);
}

TEST(SkyPlacements, ofReplacedModelsAreShownAtAnyTime) {
    Sky sky = twoKeys();
    dat::SkyObjectReplace other;
    other.gfxObj = 0x01000007;
    sky.desc.dayGroups[0].times[1].replaces = {other};
    SkyPart part;
    part.replacement = other.gfxObj;
    part.object.beginTime = 0.6f;
    part.object.endTime = 0.7f;
    sky.parts = {part};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, {0, 0.5, 0.0}, out);
    EXPECT_EQ(out.size(), 1u);
}

TEST(RainyDayGroup, isTheFirstWithRainOverTheLand) {
    dat::SkyDesc sky;
    sky.dayGroups.resize(4);
    EXPECT_EQ(rainyDayGroup(sky, 1), 1u) << "none";
    dat::SkyObject rain;
    rain.properties = 5;
    rain.texVelocityY = -2.0f;
    sky.dayGroups[2].objects = sky.dayGroups[3].objects = {rain};
    EXPECT_EQ(rainyDayGroup(sky, 1), 2u);
    EXPECT_EQ(rainyDayGroup(sky, 3), 3u);
    sky.dayGroups[2].objects[0].properties = 4;
    EXPECT_EQ(rainyDayGroup(sky, 0), 3u);
}

TEST(SkyPlacements, showTheModelsThatKeyframesReplaceAnObjectWith) {
    Sky sky = twoKeys();
    dat::SkyObjectReplace other, own;
    other.gfxObj = 0x01000007;
    sky.desc.dayGroups[0].times[0].replaces = {other}; // starts at 0.75
    sky.desc.dayGroups[0].times[1].replaces = {own};   // starts at 0.25
    SkyPart itself, inPlace, never;
    inPlace.replacement = 0x01000007;
    never.replacement = 0x01000008;
    sky.parts = {itself, inPlace, never};
    std::vector<SkyPlacement> out;
    for (const auto& [time, part] : {std::pair{0.25, 0u}, {0.7499, 0u}, {0.75, 1u}, {0.9, 1u}, {0.2, 1u}}) {
        skyPlacements(sky, {0, time, 0.0}, out);
        ASSERT_EQ(out.size(), 1u) << time;
        EXPECT_EQ(out[0].part, part) << time;
    }
    sky.desc.dayGroups[0].times[0].replaces.clear();
    skyPlacements(sky, {0, 0.9, 0.0}, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u) << "an object that no keyframe mentions is unchanged";
}

TEST(Sky, loadsTheMeshesOfReplacements) {
    test::TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    dat::SkyObject moon;
    moon.object = source.addModel(test::boxWalls({-10, -10, -10}, {10, 10, 10}, "white"));
    dat::SkyObjectReplace replace;
    replace.objectIndex = 0;
    replace.gfxObj = source.addModel({test::Wall{test::rectangle({-5, 9, -5}, {5, 9, 5}), "red"}});
    dat::DayGroup& group = source.region().sky.dayGroups[0];
    group.objects = {moon};
    group.times = {keyframe(0.0f, 1.0f, 0.0f, 90.0f), keyframe(0.5f, 1.0f, 0.0f, 90.0f)};
    group.times[1].replaces = {replace};
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.sky.parts.size(), 2u);
    EXPECT_EQ(world.sky.parts[0].replacement, 0u);
    EXPECT_EQ(world.sky.parts[1].replacement, replace.gfxObj);
    EXPECT_EQ(world.meshes[world.sky.parts[1].mesh].vertexCount, 6u);
    std::vector<SkyPlacement> out;
    skyPlacements(world.sky, {0, 0.25, 0.0}, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u);
    skyPlacements(world.sky, {0, 0.75, 0.0}, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 1u);
}

TEST(Sky, loadsItsMeshesFromTheRegion) {
    test::TestWorld source;
    source.setFlatTerrain(source.home(), 1);
    dat::SkyObject dome;
    dome.object = source.addModel(test::boxWalls({-100, -100, -100}, {100, 100, 100}, "blue"));
    source.region().sky.dayGroups[0].objects = {dome};
    const World world = test::loadTestWorld(source);
    ASSERT_EQ(world.sky.parts.size(), 1u);
    EXPECT_EQ(world.meshes[world.sky.parts[0].mesh].vertexCount, 36u);
    EXPECT_LT(world.sky.parts[0].firstMaterial, world.materialRefs.size());
    EXPECT_GT(skyAt(world.sky, 0, 0.5).sunDirection.z, 0.5f);
}

TEST(DayGroupNamed, readsNumbersAndNames) {
    dat::SkyDesc sky;
    EXPECT_EQ(dayGroupNamed(sky, "0"), 0u) << "without any";
    EXPECT_EQ(dayGroupNamed(sky, "1"), std::nullopt);
    for (const char* name : {"Sunny", "Rainy", "Rainy", ""}) {
        sky.dayGroups.emplace_back();
        sky.dayGroups.back().name = name;
    }
    EXPECT_EQ(dayGroupNamed(sky, "3"), 3u);
    EXPECT_EQ(dayGroupNamed(sky, "sunny"), 0u);
    EXPECT_EQ(dayGroupNamed(sky, "RAINY"), 1u) << "the first";
    for (const char* wrong : {"4", "-1", "1x", "rain", "99999999999"})
        EXPECT_EQ(dayGroupNamed(sky, wrong), std::nullopt) << wrong;
}

} // namespace
} // namespace limen::world
