#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "engine/ViewRequest.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The notations of the command line, as pure functions. Messages start with `option`.
namespace limen::cli {

/// A finite double in C notation; a leading '+' is allowed. Errors: anything else, trailing text, NaN,
/// infinity.
[[nodiscard]] Result<double> parseNumber(std::string_view option, std::string_view text);

/// A number within low..high, bounds included. Errors: as parseNumber; a number out of bounds.
[[nodiscard]] Result<double> parseNumberBetween(std::string_view option, std::string_view text, double low,
                                                double high);
/// The same, or `auto`: none.
[[nodiscard]] Result<std::optional<double>> parseNumberOrAuto(std::string_view option, std::string_view text,
                                                              double low, double high);

/// "X,Y,Z" with blanks allowed around the numbers. Errors: as parseNumber; not three numbers.
[[nodiscard]] Result<Vec3> parseVec3(std::string_view option, std::string_view text);

/// "WxH", 1..engine::kMaxSide each way. Errors: anything else.
[[nodiscard]] Result<engine::PixelSize> parseSize(std::string_view option, std::string_view text);

/// "auto", "outside" or a cell's id in hexadecimal ("0xA9B40105", low word 0x0100..0xFFFD). Errors: anything
/// else.
[[nodiscard]] Result<engine::RootChoice> parseRoot(std::string_view option, std::string_view text);

/// "clear" or "rain".
[[nodiscard]] Result<engine::Look> parseLook(std::string_view option, std::string_view text);
[[nodiscard]] Result<engine::Weather> parseWeather(std::string_view option, std::string_view text);

/// "116-3-24" or "Seedsow 24, 116".
[[nodiscard]] Result<world::Date> parseDate(std::string_view option, std::string_view text);

/// "rest" (none), "closed", "half", "open", or a share 0..1.
[[nodiscard]] Result<std::optional<double>> parseDoors(std::string_view option, std::string_view text);

/// A record id: one to eight hexadecimal digits after an optional "0x".
[[nodiscard]] Result<dat::RecordId> parseRecordId(std::string_view option, std::string_view text);

/// Splits a line into arguments like a shell: blanks separate, single and double quotes group, and a
/// backslash outside single quotes escapes the next character. Errors: an open quote.
[[nodiscard]] Result<std::vector<std::string>> splitArguments(std::string_view line);

/// The text without leading and trailing blanks.
[[nodiscard]] std::string_view trimmed(std::string_view text);

} // namespace limen::cli
