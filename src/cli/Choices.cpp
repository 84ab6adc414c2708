#include "cli/Choices.h"

#include "cli/Parse.h"
#include "core/Nearest.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limen::cli {

std::string suggestion(std::string_view name, const std::vector<std::string>& candidates) {
    const std::vector<std::string> similar = nearest(name, candidates, 1);
    return similar.empty() ? fmt::format("; choose from {}", fmt::join(candidates, ", "))
                           : "." + didYouMean(similar);
}

CLI::Validator oneOf(std::vector<std::string> values) {
    return {[values = std::move(values)](std::string& text) -> std::string {
                if (std::find(values.begin(), values.end(), text) != values.end())
                    return {};
                return fmt::format("unknown value '{}'{}", text, suggestion(text, values));
            },
            ""};
}

CLI::Validator within(double low, double high) {
    return {[low, high](std::string& text) -> std::string {
                const Result<double> number = parseNumber("", text == "inf" ? "1e300" : text);
                if (number && *number >= low && *number <= high)
                    return {};
                return high > 1e300 ? fmt::format("'{}' is not a number from {} up, or inf", text, low)
                                    : fmt::format("'{}' is not a number from {} to {}", text, low, high);
            },
            ""};
}

CLI::Validator notEmpty() {
    return {[](std::string& text) -> std::string {
                return text.empty() ? "the value is empty; check for an unset variable" : "";
            },
            ""};
}

} // namespace limen::cli
