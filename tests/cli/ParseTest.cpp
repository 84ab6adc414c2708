#include "cli/Parse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace limen::cli {
namespace {

TEST(ParseNumber, readsDoublesAndTheirSigns) {
    EXPECT_EQ(parseNumber("--yaw", "90").value(), 90.0);
    EXPECT_EQ(parseNumber("--yaw", " -1.5e3 ").value(), -1500.0);
    EXPECT_EQ(parseNumber("--yaw", "+2").value(), 2.0);
    EXPECT_EQ(parseNumber("--yaw", "32640.000000000001").value(), 32640.000000000001);
}

TEST(ParseNumber, refusesWhatIsNoFiniteNumber) {
    for (const char* text : {"", " ", "nan", "NaN", "-nan", "inf", "-inf", "infinity", "1e999", "-1e999",
                             "1,5", "1 2", "0x10", "ten", "1m", "--1", "+-1", "++1"})
        EXPECT_FALSE(parseNumber("--yaw", text)) << text;
}

TEST(ParseVec3, readsThreeNumbers) {
    EXPECT_EQ(parseVec3("--eye", "-1,2.5, 3e2").value(), Vec3(-1.0, 2.5, 300.0));
}

TEST(ParseVec3, refusesOtherCountsAndNaN) {
    for (const char* text : {"", "1", "1,2", "1,2,", ",,", "1,2,3,4", "1,2,3,", "nan,0,0", "0,inf,0",
                             "0,0,-nan", "1;2;3", "a,b,c"})
        EXPECT_FALSE(parseVec3("--eye", text)) << text;
}

TEST(ParseVec3, namesTheOptionAndTheTextInItsMessage) {
    const auto result = parseVec3("--eye", "1,two,3");
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message(),
                testing::AllOf(testing::HasSubstr("--eye"), testing::HasSubstr("two")));
}

TEST(ParseSize, readsSizesUpToTheLimit) {
    const engine::PixelSize size = parseSize("--size", "640x360").value();
    EXPECT_EQ(size.width, 640u);
    EXPECT_EQ(size.height, 360u);
    EXPECT_TRUE(parseSize("--size", "1x1"));
    EXPECT_TRUE(parseSize("--size", "16384x16384"));
}

TEST(ParseSize, refusesAbsurdSizes) {
    for (const char* text :
         {"", "0x0", "0x1", "1x0", "16385x1", "1x16385", "100000x100000", "99999999999x99999999999",
          "4294967297x1", "-1x5", "640", "640x", "x360", "640x360x1", "640*360", "1.5x2", "axb"})
        EXPECT_FALSE(parseSize("--size", text)) << text;
}

TEST(ParseRoot, knowsItsThreeForms) {
    EXPECT_EQ(parseRoot("--root", "auto").value().rule, engine::RootChoice::Rule::Auto);
    EXPECT_EQ(parseRoot("--root", "outside").value().rule, engine::RootChoice::Rule::Outside);
    const engine::RootChoice cell = parseRoot("--root", "0xA9B40105").value();
    EXPECT_EQ(cell.rule, engine::RootChoice::Rule::Cell);
    EXPECT_EQ(cell.cell, 0xA9B40105u);
}

TEST(ParseRoot, refusesWhatIsNoCell) {
    for (const char* text :
         {"", "inside", "0x", "0xA9B40031", "0xA9B4FFFF", "0xA9B4FFFE", "0xA9B401050", "0xG9B40105", "-1"})
        EXPECT_FALSE(parseRoot("--root", text)) << text;
}

TEST(ParseWeather, knowsClearAndRain) {
    EXPECT_EQ(parseWeather("--weather", "clear").value(), engine::Weather::Clear);
    EXPECT_EQ(parseWeather("--weather", "rain").value(), engine::Weather::Rain);
    EXPECT_FALSE(parseWeather("--weather", "snow"));
}

TEST(ParseLook, knowsRetailAndEnhanced) {
    EXPECT_EQ(parseLook("--look", "retail").value(), engine::Look::Retail);
    EXPECT_EQ(parseLook("--look", "enhanced").value(), engine::Look::Enhanced);
    EXPECT_FALSE(parseLook("--look", "modern"));
}

TEST(SplitArguments, groupsByQuotesAsAShellDoes) {
    EXPECT_THAT(splitArguments(R"(--eye 1,2,3  --at "0xA9B40031 [1 2 3]" -o a\ b.png '' )").value(),
                testing::ElementsAre("--eye", "1,2,3", "--at", "0xA9B40031 [1 2 3]", "-o", "a b.png", ""));
    EXPECT_THAT(splitArguments("").value(), testing::IsEmpty());
    EXPECT_FALSE(splitArguments("--at 'open"));
}

TEST(Parse, messagesStayOneShortLineWhateverIsTyped) {
    const auto result = parseNumber("--yaw", std::string(5000, 'x') + "\n\x1b[31m");
    ASSERT_FALSE(result);
    EXPECT_LT(result.error().message().size(), 200u);
    EXPECT_EQ(parseNumber("--yaw", "a\nb").error().message().find('\n'), std::string::npos);
}

TEST(ParseNumberOrAuto, namesBothFormsInItsError) {
    EXPECT_EQ(*parseNumberOrAuto("--scale", "auto", 50, 100), std::nullopt);
    EXPECT_EQ(*parseNumberOrAuto("--scale", "75", 50, 100), 75.0);
    for (const char* text : {"fast", "30", "101", "", "nan"}) {
        const auto parsed = parseNumberOrAuto("--scale", text, 50, 100);
        ASSERT_FALSE(parsed) << text;
        EXPECT_NE(parsed.error().message().find("auto or a number from 50 to 100"), std::string::npos);
    }
}

} // namespace
} // namespace limen::cli
