#pragma once

#include "output/report/ReportHead.h"

#include <nlohmann/json_fwd.hpp>
#include <string_view>

// Parts of reports as values for templates and scripts.
namespace limen::output {

/// Names of a page, which is called "Limen check" and begins for keyboards at its section `skip`.
struct PageNames {
    std::string_view title, page, skip; ///< "Check", "check", "findings"
};
/// Head of a page: names, facts, and the embedded styles and common script.
[[nodiscard]] nlohmann::ordered_json headValues(const ReportHead& head, const PageNames& names);
/// Adds a fact below those of the head. `isCode`: the value is a hash or a command.
void addFact(nlohmann::ordered_json& values, std::string_view name, std::string_view value,
             bool isCode = false);
/// The page with this body, one of assets.
[[nodiscard]] std::string pageOf(std::string_view body, const nlohmann::ordered_json& values);
[[nodiscard]] nlohmann::ordered_json findingValues(const ReportFinding& finding);
[[nodiscard]] nlohmann::ordered_json pictureValues(const ReportPicture& picture);
/// A number with at most four decimals; null if it is not finite.
[[nodiscard]] nlohmann::ordered_json shortNumber(double value);
/// JSON for a script element. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string scriptJson(const nlohmann::ordered_json& value);

} // namespace limen::output
