#include "world/Readings.h"

#include <gtest/gtest.h>

#include <set>

namespace limen::world {
namespace {

TEST(Readings, areTheDefaultsWithoutAText) {
    EXPECT_EQ(textOf(Readings()), "");
    for (const ReadingFacts& reading : readingFacts()) {
        Readings readings;
        const std::string first =
            reading.values.empty() ? std::to_string(reading.high) : std::string(reading.values.front());
        EXPECT_TRUE(setReading(readings, reading.name, first)) << reading.name;
        EXPECT_EQ(readings, Readings()) << reading.name;
    }
}

TEST(Readings, haveNamesForEachOfTheirValues) {
    std::set<std::string> texts;
    std::size_t count = 0;
    for (const ReadingFacts& reading : readingFacts()) {
        for (const std::string_view value : reading.values) {
            Readings readings;
            ASSERT_TRUE(setReading(readings, reading.name, value));
            const std::string text = textOf(readings);
            texts.insert(text);
            count += value != reading.values.front() ? 1 : 0;
            if (value != reading.values.front())
                EXPECT_EQ(text, std::string(reading.name) + "=" + std::string(value));
        }
    }
    EXPECT_EQ(count, 11u);
    EXPECT_EQ(texts.size(), count + 1) << "all differ, and the defaults have none";
}

TEST(Readings, takeNumbersWithinTheirLimits) {
    Readings readings;
    EXPECT_TRUE(setReading(readings, "wall-grey", "0.25"));
    EXPECT_TRUE(setReading(readings, "level-bias", "-1"));
    EXPECT_EQ(textOf(readings), "wall-grey=0.25,level-bias=-1");
    const Readings before = readings;
    for (const char* text : {"", "-0.1", "1.1", "nan", "0.5x", " 0.5", "grey"})
        EXPECT_FALSE(setReading(readings, "wall-grey", text)) << text;
    EXPECT_FALSE(setReading(readings, "sky-place", "moon"));
    EXPECT_FALSE(setReading(readings, "sky-places", "eye"));
    EXPECT_EQ(readings, before);
}

TEST(Readings, nameThoseThatDifferInAFixedOrder) {
    Readings readings;
    readings.grain = GroundGrain::Unlit;
    readings.skyPlace = SkyPlace::Cell;
    readings.normals = ScaledNormals::Divided;
    EXPECT_EQ(textOf(readings), "sky-place=cell,normals=divided,grain=unlit");
}

} // namespace
} // namespace limen::world
