#pragma once

#include "dat/records/Landscape.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// Dates of the game (docs/formats/sky_weather.md#calendar). Months have 30 days.
namespace limen::world {

inline constexpr std::uint32_t kDaysPerMonth = 30;
inline constexpr std::uint32_t kMonths = 12;

struct Date {
    std::uint32_t year = 10;
    std::uint32_t dayOfYear = 1; ///< from 0; by default a sunny day in the retail files
    friend bool operator==(const Date&, const Date&) = default;
};

/// A time of the game: its date, and the fraction of the day.
struct DateTime {
    Date date;
    double time = 0.5;
};
/// Requires finite `ticks` >= 0.
[[nodiscard]] DateTime dateTimeOf(const dat::GameTime& calendar, double ticks);

/// The kind of day that rules a date: an index of SkyDesc::dayGroups, 0 without any.
[[nodiscard]] std::uint32_t dayGroupOn(const Date& date, const dat::GameTime& calendar,
                                       std::size_t dayGroups);

/// "Seedsow 24, 116 P.Y.".
[[nodiscard]] std::string dateText(const Date& date);
/// The hour at a fraction of the day, "Midsong-and-Half": the Region's name if it has one.
[[nodiscard]] std::string hourName(const dat::GameTime& calendar, double time);

/// Reads "116-3-24" and "Seedsow 24, 116", with or without a comma, ignoring case. No value: it is no date.
[[nodiscard]] std::optional<Date> dateNamed(std::string_view text);

} // namespace limen::world
