#include "check/Report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::check {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kWorstShown = 20;

Json categoriesOf(const KindTotals& totals) {
    Json json = Json::object();
    for (std::size_t i = 1; i < kVerdictCount; ++i)
        json[std::string(kVerdictNames[i])] = totals.counts[i];
    json["moved"] = totals.moved;
    return json;
}

Json worstJson(const Totals& totals, const std::string& worldOptions) {
    Json worst = Json::array();
    for (std::size_t i = 0; i < std::min(kWorstShown, totals.worst.size()); ++i) {
        const Finding& finding = totals.worst[i];
        worst.push_back({{"count", finding.count},
                         {"command", shotCommand(finding.view, worldOptions)},
                         {"number", finding.number},
                         {"kind", nameOf(finding.view.kind)},
                         {"about", finding.view.about},
                         {"pixels", categoriesOf({1, 0, finding.counts, finding.moved})}});
    }
    return worst;
}

/// Appends ", 3 wrong_ids" to a list, or "3 wrong_ids" to an empty one; nothing for a count of 0.
void addCause(std::uint64_t count, std::string_view name, std::string& list) {
    if (count > 0)
        list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, name);
}

/// "3 wrong_ids, 1 depth".
std::string causesOf(const Finding& finding) {
    std::string text;
    for (std::size_t i = 0; i < kVerdictCount; ++i)
        if (isFinding(static_cast<Verdict>(i)))
            addCause(finding.counts[i], kVerdictNames[i], text);
    addCause(finding.moved, "moved", text);
    return text;
}

/// The findings whose ids agree: ", 3 more are wrong (2 depth, 1 layers)"; empty if there are none.
std::string wrongBesideIds(const KindTotals& all) {
    std::string causes;
    for (const Verdict verdict : {Verdict::Depth, Verdict::Layers})
        addCause(all.count(verdict), kVerdictNames[static_cast<std::size_t>(verdict)], causes);
    addCause(all.moved, "moved", causes);
    const std::uint64_t more = all.findings() - all.disagreeing();
    return more == 0 ? "" : fmt::format(", {} more {} wrong ({})", more, more == 1 ? "is" : "are", causes);
}

double viewsPerSecond(const Totals& totals) {
    return totals.seconds > 0.0 ? static_cast<double>(totals.sum().views) / totals.seconds : 0.0;
}

} // namespace

std::string shotCommand(const View& view, const std::string& worldOptions) {
    return "limen shot" + worldOptions + " " + shotOptions(view) + " --ids ids.npy";
}

std::string reportJson(const Totals& totals, const ReportContext& context) {
    const KindTotals all = totals.sum();
    Json kinds = Json::object();
    for (std::size_t i = 0; i < kKindCount; ++i) {
        const KindTotals& kind = totals.kinds[i];
        if (kind.views == 0)
            continue;
        Json json{{"views", kind.views}, {"pixels", kind.pixels}, {"disagreeing_pixels", kind.disagreeing()}};
        json.update(categoriesOf(kind));
        kinds[std::string(kKindNames[i])] = std::move(json);
    }
    Json json{{"views", all.views},
              {"pixels", all.pixels},
              {"disagreeing_pixels", all.disagreeing()},
              {"void_pixels", all.count(Verdict::Void)},
              {"worst", worstJson(totals, context.worldOptions)},
              {"seed", context.seed},
              {"seconds", totals.seconds},
              {"views_with_findings", totals.viewsWithFindings},
              {"views_per_second", viewsPerSecond(totals)},
              {"draw_seconds", totals.drawSeconds},
              {"trace_seconds", totals.traceSeconds},
              {"blocks_left_out", totals.blocksLeftOut},
              {"pictures_hash", fmt::format("{:016x}", totals.pictures)}};
    json.update(categoriesOf(all));
    json["kinds"] = std::move(kinds);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string reportText(const Totals& totals, const ReportContext& context) {
    std::string text = fmt::format("{:<8} {:>7} {:>11}", "kind", "views", "pixels");
    for (std::size_t i = 1; i < kVerdictCount; ++i)
        text += fmt::format(" {:>9}", kVerdictNames[i]);
    text += fmt::format(" {:>9}\n", "moved");
    const auto line = [&](std::string_view name, const KindTotals& kind) {
        text += fmt::format("{:<8} {:>7} {:>11}", name, kind.views, kind.pixels);
        for (std::size_t i = 1; i < kVerdictCount; ++i)
            text += fmt::format(" {:>9}", kind.counts[i]);
        text += fmt::format(" {:>9}\n", kind.moved);
    };
    for (std::size_t i = 0; i < kKindCount; ++i)
        if (totals.kinds[i].views > 0)
            line(kKindNames[i], totals.kinds[i]);
    const KindTotals all = totals.sum();
    line("all", all);
    for (std::size_t i = 0; i < std::min(kWorstShown, totals.worst.size()); ++i) {
        const Finding& finding = totals.worst[i];
        text += fmt::format("{:>7} pixels ({}), {}{}{}: {}\n", finding.count, causesOf(finding),
                            nameOf(finding.view.kind), finding.view.about.empty() ? "" : ", ",
                            finding.view.about, shotCommand(finding.view, context.worldOptions));
    }
    text +=
        fmt::format("{} of {} pixels disagree ({} of them void){} in {} of {} views; {:.1f} views a second "
                    "({:.1f} s drawing, {:.1f} s tracing, side by side), seed {}, pictures {:016x}\n",
                    all.disagreeing(), all.pixels, all.count(Verdict::Void), wrongBesideIds(all),
                    totals.viewsWithFindings, all.views, viewsPerSecond(totals), totals.drawSeconds,
                    totals.traceSeconds, context.seed, totals.pictures);
    return text;
}

} // namespace limen::check
