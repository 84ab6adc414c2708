#include "cli/PlaceNotation.h"

#include <cmath>
#include <gtest/gtest.h>

namespace limen::cli {
namespace {

PlacePosition positionOf(std::string_view text) {
    const auto place = parsePlace("--at", text);
    if (!place) {
        ADD_FAILURE() << place.error().message();
        return {};
    }
    return std::get<PlacePosition>(*place);
}

TEST(PlaceNotation, takesAWordAsAName) {
    EXPECT_EQ(std::get<PlaceName>(parsePlace("--at", " cottage.cellar ").value()).name, "cottage.cellar");
    EXPECT_EQ(std::get<PlaceName>(parsePlace("--at", "hill").value()).name, "hill");
    EXPECT_EQ(std::get<PlaceName>(parsePlace("--at", "cafe.room").value()).name,
              "cafe.room"); // hexadecimal by chance
}

TEST(PlaceNotation, takesWordsWithBlanksAsAName) {
    EXPECT_EQ(std::get<PlaceName>(parsePlace("--at", "Glenden Wood").value()).name, "Glenden Wood");
    EXPECT_EQ(std::get<PlaceName>(parsePlace("--at", "town 42.1N 33.6E").value()).name, "town 42.1N 33.6E");
}

TEST(PlaceNotation, addsTheBlocksCornerToLocalMetres) {
    const PlacePosition place = positionOf("A9B4.12,34.5,-6");
    EXPECT_EQ(place.eye, Vec3(0xA9 * 192.0 + 12.0, 0xB4 * 192.0 + 34.5, -6.0));
    EXPECT_EQ(place.root.rule, engine::RootChoice::Rule::Auto);
    EXPECT_FALSE(place.yaw);
    EXPECT_EQ(positionOf("0xa9b4.12,34.5,-6").eye, place.eye);
}

TEST(PlaceNotation, takesTheCellOfAnEightDigitBlockAsRoot) {
    EXPECT_EQ(positionOf("0xA9B40105.1,2,3").root.cell, 0xA9B40105u);
    EXPECT_EQ(positionOf("0xA9B40011.1,2,3").root.rule, engine::RootChoice::Rule::Outside);
    EXPECT_EQ(positionOf("0xA9B40000.1,2,3").root.rule, engine::RootChoice::Rule::Auto);
}

TEST(PlaceNotation, readsRetailLocations) {
    const PlacePosition north = positionOf("0xA9B40031 [150.5 20.25 66.005] 1 0 0 0");
    EXPECT_EQ(north.eye, Vec3(0xA9 * 192.0 + 150.5, 0xB4 * 192.0 + 20.25, 66.005));
    EXPECT_EQ(north.root.rule, engine::RootChoice::Rule::Outside);
    EXPECT_DOUBLE_EQ(north.yaw.value(), 0.0);
    EXPECT_DOUBLE_EQ(north.pitch.value(), 0.0);
    // A quarter turn counter-clockwise about z faces west.
    EXPECT_NEAR(positionOf("0xA9B40031 [1 2 3] 0.7071068 0 0 0.7071068").yaw.value(), 270.0, 1e-4);
    EXPECT_NEAR(positionOf("0xA9B40031 [1 2 3] 0.7071068 0 0 -0.7071068").yaw.value(), 90.0, 1e-4);
    EXPECT_EQ(positionOf("0xA9B40105 [1 2 3]").root.cell, 0xA9B40105u);
    EXPECT_EQ(positionOf("0xA9B40105[1,2,3]").eye, positionOf("0xA9B40105 [1 2 3]").eye);
}

TEST(PlaceNotation, readsMapCoordinatesOntoTheGround) {
    const PlacePosition place = positionOf("42.1N 33.6E");
    EXPECT_TRUE(place.onGround);
    EXPECT_DOUBLE_EQ(place.eye.x, 33.6 * 240.0 + 24468.0);
    EXPECT_DOUBLE_EQ(place.eye.y, 42.1 * 240.0 + 24468.0);
    EXPECT_EQ(positionOf("42.1n, 33.6e").eye, place.eye);
    EXPECT_DOUBLE_EQ(positionOf("10S,20W").eye.x, 24468.0 - 4800.0);
    EXPECT_DOUBLE_EQ(positionOf("10S,20W").eye.y, 24468.0 - 2400.0);
}

TEST(PlaceNotation, refusesNonsense) {
    for (const char* text : {"",
                             "   ",
                             "A9B4.1,2",
                             "A9B4.1,2,nan",
                             "A9B4.1,2,3,4",
                             "FFFF.1,2,3",
                             "0xFF000100.1,2,3",
                             "0xA9B40031 [1 2]",
                             "0xA9B40031 [1 2 3",
                             "0xA9B40031 1 2 3]",
                             "0xA9B40031 [1 2 3] 1 0 0",
                             "0xA9B40031 [1 2 3] 0 0 0 0",
                             "0xA9B40031 [1 2 nan] 1 0 0 0",
                             "0xA9B40031 [1 2 3] inf 0 0 0",
                             "A9 [1 2 3]",
                             "[1 2 3]",
                             "][",
                             "42.1N 33.6N",
                             "200N 0E",
                             "2 words",
                             "1,2,3"})
        EXPECT_FALSE(parsePlace("--at", text)) << text;
}

} // namespace
} // namespace limen::cli
