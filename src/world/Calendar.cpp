#include "world/Calendar.h"

#include "core/Assert.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace limen::world {
namespace {

constexpr std::array<std::string_view, kMonths> kMonthNames{
    "Morningthaw", "Solclaim", "Seedsow",   "Leafdawning", "Verdantine", "Thistledown",
    "Harvestgain", "Leafcull", "Frostfell", "Snowreap",    "Coldeve",    "Wintersebb"};
constexpr std::array<std::string_view, 8> kHourNames{"Darktide", "Foredawn", "Dawnsong", "Morntide",
                                                     "Midsong",  "Warmtide", "Evensong", "Gloaming"};

char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The number of the month that a word begins, from 0. No value: none, or several.
std::optional<std::uint32_t> monthNamed(std::string_view word) {
    std::optional<std::uint32_t> found;
    for (std::uint32_t month = 0; month < kMonths; ++month) {
        const std::string_view name = kMonthNames[month];
        const bool begins = word.size() >= 3 && word.size() <= name.size() &&
                            std::equal(word.begin(), word.end(), name.begin(),
                                       [](char a, char b) { return lowerCase(a) == lowerCase(b); });
        if (begins && found)
            return std::nullopt;
        found = begins ? std::make_optional(month) : found;
    }
    return found;
}

std::optional<std::uint32_t> numberOf(std::string_view word) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc() && end == word.data() + word.size();
    return isWhole ? std::make_optional(number) : std::nullopt;
}

/// The parts between any of the separators.
std::vector<std::string_view> wordsOf(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(separators), text.size());
        if (end > 0)
            words.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// `month` from 0, `day` from 1.
std::optional<Date> checkedDate(std::optional<std::uint32_t> year, std::optional<std::uint32_t> month,
                                std::optional<std::uint32_t> day) {
    constexpr std::uint32_t kMostYears = 100000; // its days have 32 bits
    if (!year || !month || !day || *year > kMostYears || *month >= kMonths || *day < 1 ||
        *day > kDaysPerMonth)
        return std::nullopt;
    return Date{*year, *month * kDaysPerMonth + *day - 1};
}

} // namespace

DateTime dateTimeOf(const dat::GameTime& calendar, double ticks) {
    LIMEN_ASSERT(std::isfinite(ticks) && ticks >= 0.0, "times of the game are not negative");
    const double length = calendar.dayLength > 0.0f ? double{calendar.dayLength} : 1.0;
    const double daysPerYear = std::max(calendar.daysPerYear, 1u);
    const double days = (calendar.zeroTimeOfYear + ticks) / length;
    const double day = std::floor(days);
    const double year = std::floor(day / daysPerYear);
    return {{calendar.zeroYear + static_cast<std::uint32_t>(year),
             static_cast<std::uint32_t>(day - year * daysPerYear)},
            days - day};
}

std::uint32_t dayGroupOn(const Date& date, const dat::GameTime& calendar, std::size_t dayGroups) {
    const std::uint32_t day = date.year * calendar.daysPerYear + date.dayOfYear; // modulo 2^32
    const std::uint32_t mixed = day * 0x6A42FDB2u - 0x7541E9AEu;
    const double share = double{static_cast<float>(mixed)} * 0x1p-32;
    const auto group = static_cast<std::uint32_t>(share * static_cast<double>(dayGroups));
    return group < dayGroups ? group : 0;
}

std::string dateText(const Date& date) {
    const std::uint32_t month = std::min(date.dayOfYear / kDaysPerMonth, kMonths - 1);
    return std::string(kMonthNames[month]) + " " +
           std::to_string(date.dayOfYear - month * kDaysPerMonth + 1) + ", " + std::to_string(date.year) +
           " P.Y.";
}

std::string hourName(const dat::GameTime& calendar, double time) {
    const double t = time - std::floor(time);
    const dat::TimeOfDay* hour = nullptr;
    for (const dat::TimeOfDay& each : calendar.timesOfDay)
        if (double{each.start} <= t && (hour == nullptr || each.start >= hour->start))
            hour = &each;
    if (hour != nullptr && !hour->name.empty())
        return hour->name;
    const auto half = static_cast<std::size_t>(std::clamp(t, 0.0, 1.0) * 2.0 * kHourNames.size());
    const std::size_t slot = std::min(half, 2 * kHourNames.size() - 1);
    return std::string(kHourNames[slot / 2]) + (slot % 2 == 1 ? "-and-Half" : "");
}

std::optional<Date> dateNamed(std::string_view text) {
    if (const auto numbers = wordsOf(text, "-"); numbers.size() == 3) {
        const std::optional<std::uint32_t> month = numberOf(numbers[1]);
        return checkedDate(numberOf(numbers[0]), month ? std::make_optional(*month - 1) : month,
                           numberOf(numbers[2]));
    }
    const auto words = wordsOf(text, " ,");
    if (words.size() != 3)
        return std::nullopt;
    return checkedDate(numberOf(words[2]), monthNamed(words[0]), numberOf(words[1]));
}

} // namespace limen::world
