// Rules of the land, the calendar and the sky against the values of the file that LIMEN_VECTORS names (docs/evidence.md). The values
// are read from it; tests of each rule have copies of most. Without the file these tests are skipped.
#include "world/Calendar.h"
#include "world/Ground.h"
#include "world/LandRandom.h"
#include "world/Sky.h"
#include "world/terrain/Scenery.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace limen::world {
namespace {

using Json = nlohmann::json;

class StatedValues : public ::testing::Test {
protected:
    void SetUp() override {
        const char* const path = std::getenv("LIMEN_VECTORS");
        if (path == nullptr)
            GTEST_SKIP() << "LIMEN_VECTORS names no file";
        std::ifstream in(path);
        ASSERT_TRUE(in) << path;
        sets_ = Json::parse(in).at("sets");
    }
    [[nodiscard]] const Json& values(const char* set, const char* part) const {
        return sets_.at(set).at(part);
    }

private:
    Json sets_;
};

std::uint32_t hexOf(const Json& text) {
    return static_cast<std::uint32_t>(std::stoul(text.get<std::string>(), nullptr, 16));
}

dat::GameTime calendarOf(const Json& params) {
    dat::GameTime time;
    time.zeroTimeOfYear = params.at("zeroTimeOfYear");
    time.zeroYear = params.at("zeroYear");
    time.dayLength = params.at("dayLength");
    time.daysPerYear = params.at("daysPerYear");
    return time;
}

TEST_F(StatedValues, ofLandHashes) {
    ASSERT_FALSE(values("landHash", "cases").empty());
    for (const Json& c : values("landHash", "cases"))
        EXPECT_EQ(landHash(c.at("x"), c.at("y"), hexOf(c.at("seed"))), hexOf(c.at("hash"))) << c;
}

TEST_F(StatedValues, ofTheCutsOfLandcells) {
    ASSERT_FALSE(values("split", "blocks").empty());
    for (const auto& [name, rows] : values("split", "blocks").items()) {
        const std::uint32_t word = hexOf(name);
        const dat::BlockCoord block{static_cast<int>(word >> 8), static_cast<int>(word & 0xFF)};
        for (int row = 0; row < 8; ++row) { // the first one is the northern one
            const std::string cuts = rows.at(static_cast<std::size_t>(row));
            for (int x = 0; x < 8; ++x)
                EXPECT_EQ(splitsSouthWestNorthEast(block, x, 7 - row),
                          cuts.at(static_cast<std::size_t>(x)) == '/')
                    << name << " " << x << "," << 7 - row;
        }
    }
    const Json& world = values("split", "world");
    std::uint64_t count = 0;
    for (std::uint32_t x = 0; x < 2040; ++x)
        for (std::uint32_t y = 0; y < 2040; ++y)
            count += splitsSouthWestNorthEast(x, y);
    EXPECT_EQ(2040u * 2040u, world.at("cells").get<std::uint64_t>());
    EXPECT_EQ(count, world.at("swNe").get<std::uint64_t>());
}

TEST_F(StatedValues, ofRoads) {
    ASSERT_FALSE(values("road", "cases").empty());
    for (const Json& c : values("road", "cases")) {
        Ground ground;
        for (const char corner :
             c.at("roads").get<std::string>()) { // A south-west, B north-west, C south-east, D north-east
            const std::size_t x = corner == 'C' || corner == 'D' ? 1 : 0,
                              y = corner == 'B' || corner == 'D' ? 1 : 0;
            ground.words[x * 9 + y] = 1;
        }
        EXPECT_EQ(isOnRoad(ground, c.at("x"), c.at("y")), c.at("on").get<bool>()) << c;
    }
}

TEST_F(StatedValues, ofDates) {
    const dat::GameTime calendar = calendarOf(values("calendar", "params"));
    const Json& months = values("calendar", "months");
    ASSERT_EQ(months.size(), kMonths);
    for (const Json& c : values("calendar", "cases")) {
        const DateTime found = dateTimeOf(calendar, c.at("ticks"));
        EXPECT_EQ(found.date.year, c.at("year").get<std::uint32_t>()) << c;
        EXPECT_EQ(months.at(found.date.dayOfYear / kDaysPerMonth), c.at("month")) << c;
        EXPECT_EQ(found.date.dayOfYear % kDaysPerMonth + 1, c.at("day").get<std::uint32_t>()) << c;
        EXPECT_NEAR(found.time, c.at("fraction").get<double>(), 1e-9) << c;
    }
    const double year = values("calendar", "yearSeconds");
    EXPECT_EQ(dateTimeOf(calendar, year).date.year, calendar.zeroYear + 1);
    EXPECT_NEAR(dateTimeOf(calendar, year).time, dateTimeOf(calendar, 0).time, 1e-9);
    for (std::uint32_t month = 0; month < kMonths; ++month) {
        const std::string name = months.at(month);
        EXPECT_EQ(dateNamed(name + " 1, 11"), (Date{11, month * kDaysPerMonth}));
    }
    const Json& hours = values("calendar", "hours");
    for (std::size_t slot = 0; slot < 16; ++slot) {
        const std::string name = hours.at(slot / 2).get<std::string>() + (slot % 2 == 1 ? "-and-Half" : "");
        EXPECT_EQ(hourName(calendar, (static_cast<double>(slot) + 0.5) / 16.0), name);
    }
}

TEST_F(StatedValues, ofDayGroups) {
    const std::size_t count = values("dayGroup", "params").at("count");
    const dat::GameTime calendar = calendarOf(values("calendar", "params"));
    ASSERT_FALSE(values("dayGroup", "cases").empty());
    for (const Json& c : values("dayGroup", "cases"))
        EXPECT_EQ(dayGroupOn({c.at("year"), c.at("dayOfYear")}, calendar, count),
                  c.at("group").get<std::uint32_t>())
            << c;
}

TEST_F(StatedValues, ofTheSun) {
    ASSERT_FALSE(values("sun", "cases").empty());
    for (const Json& c : values("sun", "cases")) {
        Sky sky;
        dat::SkyTimeOfDay key;
        key.dirHeading = c.at("heading");
        key.dirPitch = c.at("pitch");
        key.dirBright = 1.0f;
        sky.desc.dayGroups.emplace_back().times = {key};
        const Vec3f wanted(c.at("dir").at(0), c.at("dir").at(1), c.at("dir").at(2));
        EXPECT_LT(glm::length(skyAt(sky, 0, 0.5).sunDirection - wanted), 1e-6f) << c;
    }
    for (const Json& c : values("sun", "shown")) {
        dat::SkyObject object;
        object.beginTime = c.at("begin");
        object.endTime = c.at("end");
        EXPECT_EQ(isShown(object, c.at("t")), c.at("shown").get<bool>()) << c;
    }
}

} // namespace
} // namespace limen::world
