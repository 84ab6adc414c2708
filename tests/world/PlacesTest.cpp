#include "world/Places.h"

#include "support/LoadTestWorld.h"

#include <fstream>
#include <gmock/gmock.h>

namespace limen::world {
namespace {

Result<WorldFile> loadPlaces(const std::string& text) {
    const test::TempDir directory;
    std::ofstream(directory.path() / "world.json") << text;
    return loadWorldFile(directory.path());
}

TEST(ParseWorldFile, startIsOneOfItsPlaces) {
    const std::string places = R"("places": {"here": {"eye": [1, 2, 3]}, "there": {"eye": [4, 5, 6]}})";
    EXPECT_EQ(parseWorldFile("{" + places + "}", "f")->start, "");
    EXPECT_EQ(parseWorldFile("{" + places + R"(, "start": "there"})", "f")->start, "there");
    for (const char* wrong : {R"("nowhere")", "7", "null"}) {
        const auto parsed = parseWorldFile("{" + places + ", \"start\": " + wrong + "}", "f");
        ASSERT_FALSE(parsed) << wrong;
        EXPECT_NE(parsed.error().message().find("start"), std::string::npos);
    }
}

TEST(LoadWorldFile, readsPlacesAndTour) {
    const auto file = loadPlaces(R"({
        "places": {"hill": {"eye": [1.5, 2, -3], "yaw": 90, "pitch": -5.5},
                   "room": {"eye": [1, 2, 3], "cell": "0xA9B40100", "colour": "red"}},
        "tour": [{"x": 1, "y": 2, "z": 3, "yaw": 10, "pitch": 20, "t": 0.5}, {"eye": [4, 5, 6]}],
        "villagers": []})");
    ASSERT_TRUE(file) << file.error().message();
    ASSERT_EQ(file->places.size(), 2u);
    EXPECT_EQ(file->places[0].name, "hill");
    EXPECT_EQ(file->places[0].eye, Vec3(1.5, 2, -3));
    EXPECT_EQ(file->places[0].yaw, 90.0);
    EXPECT_EQ(file->places[0].cell, 0u);
    EXPECT_EQ(file->places[1].cell, 0xA9B40100u);
    ASSERT_EQ(file->tour.size(), 2u);
    EXPECT_EQ(file->tour[0].pitch, 20.0);
    EXPECT_EQ(file->tour[1].eye, Vec3(4, 5, 6));
}

TEST(LoadWorldFile, isEmptyWithoutAFile) {
    const test::TempDir directory;
    const auto file = loadWorldFile(directory.path());
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->places.empty() && file->tour.empty());
    EXPECT_TRUE(loadPlaces("{}"));
}

TEST(LoadWorldFile, refusesOtherShapesWithASentence) {
    for (const char* text :
         {"", "[", "[]", "7", R"({"places": []})", R"({"places": {"a": 1}})", R"({"places": {"a": {}}})",
          R"({"places": {"a": {"eye": [1, 2]}}})", R"({"places": {"a": {"eye": [1, 2, "x"]}}})",
          R"({"places": {"a": {"eye": [1, 2, 3], "yaw": "n"}}})",
          R"({"places": {"a": {"eye": [1, 2, 3], "cell": "door"}}})", R"({"tour": {}})",
          R"({"tour": [{"x": 1}]})"}) {
        const auto file = loadPlaces(text);
        ASSERT_FALSE(file) << text;
        EXPECT_EQ(file.error().code, ErrorCode::Malformed);
        EXPECT_THAT(file.error().where, testing::HasSubstr("world.json"));
    }
}

} // namespace
} // namespace limen::world
