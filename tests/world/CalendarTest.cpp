#include "world/Calendar.h"

#include <gtest/gtest.h>

namespace limen::world {
namespace {

dat::GameTime retail() {
    dat::GameTime time;
    time.zeroTimeOfYear = 3600.0;
    time.zeroYear = 10;
    return time;
}

TEST(Calendar, findsDatesOfTicks) {
    const DateTime first = dateTimeOf(retail(), 0.0);
    EXPECT_EQ(dateText(first.date), "Morningthaw 1, 10 P.Y.");
    EXPECT_NEAR(first.time, 0.47244094488188976, 1e-12);
    const DateTime later = dateTimeOf(retail(), 291408060.0);
    EXPECT_EQ(later.date, (Date{116, 83}));
    EXPECT_EQ(dateText(later.date), "Seedsow 24, 116 P.Y.");
    EXPECT_NEAR(later.time, 0.0, 1e-9);
}

TEST(Calendar, findsTheDayGroupOfADate) {
    struct Case {
        Date date;
        std::uint32_t group;
    };
    for (const auto& [date, group] :
         {Case{{10, 0}, 16}, {{10, 83}, 5}, {{116, 83}, 18}, {{127, 359}, 4}, {{10, 1}, 5}})
        EXPECT_EQ(dayGroupOn(date, retail(), 20), group) << dateText(date);
    EXPECT_EQ(dayGroupOn(Date(), retail(), 20), 5u) << "the default is a sunny day";
    for (const std::size_t few : {0u, 1u, 2u, 3u})
        EXPECT_EQ(dayGroupOn(Date(), retail(), few), 0u);
    for (std::uint32_t day = 0; day < 3600; ++day)
        EXPECT_LT(dayGroupOn({day / 360, day % 360}, retail(), 3), 3u);
}

TEST(Calendar, readsDates) {
    for (const char* text : {"116-3-24", "116-03-24", "Seedsow 24, 116", "seedsow 24 116", "Seed 24, 116"})
        EXPECT_EQ(dateNamed(text), (Date{116, 83})) << text;
    for (std::uint32_t day = 0; day < 360; ++day) {
        const Date date{12, day};
        const std::string text = dateText(date);
        EXPECT_EQ(dateNamed(text.substr(0, text.size() - 5)), date) << text;
    }
    for (const char* wrong : {"", "116", "116-13-1", "116-0-1", "116-1-31", "116-1-0", "Seedsow 24",
                              "Leaf 3, 10", "Se 1, 10", "Seedsow -1, 10", "116-1-1-1", "4000000000-1-1"})
        EXPECT_EQ(dateNamed(wrong), std::nullopt) << wrong;
}

TEST(Calendar, namesHours) {
    dat::GameTime time;
    EXPECT_EQ(hourName(time, 0.0), "Darktide");
    EXPECT_EQ(hourName(time, 0.0625), "Darktide-and-Half");
    EXPECT_EQ(hourName(time, 0.5), "Midsong");
    EXPECT_EQ(hourName(time, 0.999), "Gloaming-and-Half");
    EXPECT_EQ(hourName(time, 1.5), "Midsong");
    time.timesOfDay = {{0.0f, 1, "Watch"}, {0.5f, 0, "Bell"}};
    EXPECT_EQ(hourName(time, 0.49), "Watch");
    EXPECT_EQ(hourName(time, 0.5), "Bell");
}

} // namespace
} // namespace limen::world
