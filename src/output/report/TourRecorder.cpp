#include "output/report/TourRecorder.h"

#include "engine/CheckView.h"
#include "output/Encode.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace limen::output {
namespace {

constexpr std::size_t kMostRecorded = 2000, kMostPictures = 120, kMostFaults = 50;
constexpr std::uint32_t kPictureWidth = 640; ///< pixels
constexpr int kStripQuality = 78;

/// True for the frames of an even choice of at most `most` among `count`.
bool isChosen(std::size_t frame, std::size_t count, std::size_t most) {
    return count <= most || frame == 0 || frame * most / count != (frame - 1) * most / count;
}

double sumOf(const std::vector<engine::StageFigures>& stages) {
    double sum = 0.0;
    for (const engine::StageFigures& stage : stages)
        sum += stage.draws;
    return sum;
}

} // namespace

void TourRecorder::addFinding(std::string text) {
    report_.findings.push_back({std::move(text), {}, {}});
}

Result<void> TourRecorder::add(const engine::Session& session, const engine::FrameRequest& request,
                               std::size_t frame, const Picture& picture) {
    ++report_.framesDrawn;
    if (!isChosen(frame, frameCount_, kMostRecorded))
        return {};
    const std::string command =
        engine::reproduction(session.part().world, request, session.source().datOption);
    report_.numbers.push_back(frame);
    report_.commands.push_back(command);
    addFigures(session);
    addSpaces(session, request);
    addFaults(session, command);
    if (!isChosen(frame, frameCount_, kMostPictures))
        return {};
    const Picture small = shrunkToFit(picture, kPictureWidth, kPictureWidth);
    Result<std::vector<std::byte>> bytes = encodeWebp(small, kStripQuality);
    if (!bytes)
        return Failure(bytes.error());
    report_.pictures.push_back({fmt::format("Frame {}", frame), std::string(mediaTypeOf(PictureFormat::Webp)),
                                std::move(*bytes), small.width, small.height});
    report_.pictureFrames.push_back(report_.numbers.size() - 1);
    return {};
}

void TourRecorder::put(ReportPlot& plot, const std::string& name, double value) {
    auto line = std::find_if(plot.series.begin(), plot.series.end(),
                             [&](const ReportSeries& s) { return s.name == name; });
    if (line == plot.series.end())
        line = plot.series.insert(plot.series.end(), {name, {}});
    line->values.resize(report_.numbers.size() - 1, std::numeric_limits<double>::quiet_NaN());
    line->values.push_back(value);
}

void TourRecorder::addFigures(const engine::Session& session) {
    const engine::FrameFigures figures = session.figures();
    put(processor_, "flood", figures.floodMs);
    put(processor_, "plan", figures.planMs);
    for (const engine::StageFigures& stage : figures.stages) {
        put(processor_, stage.name, stage.cpuMs);
        if (std::isfinite(stage.gpuMs))
            put(graphics_, stage.name, stage.gpuMs);
    }
    put(visits_, "visits", static_cast<double>(session.visible().visits.size()));
    put(draws_, "draw commands", sumOf(figures.stages));
    put(draws_, "instances", session.plan().counts.instancesDrawn);
    put(draws_, "GL calls", figures.glCalls);
}

std::uint32_t TourRecorder::nodeOf(const world::World& world, std::uint32_t space) {
    const dat::RecordId cell = engine::cellOf(world, space);
    const auto [entry, isNew] =
        nodes_.try_emplace(cell, static_cast<std::uint32_t>(report_.graph.nodes.size()));
    if (isNew) {
        ReportGraph::Node node{engine::spaceName(world, space), 0.0, 0.0, space == world::kOutside};
        if (const Aabb& bounds = world.spaces[space].bounds; !bounds.empty() && !node.isOutside) {
            node.x = bounds.centre().x;
            node.y = bounds.centre().y;
        }
        report_.graph.nodes.push_back(std::move(node));
    }
    return entry->second;
}

