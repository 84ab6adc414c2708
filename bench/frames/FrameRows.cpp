#include "frames/FrameRows.h"

#include "ViewTimes.h"

#include "core/Assert.h"

#include <fmt/format.h>
#include <limits>
#include <optional>

namespace limen::bench {

namespace {

constexpr double kMostForOwnership = 15.0; // percent

/// One of the two clocks.
struct Clock {
    const char* name;
    double FrameTime::*part;
};
constexpr Clock kClocks[] = {{"wall", &FrameTime::wall}, {"processor", &FrameTime::processor}};

std::optional<std::size_t> indexOf(const FrameTimes& times, const std::string& way) {
    const auto found = std::find(times.ways.begin(), times.ways.end(), way);
    if (found == times.ways.end())
        return {};
    return static_cast<std::size_t>(found - times.ways.begin());
}

/// Places that one row sums up.
using Places = std::vector<const PlaceTimes*>;

std::vector<double> timesOf(const Places& places, std::size_t way, const Clock& clock) {
    std::vector<double> values;
    for (const PlaceTimes* place : places)
        values.push_back(place->ways[way].*clock.part);
    return values;
}

/// Whether a way is compared with the frames of `renderer`.
bool isCompared(const std::string& way, const std::string& renderer) {
    return way != renderer && way.find(" without ownership") == std::string::npos &&
           (way.find(" without ") == std::string::npos || way.rfind(renderer + " without ", 0) == 0);
}

BenchRow rowOf(const FrameTimes& times, const std::string& renderer, const Places& places, const Clock& clock,
               std::optional<double> mostOfPeer) {
    const std::optional<std::size_t> own = indexOf(times, renderer);
    LIMEN_ASSERT(own && !places.empty(), "the renderer drew the places");
    const std::vector<double> values = timesOf(places, *own, clock);
    BenchRow row;
    row.unit = "ms";
    row.value = meanOf(values);
    row.p95 = quantileOf(values, 0.95);
    for (std::size_t way = 0; way < times.ways.size(); ++way)
        if (isCompared(times.ways[way], renderer))
            row.against.emplace_back(times.ways[way], meanOf(timesOf(places, way, clock)));
    const std::optional<std::size_t> peer = indexOf(times, kPeerWay);
    row.hasTarget = peer && mostOfPeer;
    if (row.hasTarget)
        row.target = *mostOfPeer * meanOf(timesOf(places, *peer, clock));
    row.hash = times.hash;
    return row;
}

void addKindRows(const FrameTimes& times, const std::string& renderer, bool isFirst, bool inCells,
                 std::vector<BenchRow>& rows) {
    Places places;
    for (const PlaceTimes& place : times.places)
        if (place.isInCell == inCells)
            places.push_back(&place);
    if (places.empty())
        return;
    const char* kind = inCells ? "cells" : "outside";
    const double most = inCells ? kMostOfPeerInCells : kMostOfPeerOutside;
    for (const Clock& clock : kClocks) {
        rows.push_back(rowOf(times, renderer, places, clock, isFirst ? std::optional(most) : std::nullopt));
        rows.back().bench = fmt::format("frame/{}/{}/{}", renderer, kind, clock.name);
        rows.back().scene = fmt::format("{} way points {}", places.size(), inCells ? "in cells" : "outside");
    }
}

} // namespace

std::vector<BenchRow> rowsOf(const FrameTimes& times, std::span<const LimenRenderer> renderers) {
    std::vector<BenchRow> rows;
    for (const LimenRenderer& renderer : renderers)
        for (const bool inCells : {true, false})
            addKindRows(times, renderer.name, &renderer == renderers.data(), inCells, rows);
    for (std::size_t i = 0; i < times.places.size(); ++i) {
        for (const Clock& clock : kClocks) {
            rows.push_back(
                rowOf(times, renderers.front().name, {&times.places[i]}, clock, kMostOfPeerAtAPlace));
            rows.back().bench = fmt::format("frame/places/{}/{}", i, clock.name);
            rows.back().scene = times.places[i].scene;
        }
    }
    return rows;
}

BenchRow ownershipRow(const FrameTimes& times, const std::string& renderer) {
    BenchRow row;
    row.bench = "frame/ownership";
    row.scene = fmt::format("{} places, {}, processor time", times.places.size(), renderer);
    row.unit = "%";
    row.hasTarget = true;
    row.target = kMostForOwnership;
    const std::optional<std::size_t> whole = indexOf(times, renderer),
                                     without = indexOf(times, wayName(renderer, Without::Ownership));
    double wholeSum = 0.0, withoutSum = 0.0;
    for (const PlaceTimes& place : times.places) {
        wholeSum += whole ? place.ways[*whole].processor : 0.0;
        withoutSum += without ? place.ways[*without].processor : 0.0;
    }
    row.value = row.p95 = wholeSum > 0.0 && withoutSum > 0.0 ? 100.0 * (wholeSum - withoutSum) / wholeSum
                                                             : std::numeric_limits<double>::quiet_NaN();
    return row;
}

} // namespace limen::bench
