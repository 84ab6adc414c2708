#include "output/report/CheckReport.h"

#include "core/NumberText.h"
#include "output/report/Assets.h"
#include "output/report/ReportJson.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::output {
namespace {

using CheckValue = nlohmann::ordered_json;

/// A verdict for people: "wrong ids" of "wrong_ids".
std::string readable(std::string_view name) {
    std::string text(name);
    for (char& c : text)
        if (c == '_')
            c = ' ';
    return text;
}

CheckValue rowOf(std::string_view name, const check::KindTotals& totals) {
    CheckValue cells = CheckValue::array();
    const auto add = [&cells](std::uint64_t count, bool isFault) {
        cells.push_back({{"count", groupedText(count)}, {"fault", isFault && count > 0}});
    };
    for (std::size_t i = 0; i < check::kVerdictCount; ++i)
        add(totals.counts[i], check::isFinding(static_cast<check::Verdict>(i)));
    add(totals.moved, true);
    return {{"name", name},
            {"views", groupedText(totals.views)},
            {"pixels", groupedText(totals.pixels)},
            {"cells", std::move(cells)}};
}

std::string causesText(const CheckedView& view) {
    std::string text;
    const auto add = [&text](std::uint64_t count, const std::string& name) {
        if (count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", groupedText(count), name);
    };
    for (std::size_t i = 0; i < check::kVerdictCount; ++i)
        if (check::isFinding(static_cast<check::Verdict>(i)))
            add(view.counts[i], readable(check::kVerdictNames[i]));
    add(view.moved, "moved");
    return text;
}

CheckValue viewValues(const CheckedView& view) {
    CheckValue pictures = CheckValue::array();
    for (const ReportPicture& picture : view.pictures)
        pictures.push_back(pictureValues(picture));
    return {{"number", view.number},   {"kind", view.kind},          {"about", view.about},
            {"command", view.command}, {"causes", causesText(view)}, {"pictures", std::move(pictures)}};
}

std::string verdictText(const check::Totals& totals) {
    const std::uint64_t wrong = totals.sum().findings();
    return wrong == 0
               ? "Every pixel is right"
               : fmt::format("{} wrong pixel{} in {} of {} views", groupedText(wrong), wrong == 1 ? "" : "s",
                             groupedText(totals.viewsWithFindings), groupedText(totals.sum().views));
}

} // namespace

std::string checkPage(const CheckReport& report) {
    const check::KindTotals all = report.totals.sum();
    CheckValue values = headValues(report.head, {"Check", "check", "findings"});
    values["verdict"] = verdictText(report.totals);
    values["bad"] = all.findings() > 0;
    addFact(values, "Views", groupedText(all.views));
    addFact(values, "Pixels", groupedText(all.pixels));
    addFact(values, "Hash of the pictures", fmt::format("{:016x}", report.totals.pictures), true);
    values["left_out"] = report.totals.blocksLeftOut > 0
                             ? fmt::format("{} landblocks could not be loaded and were skipped.",
                                           groupedText(report.totals.blocksLeftOut))
                             : "";
    values["columns"] = CheckValue::array();
    for (const std::string_view name : check::kVerdictNames)
        values["columns"].push_back(readable(name));
    values["columns"].push_back("moved");
    values["rows"] = CheckValue::array();
    for (std::size_t i = 0; i < check::kKindCount; ++i)
        if (report.totals.kinds[i].views > 0)
            values["rows"].push_back(rowOf(check::kKindNames[i], report.totals.kinds[i]));
    values["rows"].push_back(rowOf("all", all));
    values["findings"] = CheckValue::array();
    for (const CheckedView& view : report.findings)
        values["findings"].push_back(viewValues(view));
    values["more"] = report.totals.viewsWithFindings > report.findings.size()
                         ? fmt::format("{} further views with findings are not shown.",
                                       groupedText(report.totals.viewsWithFindings - report.findings.size()))
                         : "";
    values["samples"] = CheckValue::array();
    for (const CheckedView& view : report.samples)
        values["samples"].push_back(viewValues(view));
    return pageOf(assets::kCheckHtml, values);
}

} // namespace limen::output
