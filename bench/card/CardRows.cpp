#include "card/CardRows.h"

#include "ViewTimes.h"

#include "core/Assert.h"

#include <algorithm>
#include <fmt/format.h>

namespace limen::bench {

namespace {

constexpr PictureSize kTargetSize{2560, 1440};

BenchRow rowOf(const CardTimes& times, const std::string& scene, const std::vector<double>& values,
               double value) {
    BenchRow row;
    row.bench = fmt::format("card/{}/{}x{}", times.way, times.width, times.height);
    row.scene = scene;
    row.value = value;
    row.p95 = quantileOf(values, 0.95);
    row.unit = "ms";
    row.hash = times.hash;
    return row;
}

void addRows(const CardTimes& times, std::vector<BenchRow>& rows) {
    LIMEN_ASSERT(!times.places.empty(), "a card draws places");
    std::vector<double> frames;
    for (const CardTime& time : times.places)
        frames.push_back(time.frame);
    const std::string places = fmt::format("{} places", frames.size());
    rows.push_back(
        rowOf(times, "the slowest of " + places, frames, *std::max_element(frames.begin(), frames.end())));
    rows.back().target = kMostOnCard;
    rows.back().hasTarget = times.way.rfind("fast", 0) == 0 && times.width == kTargetSize.width &&
                            times.height == kTargetSize.height;
    rows.push_back(rowOf(times, "mean of " + places, frames, meanOf(frames)));
    rows.back().bench += "/mean";
    for (std::size_t stage = 0; stage < frame::kStageCount; ++stage) {
        const char* name = frame::nameOf(static_cast<frame::StageKind>(stage));
        std::vector<double> values;
        for (const CardTime& time : times.places)
            values.push_back(time.stages[stage]);
        rows.push_back(
            rowOf(times, fmt::format("the stage {}, mean of {}", name, places), values, meanOf(values)));
        rows.back().bench += fmt::format("/{}", name);
    }
}

} // namespace

std::vector<BenchRow> cardRows(const std::vector<CardTimes>& times) {
    std::vector<BenchRow> rows;
    for (const CardTimes& each : times)
        addRows(each, rows);
    return rows;
}

} // namespace limen::bench
