#pragma once

#include "output/report/ReportHead.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

// Parts of reports as values for templates and scripts.
namespace limen::output {

/// Head of a page: title, facts, and the embedded styles and common script.
[[nodiscard]] nlohmann::ordered_json headValues(const ReportHead& head, std::string_view title);
[[nodiscard]] nlohmann::ordered_json findingValues(const ReportFinding& finding);
[[nodiscard]] nlohmann::ordered_json pictureValues(const ReportPicture& picture);
/// A number with at most four decimals; null if it is not finite.
[[nodiscard]] nlohmann::ordered_json shortNumber(double value);
/// JSON for a script element. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string scriptJson(const nlohmann::ordered_json& value);
/// "12,345".
[[nodiscard]] std::string grouped(std::uint64_t number);

} // namespace limen::output
