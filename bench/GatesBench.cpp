#include "GatesBench.h"

#include "BuiltInFiles.h"
#include "HeadlessDriver.h"
#include "ViewTimes.h"

#include "engine/WorldSource.h"

#include <fmt/format.h>

namespace limen::bench {

namespace {

constexpr std::size_t kPlaces = 64;

struct Figure {
    const char* name;
    const char* unit;
    double (*of)(const GateFrame&);
};

constexpr std::array kFigures{
    Figure{"time", "ms", [](const GateFrame& frame) { return frame.milliseconds; }},
    Figure{"calls", "calls", [](const GateFrame& frame) { return static_cast<double>(frame.calls); }},
    Figure{"draws", "draws", [](const GateFrame& frame) { return static_cast<double>(frame.draws); }},
    Figure{"fragments", "thousands",
           [](const GateFrame& frame) { return 1e-3 * frame.fragments.value_or(kNotMeasured); }},
    Figure{"rectangles", "regions",
           [](const GateFrame& frame) { return static_cast<double>(frame.fallbacks); }},
};

/// By place.
std::vector<double> valuesOf(const GateFrames& frames, std::size_t gate, const Figure& figure) {
    std::vector<double> values;
    for (const auto& place : frames.places)
        values.push_back(figure.of(place[gate]));
    return values;
}

} // namespace

std::vector<BenchRow> gateRows(const GateFrames& frames, const std::string& way) {
    std::vector<BenchRow> rows;
    for (std::size_t g = 0; g < frame::kGates.size(); ++g) {
        for (const Figure& figure : kFigures) {
            const std::vector<double> values = valuesOf(frames, g, figure);
            BenchRow& row = rows.emplace_back();
            row.bench = fmt::format("gates/{}/{}/{}", way, nameOf(frame::kGates[g]), figure.name);
            row.scene = fmt::format("mean of {} places", values.size());
            row.value = meanOf(values);
            row.p95 = quantileOf(values, 0.95);
            row.unit = figure.unit;
            row.hash = frames.hashes[g];
            for (std::size_t other = 0; other < frame::kGates.size(); ++other)
                if (other != g)
                    row.against.emplace_back(std::string(nameOf(frame::kGates[other])),
                                             meanOf(valuesOf(frames, other, figure)));
        }
    }
    return rows;
}

namespace {

std::vector<BenchRow> benchBothWays(const dat::Archive& archive, const world::WorldFile& world) {
    const std::optional<HeadlessDriver> driver = openDriver();
    if (!driver)
        return {failedRow("gates", "no driver with OpenGL 4.5", "ms")};
    const std::vector<world::Place> places = spreadEvenly(world.tour, kPlaces);
    std::vector<BenchRow> rows;
    for (const gpu::Drawing drawing : {gpu::Drawing::Exact, gpu::Drawing::Fast}) {
        gpu::RendererOptions options;
        options.drawing = drawing;
        const Result<GateFrames> frames = timeGates(*driver->device, archive, world, places, options);
        if (!frames)
            return {failedRow("gates", frames.error().message(), "ms")};
        const std::vector<BenchRow> ofWay =
            gateRows(*frames, drawing == gpu::Drawing::Fast ? "fast" : "exact");
        rows.insert(rows.end(), ofWay.begin(), ofWay.end());
    }
    return rows;
}

} // namespace

std::vector<BenchRow> benchGates(AllocationCounter) {
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened)
        return {failedRow("gates", opened.error().message(), "ms")};
    return benchBothWays(*files.archive, files.world);
}

std::vector<BenchRow> benchGatesOver(const std::string& dat) {
    const Result<engine::WorldSource> source = engine::openWorldSource(dat);
    if (!source)
        return {failedRow("gates", source.error().message(), "ms")};
    if (source->file.tour.empty())
        return {failedRow("gates", dat + ": no tour leads through this world", "ms")};
    return benchBothWays(source->archive, source->file);
}

} // namespace limen::bench
