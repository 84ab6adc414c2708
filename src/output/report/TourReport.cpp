#include "output/report/TourReport.h"

#include "core/NumberText.h"
#include "output/report/Assets.h"
#include "output/report/GraphLayout.h"
#include "output/report/ReportJson.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numeric>

namespace limen::output {
namespace {

using PageValue = nlohmann::ordered_json;

PageValue plotsValue(const std::vector<ReportPlot>& plots) {
    PageValue list = PageValue::array();
    for (const ReportPlot& plot : plots) {
        PageValue series = PageValue::array();
        for (const ReportSeries& line : plot.series) {
            PageValue values = PageValue::array();
            for (const double value : line.values)
                values.push_back(shortNumber(value));
            series.push_back({{"name", line.name}, {"values", std::move(values)}});
        }
        list.push_back({{"title", plot.title}, {"unit", plot.unit}, {"series", std::move(series)}});
    }
    return list;
}

/// Positions on a map, y downwards. The outside has no position of its own: it begins in the middle.
std::vector<Vec2> mapPositions(const ReportGraph& graph) {
    Vec2 sum(0.0);
    double count = 0.0;
    for (const ReportGraph::Node& node : graph.nodes)
        if (!node.isOutside) {
            sum += Vec2(node.x, -node.y);
            count += 1.0;
        }
    std::vector<Vec2> positions;
    for (const ReportGraph::Node& node : graph.nodes)
        positions.push_back(node.isOutside ? sum / std::max(count, 1.0) : Vec2(node.x, -node.y));
    return positions;
}

PageValue graphValue(const ReportGraph& graph) {
    const std::vector<Vec2> positions = layOutGraph(mapPositions(graph), graph.edges);
    std::vector<std::uint32_t> framesOf(graph.nodes.size());
    PageValue frames = PageValue::array();
    for (const ReportGraph::Frame& frame : graph.frames) {
        for (const std::uint32_t node : frame.nodes)
            ++framesOf[node];
        frames.push_back({frame.root, frame.nodes, frame.edges});
    }
    PageValue nodes = PageValue::array();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i)
        nodes.push_back({{"name", graph.nodes[i].name},
                         {"x", shortNumber(positions[i].x)},
                         {"y", shortNumber(positions[i].y)},
                         {"frames", framesOf[i]},
                         {"outside", graph.nodes[i].isOutside}});
    return {{"nodes", std::move(nodes)}, {"edges", graph.edges}, {"frames", std::move(frames)}};
}

std::string figure(double value) {
    if (!std::isfinite(value))
        return "–";
    return value >= 1000.0 ? groupedText(static_cast<std::uint64_t>(std::llround(value)))
                           : fmt::format("{:.3g}", value);
}

/// Mean, median, 95th percentile and maximum of the finite values, as a row of the table.
PageValue summaryRow(const ReportPlot& plot, const ReportSeries& line) {
    std::vector<double> values = line.values;
    std::erase_if(values, [](double v) { return !std::isfinite(v); });
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
        return values.empty()
                   ? std::nan("")
                   : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    const double mean = values.empty() ? std::nan("")
                                       : std::accumulate(values.begin(), values.end(), 0.0) /
                                             static_cast<double>(values.size());
    return {{"group", plot.title},    {"name", line.name},         {"unit", plot.unit},
            {"mean", figure(mean)},   {"median", figure(at(0.5))}, {"high", figure(at(0.95))},
            {"most", figure(at(1.0))}};
}

template <class T, class Make>
PageValue listOf(const std::vector<T>& items, Make&& make) {
    PageValue list = PageValue::array();
    for (const T& item : items)
        list.push_back(make(item));
    return list;
}

PageValue scriptValue(const TourReport& report) {
    return {{"numbers", report.numbers},
            {"commands", report.commands},
            {"fps", shortNumber(report.framesPerSecond)},
            {"pictureFrames", report.pictureFrames},
            {"plots", plotsValue(report.plots)},
            {"graph", graphValue(report.graph)}};
}

std::string verdictOf(const TourReport& report) {
    if (!report.findings.empty())
        return fmt::format("{} finding{}", report.findings.size(), report.findings.size() == 1 ? "" : "s");
    return "No finding";
}

} // namespace

std::string tourPage(const TourReport& report) {
    PageValue values = headValues(report.head, {"Tour", "tour", "film"});
    values["verdict"] = verdictOf(report);
    values["bad"] = !report.findings.empty();
    values["frames"] = groupedText(report.framesDrawn);
    values["recorded"] = groupedText(report.numbers.size());
    values["last"] = report.numbers.empty() ? 0 : report.numbers.size() - 1;
    values["spaces"] = groupedText(report.graph.nodes.size());
    values["openings"] = groupedText(report.graph.edges.size());
    PageValue pictures = PageValue::array();
    for (std::size_t i = 0; i < report.pictures.size(); ++i) {
        PageValue picture = pictureValues(report.pictures[i]);
        picture["index"] = report.pictureFrames[i];
        picture["number"] = report.numbers[report.pictureFrames[i]];
        pictures.push_back(std::move(picture));
    }
    values["first"] = pictures.empty() ? PageValue(nullptr) : pictures.front();
    values["pictures"] = std::move(pictures);
    values["plots"] = PageValue::array();
    values["rows"] = PageValue::array();
    for (std::size_t i = 0; i < report.plots.size(); ++i) {
        const ReportPlot& plot = report.plots[i];
        values["plots"].push_back(
            {{"index", i}, {"title", plot.title}, {"unit", plot.unit}, {"note", plot.note}});
        for (const ReportSeries& line : plot.series)
            values["rows"].push_back(summaryRow(plot, line));
    }
    values["findings"] = listOf(report.findings, findingValues);
    values["highlights"] = listOf(report.highlights, findingValues);
    values["data"] = scriptJson(scriptValue(report));
    values["script"] =
        std::string(assets::kPlotJs) + std::string(assets::kGraphJs) + std::string(assets::kTourJs);
    return pageOf(assets::kTourHtml, values);
}

} // namespace limen::output
