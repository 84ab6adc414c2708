#include "cli/Parse.h"

#include <charconv>
#include <fmt/format.h>

namespace limen::cli {
namespace {

Failure bad(std::string_view option, std::string_view text, std::string_view wanted) {
    constexpr std::size_t kShown = 60; // keeps a message on one readable line
    std::string shown(text.substr(0, kShown));
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < 0x20)
            c = '?';
    if (text.size() > kShown)
        shown += "...";
    return fail(ErrorCode::BadArgument, std::string(option), fmt::format("'{}' is not {}", shown, wanted));
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Reads hexadecimal digits after an optional "0x". Returns false on any other text.
bool readHex(std::string_view text, std::size_t maxDigits, std::uint32_t& value) {
    if (text.starts_with("0x") || text.starts_with("0X"))
        text.remove_prefix(2);
    if (text.empty() || text.size() > maxDigits)
        return false;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    return error == std::errc{} && end == text.data() + text.size();
}

} // namespace

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

Result<double> parseNumber(std::string_view option, std::string_view text) {
    std::string_view digits = trimmed(text);
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-')
        digits.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::result_out_of_range)
        return bad(option, text, "a number that fits a double; give a smaller one");
    if (error != std::errc{} || end != digits.data() + digits.size())
        return bad(option, text, "a number such as 1.5");
    if (!std::isfinite(value))
        return bad(option, text, "a finite number such as 1.5");
    return value;
}

Result<double> parseNumberBetween(std::string_view option, std::string_view text, double low, double high) {
    Result<double> number = parseNumber(option, text);
    if (number && !(*number >= low && *number <= high))
        return bad(option, text, fmt::format("between {} and {}", low, high));
    return number;
}

Result<std::optional<double>> parseNumberOrAuto(std::string_view option, std::string_view text, double low,
                                                double high) {
    if (text == "auto")
        return std::optional<double>();
    const Result<double> number = parseNumberBetween(option, text, low, high);
    if (!number)
        return bad(option, text, fmt::format("auto or a number from {} to {}", low, high));
    return std::optional(*number);
}

Result<Vec3> parseVec3(std::string_view option, std::string_view text) {
    Vec3 value{0.0};
    std::string_view rest = text;
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (i == 2))
            return bad(option, text, "three numbers X,Y,Z such as 1,2.5,-3");
        const Result<double> number = parseNumber(option, rest.substr(0, comma));
        if (!number)
            return Failure(number.error());
        value[i] = *number;
        rest = i == 2 ? std::string_view{} : rest.substr(comma + 1);
    }
    return value;
}

Result<engine::PixelSize> parseSize(std::string_view option, std::string_view text) {
    const std::string_view clean = trimmed(text);
    const char* const end = clean.data() + clean.size();
    engine::PixelSize size{0, 0};
    const auto width = std::from_chars(clean.data(), end, size.width);
    const bool hasCross = width.ec != std::errc::invalid_argument && width.ptr != end &&
                          (*width.ptr == 'x' || *width.ptr == 'X');
    if (!hasCross)
        return bad(option, text, "a size WxH in pixels such as 640x360");
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec == std::errc::invalid_argument || height.ptr != end)
        return bad(option, text, "a size WxH in pixels such as 640x360");
    const bool overflow = width.ec != std::errc{} || height.ec != std::errc{};
    if (overflow || size.width == 0 || size.height == 0 || size.width > engine::kMaxSide ||
        size.height > engine::kMaxSide)
        return bad(option, text, fmt::format("between 1x1 and {0}x{0} pixels", engine::kMaxSide));
    return size;
}

Result<engine::RootChoice> parseRoot(std::string_view option, std::string_view text) {
    const std::string_view clean = trimmed(text);
    if (clean == "auto")
        return engine::RootChoice{};
    if (clean == "outside")
        return engine::RootChoice{engine::RootChoice::Rule::Outside, 0};
    std::uint32_t cell = 0;
    const bool hex = readHex(clean, 8, cell);
    const std::uint32_t low = cell & 0xFFFFu;
    if (!hex || low < dat::kFirstCell || low > dat::kLastCell)
        return bad(option, text, "auto, outside or a cell id such as 0xA9B40105");
    return engine::RootChoice{engine::RootChoice::Rule::Cell, cell};
}

Result<engine::Look> parseLook(std::string_view option, std::string_view text) {
    if (const std::optional<engine::Look> look = world::lookNamed(trimmed(text)))
        return *look;
    return bad(option, text, "retail or enhanced");
}

Result<engine::Weather> parseWeather(std::string_view option, std::string_view text) {
    if (trimmed(text) == "clear")
        return engine::Weather::Clear;
    if (trimmed(text) == "rain")
        return engine::Weather::Rain;
    return bad(option, text, "clear or rain");
}

Result<world::Date> parseDate(std::string_view option, std::string_view text) {
    if (const std::optional<world::Date> date = world::dateNamed(text))
        return *date;
    return bad(option, text, "a date, e.g. 116-3-24 or 'Seedsow 24, 116'");
}

Result<std::optional<double>> parseDoors(std::string_view option, std::string_view text) {
    const std::string_view word = trimmed(text);
    if (word == "rest")
        return std::optional<double>{};
    if (word == "closed" || word == "half" || word == "open")
        return std::optional(word == "closed" ? 0.0 : word == "half" ? 0.5 : 1.0);
    const Result<double> share = parseNumberBetween(option, text, 0.0, 1.0);
    if (!share)
        return bad(option, text, "rest, closed, half, open or a number from 0 to 1");
    return std::optional(*share);
}

Result<dat::RecordId> parseRecordId(std::string_view option, std::string_view text) {
    std::uint32_t id = 0;
    if (!readHex(trimmed(text), 8, id))
        return bad(option, text, "a record id in hexadecimal such as 0x01000001");
    return id;
}

Result<std::vector<std::string>> splitArguments(std::string_view line) {
    std::vector<std::string> arguments;
    std::string current;
    bool inWord = false;
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '\\' && quote != '\'' && i + 1 < line.size()) {
            current += line[++i];
            inWord = true;
        } else if (quote != 0) {
            if (c == quote)
                quote = 0;
            else
                current += c;
        } else if (c == '"' || c == '\'') {
            quote = c;
            inWord = true;
        } else if (!isBlank(c)) {
            current += c;
            inWord = true;
        } else if (inWord) {
            arguments.push_back(std::move(current));
            current.clear();
            inWord = false;
        }
    }
    if (quote != 0)
        return bad("line", line, "complete: a quote is not closed");
    if (inWord)
        arguments.push_back(std::move(current));
    return arguments;
}

} // namespace limen::cli
