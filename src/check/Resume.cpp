#include "check/Report.h"

#include <cmath>

#include <nlohmann/json.hpp>

// The state of a stopped run as text.
namespace limen::check {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 5;

Json viewJson(const View& view) {
    return {{"kind", nameOf(view.kind)},
            {"eye", {view.eye.x, view.eye.y, view.eye.z}},
            {"yaw", view.yaw},
            {"pitch", view.pitch},
            {"fov", view.fov},
            {"size", {view.width, view.height}},
            {"root", view.root},
            {"about", view.about},
            {"seconds", view.seconds},
            {"doors", view.doors ? Json(*view.doors) : Json(nullptr)},
            {"day", view.dayGroup},
            {"rain", view.rain},
            {"look", world::nameOf(view.look)}};
}

View viewOf(const Json& json) {
    View view;
    view.kind = kindNamed(json.at("kind").get<std::string>()).value_or(ViewKind::Random);
    view.eye = {json.at("eye").at(0).get<double>(), json.at("eye").at(1).get<double>(),
                json.at("eye").at(2).get<double>()};
    view.yaw = json.at("yaw").get<double>();
    view.pitch = json.at("pitch").get<double>();
    view.fov = json.at("fov").get<double>();
    view.width = json.at("size").at(0).get<std::uint32_t>();
    view.height = json.at("size").at(1).get<std::uint32_t>();
    view.root = json.at("root").get<dat::RecordId>();
    view.about = json.at("about").get<std::string>();
    view.seconds = json.at("seconds").get<double>();
    if (const Json& doors = json.at("doors"); !doors.is_null())
        view.doors = doors.get<double>();
    view.dayGroup = json.at("day").get<std::uint32_t>();
    view.rain = json.at("rain").get<bool>();
    view.look = world::lookNamed(json.at("look").get<std::string>()).value_or(world::Look::Retail);
    return view;
}

Json totalsJson(const Totals& totals) {
    Json kinds = Json::array(), worst = Json::array();
    for (const KindTotals& kind : totals.kinds)
        kinds.push_back(
            {{"views", kind.views}, {"pixels", kind.pixels}, {"counts", kind.counts}, {"moved", kind.moved}});
    for (const Finding& finding : totals.worst)
        worst.push_back({{"view", viewJson(finding.view)},
                         {"count", finding.count},
                         {"number", finding.number},
                         {"counts", finding.counts},
                         {"moved", finding.moved}});
    return {{"kinds", std::move(kinds)},
            {"worst", std::move(worst)},
            {"views_with_findings", totals.viewsWithFindings},
            {"blocks_left_out", totals.blocksLeftOut},
            {"pictures", totals.pictures},
            {"draw_seconds", totals.drawSeconds},
            {"trace_seconds", totals.traceSeconds},
            {"seconds", totals.seconds}};
}

using Counts = std::array<std::uint64_t, kVerdictCount>;

Totals totalsOf(const Json& json) {
    Totals totals;
    for (std::size_t i = 0; i < kKindCount; ++i) {
        const Json& kind = json.at("kinds").at(i);
        totals.kinds[i] = {kind.at("views").get<std::uint64_t>(), kind.at("pixels").get<std::uint64_t>(),
                           kind.at("counts").get<Counts>(), kind.at("moved").get<std::uint64_t>()};
    }
    for (const Json& finding : json.at("worst"))
        totals.worst.push_back({viewOf(finding.at("view")), finding.at("count").get<std::uint64_t>(),
                                finding.at("number").get<std::uint64_t>(), finding.at("counts").get<Counts>(),
                                finding.at("moved").get<std::uint64_t>()});
    totals.viewsWithFindings = json.at("views_with_findings").get<std::uint64_t>();
    totals.blocksLeftOut = json.at("blocks_left_out").get<std::uint64_t>();
    totals.pictures = json.at("pictures").get<std::uint64_t>();
    totals.drawSeconds = json.at("draw_seconds").get<double>();
    totals.traceSeconds = json.at("trace_seconds").get<double>();
    totals.seconds = json.at("seconds").get<double>();
    return totals;
}

} // namespace

std::string progressJson(const Progress& progress) {
    const Json json{{"limen_check", kVersion},
                    {"run", progress.run},
                    {"tasks", progress.tasks},
                    {"views", progress.views},
                    {"totals", totalsJson(progress.totals)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Progress> parseProgress(const std::string& text) {
    try {
        const Json json = Json::parse(text);
        if (json.at("limen_check").get<int>() != kVersion)
            return fail(ErrorCode::Unsupported, "", "was written by another version of limen check");
        return Progress{json.at("run").get<std::string>(), json.at("tasks").get<std::uint64_t>(),
                        json.at("views").get<std::uint64_t>(), totalsOf(json.at("totals"))};
    } catch (const Json::exception&) {
        return fail(ErrorCode::Malformed, "",
                    "is not the state of a limen check run; name another file with --resume");
    }
}

} // namespace limen::check
