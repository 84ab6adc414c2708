#include "world/Calendar.h"
#include "doctor/retail/Judges.h"

#include <array>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kCalendarSource = "tests of two public clients";
using Found = std::optional<Numbers>;

struct DateFact {
    double ticks, year, day, fraction;
};
constexpr std::array<DateFact, 2> kDates{{{0, 10, 0, 0.47244094488188976}, {291408060, 116, 83, 0}}};

struct GroupFact {
    std::uint32_t year, day;
    double group;
};
constexpr std::array<GroupFact, 5> kGroups{
    {{10, 0, 16}, {10, 83, 5}, {116, 83, 18}, {127, 359, 4}, {10, 1, 5}}};

/// The indices of the hours that are day.
Numbers dayHours(const dat::GameTime& time) {
    Numbers hours;
    for (std::size_t i = 0; i < time.timesOfDay.size(); ++i)
        if (time.timesOfDay[i].isNight == 0)
            hours.push_back(static_cast<double>(i));
    return hours;
}

void judgeFields(const Result<dat::Region>& region, Ledger& ledger) {
    const auto line = [&](const char* name, Numbers expected, auto&& read) {
        ledger.judgeRecord(region,
                           Fact{std::string("calendar.") + name, kCalendarSource, std::move(expected)},
                           [&](const dat::Region& r) { return Found(read(r.gameTime)); });
    };
    line("zeroTimeOfYear", {3600}, [](const dat::GameTime& t) { return Numbers{t.zeroTimeOfYear}; });
    line("dayLength", {7620}, [](const dat::GameTime& t) { return Numbers{t.dayLength}; });
    line("daysPerYear", {360},
         [](const dat::GameTime& t) { return Numbers{static_cast<double>(t.daysPerYear)}; });
    line("zeroYear", {10}, [](const dat::GameTime& t) { return Numbers{static_cast<double>(t.zeroYear)}; });
    line("hours", {16},
         [](const dat::GameTime& t) { return Numbers{static_cast<double>(t.timesOfDay.size())}; });
    line("dayHours", {4, 5, 6, 7, 8, 9, 10, 11}, dayHours);
    line("weekDays", {6},
         [](const dat::GameTime& t) { return Numbers{static_cast<double>(t.daysOfWeek.size())}; });
    line("yearSeconds", {2743200},
         [](const dat::GameTime& t) { return Numbers{double{t.dayLength} * t.daysPerYear}; });
}

} // namespace

void judgeCalendar(const dat::Archive& archive, Ledger& ledger) {
    const Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId);
    judgeFields(region, ledger);
    for (const DateFact& fact : kDates)
        ledger.judgeRecord(region,
                           Fact{fmt::format("calendar.date.{:.0f}", fact.ticks),
                                kCalendarSource,
                                {fact.year, fact.day, fact.fraction}}
                               .within(1e-6),
                           [&](const dat::Region& r) -> Found {
                               if (!(r.gameTime.dayLength > 0.0f) || r.gameTime.daysPerYear == 0)
                                   return std::nullopt;
                               const world::DateTime at = world::dateTimeOf(r.gameTime, fact.ticks);
                               return Numbers{static_cast<double>(at.date.year),
                                              static_cast<double>(at.date.dayOfYear), at.time};
                           });
    for (const GroupFact& fact : kGroups)
        ledger.judgeRecord(
            region,
            Fact{fmt::format("calendar.group.{}.{}", fact.year, fact.day), kCalendarSource, {fact.group}},
            [&](const dat::Region& r) -> Found {
                if (r.sky.dayGroups.empty())
                    return std::nullopt;
                return Numbers{static_cast<double>(
                    world::dayGroupOn({fact.year, fact.day}, r.gameTime, r.sky.dayGroups.size()))};
            });
}

} // namespace limen::doctor
