#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "frame/FrameView.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The notations of the command line, as pure functions. `option` is the name that a message puts first.
namespace limen::cli {

/// Width and height in pixels.
struct PixelSize {
    std::uint32_t width = 1280, height = 720;
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// The largest picture side that is drawn, in pixels.
inline constexpr std::uint32_t kMaxSide = 16384;

/// The space that a frame starts in, as the user names it.
struct RootChoice {
    enum class Kind { Auto, Outside, Cell } kind = Kind::Auto;
    dat::RecordId cell = 0; ///< of Kind::Cell
};

using frame::Weather;

/// A finite double in C notation; a leading '+' is allowed. Errors: anything else, trailing text, NaN,
/// infinity.
[[nodiscard]] Result<double> parseNumber(std::string_view option, std::string_view text);

/// The same, low..high both included. Errors: as parseNumber; beyond the bounds.
[[nodiscard]] Result<double> parseNumberBetween(std::string_view option, std::string_view text, double low,
                                                double high);

/// "X,Y,Z" with blanks allowed around the numbers. Errors: as parseNumber; not three numbers.
[[nodiscard]] Result<Vec3> parseVec3(std::string_view option, std::string_view text);

/// "WxH", 1..kMaxSide each way. Errors: anything else.
[[nodiscard]] Result<PixelSize> parseSize(std::string_view option, std::string_view text);

/// "auto", "outside" or a cell's id in hexadecimal ("0xA9B40105", low word 0x0100..0xFFFD). Errors: anything
/// else.
[[nodiscard]] Result<RootChoice> parseRoot(std::string_view option, std::string_view text);

/// "clear" or "rain".
[[nodiscard]] Result<Weather> parseWeather(std::string_view option, std::string_view text);

/// "rest" (none), "closed", "half", "open", or a share 0..1.
[[nodiscard]] Result<std::optional<double>> parseDoors(std::string_view option, std::string_view text);

/// A record id: one to eight hexadecimal digits, "0x" in front or not.
[[nodiscard]] Result<dat::RecordId> parseRecordId(std::string_view option, std::string_view text);

/// Splits a line into arguments as a shell would: blanks separate, single and double quotes group, a
/// backslash outside single quotes takes the next character as it is. Errors: an open quote.
[[nodiscard]] Result<std::vector<std::string>> splitArguments(std::string_view line);

/// The text without blanks at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// "0x%08X".
[[nodiscard]] std::string hexId(std::uint32_t id);

} // namespace limen::cli
