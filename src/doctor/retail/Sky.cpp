#include "doctor/retail/Judges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace limen::doctor {
namespace {

constexpr const char* kNotes = "published notes on the sky, counted over the region";
constexpr const char* kTest = "test of a public client against the files";
constexpr std::uint32_t kWeatherBit = 4;
constexpr dat::RecordId kStars = 0x010015EF;
using SkyNumbers = std::optional<Numbers>;

/// Calls `visit` with every sky object of every day group.
template <class Visit>
void forEachObject(const dat::SkyDesc& sky, Visit&& visit) {
    for (const dat::DayGroup& group : sky.dayGroups)
        for (const dat::SkyObject& object : group.objects)
            visit(object);
}
template <class Test>
double countObjects(const dat::SkyDesc& sky, Test&& test) {
    double count = 0;
    forEachObject(sky, [&](const dat::SkyObject& object) { count += test(object); });
    return count;
}

/// The indices of the day groups for which `test` holds.
template <class Test>
Numbers groupsWith(const dat::SkyDesc& sky, Test&& test) {
    Numbers groups;
    for (std::size_t i = 0; i < sky.dayGroups.size(); ++i)
        if (test(sky.dayGroups[i]))
            groups.push_back(static_cast<double>(i));
    return groups;
}

bool hasWeather(const dat::DayGroup& group) {
    return std::any_of(group.objects.begin(), group.objects.end(),
                       [](const dat::SkyObject& object) { return (object.properties & kWeatherBit) != 0; });
}

double misplacedReplacements(const dat::SkyDesc& sky) {
    double count = 0;
    for (const dat::DayGroup& group : sky.dayGroups)
        for (const dat::SkyTimeOfDay& time : group.times)
            for (std::size_t i = 0; i < time.replaces.size(); ++i)
                count += time.replaces[i].objectIndex != i;
    return count;
}

double unequalReplacements(const dat::SkyDesc& sky) {
    double count = 0;
    for (const dat::DayGroup& group : sky.dayGroups)
        for (const dat::SkyTimeOfDay& time : group.times)
            for (const dat::SkyObjectReplace& replace : time.replaces)
                count += replace.maxBright != replace.luminosity;
    return count;
}

double leastSun(const dat::SkyDesc& sky) {
    double least = 1e9;
    for (const dat::DayGroup& group : sky.dayGroups)
        for (const dat::SkyTimeOfDay& time : group.times)
            least = std::min<double>(least, time.dirBright);
    return least;
}

/// The ambient colour between the keyframes around a time, each channel mixed and cut to a byte.
SkyNumbers ambientAt(const dat::SkyDesc& sky, std::size_t index, double time) {
    if (index >= sky.dayGroups.size() || sky.dayGroups[index].times.empty())
        return std::nullopt;
    const std::vector<dat::SkyTimeOfDay>& times = sky.dayGroups[index].times;
    std::size_t from = times.size() - 1; // before the first keyframe, the last one of the day before
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i].begin <= time)
            from = i;
    const dat::SkyTimeOfDay &one = times[from], &other = times[(from + 1) % times.size()];
    double length = double{other.begin} - one.begin, passed = time - one.begin;
    if (length <= 0)
        length += 1;
    if (passed < 0)
        passed += 1;
    Numbers rgb;
    for (const unsigned shift : {16u, 8u, 0u}) {
        const double a = one.ambColour.argb >> shift & 0xFFu, b = other.ambColour.argb >> shift & 0xFFu;
        rgb.push_back(std::floor(a + (b - a) * passed / length));
    }
    return rgb;
}

