#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace limen::output {

/// Fills a template from a JSON object, in a subset of the Mustache notation:
///   {{name}}              the value as text, escaped for HTML
///   {{{name}}}            the value as text, unchanged
///   {{#name}} … {{/name}} once for each item of an array; once for an object or for true; else not at all
///   {{^name}} … {{/name}} once for false, null, "" and an empty array
/// Names are looked up in the innermost section first. A list's plain item has the name ".". Requires a
/// template of this program: an unknown name or an open section fails an assertion.
[[nodiscard]] std::string fillTemplate(std::string_view text, const nlohmann::ordered_json& values);

} // namespace limen::output
