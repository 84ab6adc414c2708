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

TEST(SkyAt, turnsTheSunTheShortWay) {
    const SkyState noon = skyAt(twoKeys(), 0, 0.5); // heading between 10 and 350: 0; pitch 45
    EXPECT_NEAR(noon.sunDirection.x, std::sqrt(0.5f), 1e-5f);
    EXPECT_NEAR(noon.sunDirection.y, 0.0f, 1e-5f);
    EXPECT_NEAR(noon.sunDirection.z, std::sqrt(0.5f), 1e-5f);
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
    skyPlacements(sky, 0, 0.5, 3.0, out);
    ASSERT_EQ(out.size(), 1u);
    const Vec3f up = out[0].rotation * Vec3f(1, 0, 0);
    EXPECT_NEAR(up.z, 1.0f, 1e-5f) << "rises in the east (+x) and is overhead half-way";
    EXPECT_NEAR(out[0].uvOffset.x, 0.5f, 1e-5f);
    skyPlacements(sky, 0, 0.25, 0.0, out);
    EXPECT_NEAR((out[0].rotation * Vec3f(1, 0, 0)).x, 1.0f, 1e-5f);
    skyPlacements(sky, 0, 0.8, 0.0, out);
    EXPECT_TRUE(out.empty());
}

TEST(SkyPlacements, showThroughMidnightAndAlways) {
    Sky sky = twoKeys();
    SkyPart moon, dome;
    moon.object.beginTime = 0.8f;
    moon.object.endTime = 0.2f;
    sky.parts = {dome, moon};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, 0, 0.1, 0.0, out);
    EXPECT_EQ(out.size(), 2u);
    skyPlacements(sky, 0, 0.5, 0.0, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u);
}

TEST(SkyPlacements, fadeBetweenReplaces) {
    Sky sky = twoKeys();
    dat::SkyObjectReplace hidden, shown;
    hidden.transparent = 100.0f; // percent
    shown.transparent = 0.0f;
    hidden.rotate = 350.0f;
    shown.rotate = 10.0f;
    sky.desc.dayGroups[0].times[0].replaces = {hidden};
    sky.desc.dayGroups[0].times[1].replaces = {shown};
    sky.parts = {SkyPart{}};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, 0, 0.5, 0.0, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_NEAR(out[0].transparent, 0.5f, 1e-5f);
    EXPECT_NEAR((out[0].rotation * Vec3f(0, 1, 0)).y, 1.0f, 1e-5f) << "half way from 350 to 10 degrees";
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
        skyPlacements(sky, 0, time, 0.0, out);
        ASSERT_EQ(out.size(), 1u) << time;
        EXPECT_EQ(out[0].part, part) << time;
    }
    sky.desc.dayGroups[0].times[0].replaces.clear();
    skyPlacements(sky, 0, 0.9, 0.0, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u) << "an object that no keyframe mentions is unchanged";
}

TEST(SkyPlacements, takeLuminosityFromReplacesAsShareOrPercentage) {
    Sky sky = twoKeys();
    dat::SkyObjectReplace from, to;
    from.luminosity = 20.0f; // percent
    to.luminosity = 60.0f;
    sky.desc.dayGroups[0].times[1].replaces = {from}; // starts at 0.25
    sky.desc.dayGroups[0].times[0].replaces = {to};   // starts at 0.75
    sky.parts = {SkyPart{}};
    std::vector<SkyPlacement> out;
    skyPlacements(sky, 0, 0.5, 0.0, out);
    EXPECT_NEAR(out.at(0).luminosity, 0.4f, 1e-5f);
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
    skyPlacements(world.sky, 0, 0.25, 0.0, out);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].part, 0u);
    skyPlacements(world.sky, 0, 0.75, 0.0, out);
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
