#include "output/report/ReportJson.h"

#include "output/report/Assets.h"
#include "output/report/Escape.h"
#include "output/report/Template.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::output {

void addFact(nlohmann::ordered_json& values, std::string_view name, std::string_view value, bool isCode) {
    values["facts"].push_back({{"name", name}, {"value", value}, {"code", isCode}});
}

std::string pageOf(std::string_view body, const nlohmann::ordered_json& values) {
    return fillTemplate(std::string(assets::kHeadHtml).append(body), values);
}

nlohmann::ordered_json headValues(const ReportHead& head, const PageNames& names) {
    nlohmann::ordered_json values{{"title", names.title},
                                  {"page", names.page},
                                  {"skip", names.skip},
                                  {"world", head.world},
                                  {"facts", nlohmann::ordered_json::array()},
                                  {"style", assets::kStyleCss},
                                  {"common", assets::kCommonJs},
                                  {"command", head.command}};
    const auto add = [&values](const std::string& name, const std::string& value) {
        if (!value.empty())
            addFact(values, name, value);
    };
    add("World", head.world);
    for (const auto& [name, value] : head.facts)
        add(name, value);
    add("Driver", head.driver);
    add("Program", head.version);
    add("Made", head.made);
    return values;
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

} // namespace limen::output
