#include "cli/ReadingsArgument.h"

#include "cli/Choices.h"
#include "cli/Parse.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace limen::cli {
namespace {

constexpr const char* kOption = "--readings";

/// Short enough for a message on one line.
std::string shown(std::string_view text) {
    constexpr std::size_t kMost = 40;
    std::string result(text.substr(0, kMost));
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20; }, '?');
    return result + (text.size() > kMost ? "..." : "");
}

Failure refused(std::string what) {
    return fail(ErrorCode::BadArgument, kOption, std::move(what));
}

std::string valuesOf(const world::ReadingFacts& reading) {
    return reading.values.empty() ? fmt::format("a number from {} to {}", reading.low, reading.high)
                                  : fmt::format("{}", fmt::join(reading.values, ", "));
}

Result<void> take(std::string_view text, std::vector<std::string_view>& taken, world::Readings& readings) {
    const std::size_t sign = text.find('=');
    if (sign == std::string_view::npos)
        return refused(fmt::format("'{}' is not NAME=VALUE, such as sky-place=block", shown(text)));
    const std::string_view name = trimmed(text.substr(0, sign)), value = trimmed(text.substr(sign + 1));
    const std::vector<world::ReadingFacts> all = world::readingFacts();
    const auto reading =
        std::find_if(all.begin(), all.end(), [name](const auto& each) { return each.name == name; });
    if (reading == all.end()) {
        std::vector<std::string> names;
        for (const world::ReadingFacts& each : all)
            names.emplace_back(each.name);
        return refused(fmt::format("unknown reading '{}'{}", shown(name), suggestion(shown(name), names)));
    }
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
        return refused(fmt::format("{} is given twice; give it one value", name));
    if (!setReading(readings, name, value))
        return refused(
            fmt::format("'{}' is not a value of {}; choose from {}", shown(value), name, valuesOf(*reading)));
    taken.push_back(name);
    return {};
}

} // namespace

Result<world::Readings> parseReadings(std::string_view text) {
    world::Readings readings;
    std::vector<std::string_view> taken;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        if (Result<void> one = take(text.substr(begin, end - begin), taken, readings); !one)
            return Failure(one.error());
        begin = end + 1;
    }
    return readings;
}

std::string readingsNotation() {
    std::string text;
    for (const world::ReadingFacts& reading : world::readingFacts()) {
        text += fmt::format("{}{}=", text.empty() ? "" : ", ", reading.name);
        text += reading.values.empty() ? fmt::format("{}..{}", reading.low, reading.high)
                                       : fmt::format("{}", fmt::join(reading.values, "|"));
    }
    return text;
}

void addReadings(CLI::App& command, world::Readings& readings) {
    const auto fault = [](std::string& text) -> std::string {
        const Result<world::Readings> parsed = parseReadings(text);
        return parsed ? "" : parsed.error().what;
    };
    command
        .add_option_function<std::string>(
            kOption, [&readings](const std::string& text) { readings = *parseReadings(text); },
            "choose readings of open questions about the format, e.g. sky-place=block,cell-fog=none; names "
            "and "
            "values: " +
                readingsNotation() + " (the first of each, and the greatest number)")
        ->type_name("NAME=VALUE,...")
        ->check(CLI::Validator(fault, ""))
        ->group("World");
}

} // namespace limen::cli