void judgeObjects(const Result<dat::Region>& region, Ledger& ledger) {
    const auto line = [&](const std::string& name, Numbers expected, auto&& read) {
        ledger.judgeRecord(region, Fact{"sky." + name, kNotes, std::move(expected)},
                           [&](const dat::Region& r) -> SkyNumbers {
                               if (r.sky.dayGroups.empty())
                                   return std::nullopt;
                               return read(r.sky);
                           });
    };
    line("objects", {232},
         [](const dat::SkyDesc& s) { return Numbers{countObjects(s, [](auto&) { return 1; })}; });
    struct PropertyFact {
        std::uint32_t properties;
        double count;
    };
    for (const PropertyFact fact : {PropertyFact{0, 120}, {2, 20}, {4, 8}, {5, 8}, {13, 76}})
        line(fmt::format("objects.properties{}", fact.properties), {fact.count},
             [fact](const dat::SkyDesc& s) {
                 return Numbers{
                     countObjects(s, [&](const auto& o) { return o.properties == fact.properties; })};
             });
    line("objects.withScript", {96}, [](const dat::SkyDesc& s) {
        return Numbers{countObjects(s, [](const auto& o) { return o.script != 0; })};
    });
    line("objects.weather", {92}, [](const dat::SkyDesc& s) {
        return Numbers{countObjects(s, [](const auto& o) { return (o.properties & kWeatherBit) != 0; })};
    });
    line("weatherGroups", {3, 7, 9, 15, 16, 17, 18, 19},
         [](const dat::SkyDesc& s) { return groupsWith(s, hasWeather); });
    line("starGroups", {20}, [](const dat::SkyDesc& s) {
        return Numbers{static_cast<double>(groupsWith(s, [](const dat::DayGroup& group) {
                                               return std::any_of(
                                                   group.objects.begin(), group.objects.end(),
                                                   [](const auto& o) { return o.object == kStars; });
                                           }).size())};
    });
    line("replacements.notAtTheirIndex", {433},
         [](const dat::SkyDesc& s) { return Numbers{misplacedReplacements(s)}; });
    line("replacements.unequalBrightness", {0},
         [](const dat::SkyDesc& s) { return Numbers{unequalReplacements(s)}; });
}

} // namespace

void judgeSky(const dat::Archive& archive, Ledger& ledger) {
    const Result<dat::Region> region = archive.load<dat::Region>(dat::kRegionId);
    const auto line = [&](Fact fact, auto&& read) { ledger.judgeRecord(region, std::move(fact), read); };
    line({"sky.groups", kTest, {20}},
         [](const dat::Region& r) { return someNumbers({static_cast<double>(r.sky.dayGroups.size())}); });
    line({"sky.rainyGroups", kTest, {3, 7, 9, 15, 16, 17, 18, 19}}, [](const dat::Region& r) {
        return SkyNumbers(
            groupsWith(r.sky, [](const dat::DayGroup& group) { return group.name == "Rainy"; }));
    });
    line({"sky.group5IsSunny", kTest, {1}}, [](const dat::Region& r) -> SkyNumbers {
        if (r.sky.dayGroups.size() <= 5)
            return std::nullopt;
        return Numbers{r.sky.dayGroups[5].name == "Sunny" ? 1.0 : 0.0};
    });
    line(Fact{"sky.tick", kNotes, {0.8}}.within(1e-6),
         [](const dat::Region& r) { return someNumbers({r.sky.tickSize}); });
    line(Fact{"sky.lightTick", kNotes, {15}}.within(1e-6),
         [](const dat::Region& r) { return someNumbers({r.sky.lightTickSize}); });
    line(Fact{"sky.leastSun", kNotes, {0.1999}}.by(Rule::AtLeast), [](const dat::Region& r) -> SkyNumbers {
        if (r.sky.dayGroups.empty())
            return std::nullopt;
        return Numbers{leastSun(r.sky)};
    });
    constexpr double kTime = 0.1814;
    line(Fact{"sky.group5.ambient", kTest, {177, 177, 255}}.within(1),
         [](const dat::Region& r) { return ambientAt(r.sky, 5, kTime); });
    line(Fact{"sky.group15.ambient", kTest, {191, 134, 255}}.within(1),
         [](const dat::Region& r) { return ambientAt(r.sky, 15, kTime); });
    judgeObjects(region, ledger);
}

} // namespace limen::doctor