void TourRecorder::addSpaces(const engine::Session& session, const engine::FrameRequest& request) {
    const world::World& world = session.part().world;
    std::map<std::uint32_t, std::uint32_t> seen; // space to node
    ReportGraph::Frame frame;
    const auto see = [&](std::uint32_t space) {
        if (space < world.spaces.size() && !seen.contains(space))
            seen[space] = nodeOf(world, space);
    };
    see(request.root);
    for (const visibility::SeenSpace& space : session.visible().seen)
        see(space.space);
    frame.root = request.root < world.spaces.size() ? seen[request.root] : 0;
    for (const auto& [space, node] : seen) {
        frame.nodes.push_back(node);
        const world::Space& from = world.spaces[space];
        for (std::uint32_t p = from.firstPortal; p < from.firstPortal + from.portalCount; ++p) {
            const auto to = seen.find(world.portals[p].destination);
            if (to == seen.end() || to->second == node)
                continue;
            const Edge edge = std::minmax(node, to->second);
            const auto [entry, isNew] =
                edges_.try_emplace(edge, static_cast<std::uint32_t>(report_.graph.edges.size()));
            if (isNew)
                report_.graph.edges.push_back(edge);
            frame.edges.push_back(entry->second);
        }
    }
    std::sort(frame.edges.begin(), frame.edges.end());
    frame.edges.erase(std::unique(frame.edges.begin(), frame.edges.end()), frame.edges.end());
    put(visits_, "spaces", static_cast<double>(seen.size()));
    report_.graph.frames.push_back(std::move(frame));
}

void TourRecorder::addFaults(const engine::Session& session, const std::string& command) {
    const visibility::FloodCounts& counts = session.visible().counts;
    const std::size_t index = report_.numbers.size() - 1, number = report_.numbers.back();
    const auto add = [&](const std::string& text) {
        if (report_.findings.size() < kMostFaults)
            report_.findings.push_back({text, command, index});
    };
    if (counts.visitsCut > 0)
        add(fmt::format("Frame {}: the limit on visits left out {} visits", number, counts.visitsCut));
    if (counts.cyclesLeft > 0)
        add(fmt::format("Frame {}: {} cycles of overlapping openings have no exact order", number,
                        counts.cyclesLeft));
    if (const std::string trouble = session.figures().trouble; !trouble.empty())
        add(fmt::format("Frame {}: {}", number, trouble));
}

void TourRecorder::addHighlight(const ReportPlot& plot, const char* text) {
    const std::size_t count = report_.numbers.size();
    std::size_t most = count;
    double highest = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        double sum = 0.0;
        for (const ReportSeries& line : plot.series)
            if (i < line.values.size() && std::isfinite(line.values[i]))
                sum += line.values[i];
        if (sum > highest) {
            highest = sum;
            most = i;
        }
    }
    if (most < count)
        report_.highlights.push_back(
            {fmt::format("Frame {}: {}", report_.numbers[most], fmt::format(fmt::runtime(text), highest)),
             report_.commands[most], most});
}

TourReport TourRecorder::finish(ReportHead head) && {
    addHighlight(processor_, "the most processor time, {:.3g} ms");
    addHighlight(graphics_, "the most graphics time, {:.3g} ms");
    ReportPlot onlyVisits = visits_, onlySpaces = visits_;
    std::erase_if(onlyVisits.series, [](const ReportSeries& s) { return s.name != "visits"; });
    std::erase_if(onlySpaces.series, [](const ReportSeries& s) { return s.name != "spaces"; });
    addHighlight(onlyVisits, "the most visits, {:.0f}");
    addHighlight(onlySpaces, "the most visible spaces, {:.0f}");
    for (ReportPlot* plot : {&processor_, &graphics_, &visits_, &draws_}) {
        for (ReportSeries& line : plot->series)
            line.values.resize(report_.numbers.size(), std::numeric_limits<double>::quiet_NaN());
        if (!plot->series.empty())
            report_.plots.push_back(std::move(*plot));
    }
    report_.head = std::move(head);
    return std::move(report_);
}

} // namespace limen::output
