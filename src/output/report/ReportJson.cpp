#include "output/report/ReportJson.h"

#include "output/report/Assets.h"
#include "output/report/Escape.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::output {

nlohmann::ordered_json headValues(const ReportHead& head, std::string_view title) {
    nlohmann::ordered_json facts = nlohmann::ordered_json::array();
    const auto add = [&facts](const std::string& name, const std::string& value) {
        if (!value.empty())
            facts.push_back({{"name", name}, {"value", value}});
    };
    add("World", head.world);
    for (const auto& [name, value] : head.facts)
        add(name, value);
    add("Driver", head.driver);
    add("Program", head.version);
    add("Made", head.made);
    return {{"title", title},
            {"world", head.world},
            {"facts", std::move(facts)},
            {"style", assets::kStyleCss},
            {"common", assets::kCommonJs},
            {"command", head.command}};
}

nlohmann::ordered_json findingValues(const ReportFinding& finding) {
    nlohmann::ordered_json frame = nullptr;
    if (finding.frame)
        frame = {{"index", *finding.frame}};
    return {{"text", finding.text}, {"command", finding.command}, {"frame", std::move(frame)}};
}

nlohmann::ordered_json pictureValues(const ReportPicture& picture) {
    return {{"caption", picture.caption},
            {"uri", dataUri(picture.mediaType, picture.bytes)},
            {"width", picture.width},
            {"height", picture.height}};
}

nlohmann::ordered_json shortNumber(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(std::round(value * 1e4) / 1e4)
                                : nlohmann::ordered_json(nullptr);
}

std::string scriptJson(const nlohmann::ordered_json& value) {
    return escapeScriptJson(value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::string grouped(std::uint64_t number) {
    const std::string digits = fmt::format("{}", number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0)
            text += ',';
        text += digits[i];
    }
    return text;
}

} // namespace limen::output
