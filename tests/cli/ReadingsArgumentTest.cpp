#include "cli/ReadingsArgument.h"

#include <gmock/gmock.h>

namespace limen::cli {
namespace {

using testing::HasSubstr;

std::string faultOf(std::string_view text) {
    const Result<world::Readings> readings = parseReadings(text);
    return readings ? "" : readings.error().message();
}

TEST(ParseReadings, takesAListOfNamesAndValues) {
    world::Readings expected;
    expected.skyPlace = world::SkyPlace::Block;
    expected.wallGrey = 0.5;
    EXPECT_EQ(parseReadings("sky-place=block,wall-grey=0.5").value(), expected);
    EXPECT_EQ(parseReadings(" wall-grey = 0.5 , sky-place = block ").value(), expected);
    EXPECT_EQ(parseReadings("sky-place=eye").value(), world::Readings()) << "the default by its name";
}

TEST(ParseReadings, readsEveryTextOfReadings) {
    for (const world::ReadingFacts& reading : world::readingFacts()) {
        for (const std::string_view value : reading.values) {
            world::Readings readings;
            ASSERT_TRUE(setReading(readings, reading.name, value));
            if (const std::string text = textOf(readings); !text.empty())
                EXPECT_EQ(parseReadings(text).value(), readings);
        }
    }
}

TEST(ParseReadings, refusesUnknownNamesAndValuesInOneLine) {
    EXPECT_EQ(faultOf("sky-plce=eye"), "--readings: unknown reading 'sky-plce'. Did you mean 'sky-place'?");
    EXPECT_EQ(faultOf("sky-place=moon"),
              "--readings: 'moon' is not a value of sky-place; choose from eye, block, cell");
    EXPECT_EQ(faultOf("wall-grey=2"),
              "--readings: '2' is not a value of wall-grey; choose from a number from 0 to 1");
    EXPECT_THAT(faultOf("sky-place"), HasSubstr("'sky-place' is not NAME=VALUE"));
    EXPECT_THAT(faultOf(""), HasSubstr("'' is not NAME=VALUE"));
    EXPECT_THAT(faultOf("grain=unlit,"), HasSubstr("'' is not NAME=VALUE"));
    EXPECT_THAT(faultOf("grain=unlit,grain=lit"), HasSubstr("grain is given twice"));
    EXPECT_EQ(faultOf("x\n" + std::string(200, 'y') + "=1").find('\n'), std::string::npos);
}

TEST(ReadingsNotation, hasEveryNameWithItsValues) {
    const std::string text = readingsNotation();
    EXPECT_THAT(text, HasSubstr("sky-place=eye|block|cell, "));
    EXPECT_THAT(text, HasSubstr("level-bias=-1..1"));
    for (const world::ReadingFacts& reading : world::readingFacts())
        EXPECT_THAT(text, HasSubstr(std::string(reading.name) + "="));
}

} // namespace
} // namespace limen::cli
