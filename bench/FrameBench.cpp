#include "FrameBench.h"

#include "BuiltInFiles.h"
#include "DrawnPart.h"
#include "HeadlessDriver.h"
#include "Stopwatch.h"
#include "ViewTimes.h"
#include "frames/FrameRows.h"
#include "peer/Peer.h"
#include "plain/PlainWay.h"

#include "core/Hash.h"
#include "gpu/device/NullDevice.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <span>

namespace limen::bench {

namespace {

constexpr int kCpuRepeats = 3;
constexpr std::size_t kDriverPlaces = 8; // of each kind

constexpr double kMostCpu = 500.0; // microseconds

/// Microseconds of processor time by way point, medians over the repeats.
struct CpuTimes {
    std::vector<double> flooded, all;
    std::vector<bool> indoors;     ///< by way point: the eye is in a cell
    std::uint64_t allocations = 0; ///< of one repeat after the warm-up
    Hash hash;                     ///< of the instances drawn
};

double medianOf(std::vector<double>& values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Result<double> cpuMicroseconds(DrawnPart& part, const frame::FrameView& view, Without without,
                               AllocationCounter counter, std::uint64_t& allocations) {
    std::vector<double> repeats;
    for (int i = 0; i < 2 + kCpuRepeats; ++i) { // two to warm up
        const std::uint64_t before = counter ? counter() : 0;
        const double start = threadSeconds();
        if (Result<void> drawn = drawFrame(part, view, without); !drawn)
            return Failure(drawn.error());
        const double seconds = threadSeconds() - start;
        allocations = counter ? counter() - before : 0;
        if (i >= 2)
            repeats.push_back(seconds * 1e6);
    }
    return medianOf(repeats);
}

Result<CpuTimes> timeOnNullDevice(const BuiltInFiles& files, AllocationCounter counter) {
    CpuTimes times;
    gpu::NullDevice device;
    PartOfTour tour(*files.archive, files.world, device, kFrameWidth, kFrameHeight);
    for (const world::Place& place : files.world.tour) {
        const Result<DrawnPart*> part = tour.at(place);
        if (!part)
            return Failure(part.error());
        const frame::FrameView view = (*part)->viewFrom(place);
        std::uint64_t allocations = 0, ignored = 0;
        const Result<double> all = cpuMicroseconds(**part, view, Without::Visibility, nullptr, ignored);
        const Result<double> flooded = cpuMicroseconds(**part, view, Without::Nothing, counter, allocations);
        if (!all || !flooded)
            return Failure((all ? flooded : all).error());
        times.indoors.push_back(view.view.root != world::kOutside);
        times.all.push_back(*all);
        times.flooded.push_back(*flooded);
        times.allocations += allocations;
        times.hash.add((*part)->plan().counts.instancesDrawn);
        times.hash.add((*part)->plan().visits.size());
    }
    return times;
}

BenchRow cpuRow(const BuiltInFiles& files, const Result<CpuTimes>& times) {
    BenchRow row{"frame/cpu", fmt::format("the tour, {} way points, null device", files.world.tour.size()),
                 kNotMeasured, kNotMeasured, "us"};
    row.target = kMostCpu;
    row.hasTarget = true;
    if (!times) {
        row.scene = times.error().message();
        return row;
    }
    row.value = quantileOf(times->flooded, 0.5);
    row.p95 = quantileOf(times->flooded, 0.95);
    row.against = {{"without visibility", quantileOf(times->all, 0.5)}};
    row.allocations = times->allocations;
    row.hash = times->hash.value();
    return row;
}

/// Way points of one kind (indoors or not), chosen evenly along the tour.
std::vector<world::Place> someOf(std::span<const world::Place> tour, const std::vector<bool>& isIndoors,
                                 bool indoors) {
    std::vector<world::Place> all;
    for (std::size_t i = 0; i < tour.size(); ++i)
        if (isIndoors[i] == indoors)
            all.push_back(tour[i]);
    return spreadEvenly(all, kDriverPlaces);
}

/// Every way of drawing, Limen's first.
Result<std::vector<std::unique_ptr<FrameWay>>> makeWays(const std::vector<LimenRenderer>& renderers,
                                                        const FrameEffort& effort) {
    Result<std::vector<std::unique_ptr<FrameWay>>> ways =
        makeLimenWays(renderers, effort.width, effort.height);
    for (const auto make : {&makePlainWay, &makePeerWay}) {
        if (!ways)
            return ways;
        Result<std::unique_ptr<FrameWay>> way = make(effort.width, effort.height);
        if (!way)
            return Failure(way.error());
        if (*way != nullptr)
            ways->push_back(std::move(*way));
    }
    return ways;
}

} // namespace

std::vector<BenchRow> compareFrames(const dat::Archive& archive, const world::WorldFile& file,
                                    const std::vector<world::Place>& places, const FrameEffort& effort) {
    const std::vector<LimenRenderer> renderers = limenRenderers();
    const Result<std::vector<std::unique_ptr<FrameWay>>> ways = makeWays(renderers, effort);
    if (!ways)
        return {failedRow("frame/places", ways.error().message(), "ms")};
    const Result<FrameTimes> times = timeFrames(archive, file, places, *ways, effort);
    if (!times)
        return {failedRow("frame/places", times.error().message(), "ms")};
    std::vector<BenchRow> rows = rowsOf(*times, renderers);
    for (const LimenRenderer& renderer : renderers)
        if (std::find(renderer.without.begin(), renderer.without.end(), Without::Ownership) !=
            renderer.without.end())
            rows.push_back(ownershipRow(*times, renderer.name));
    return rows;
}

std::vector<BenchRow> benchFrameWith(AllocationCounter counter, const std::string& pictures) {
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened) {
        BenchRow row{"frame/cpu", opened.error().message(), kNotMeasured, kNotMeasured, "us"};
        row.target = kMostCpu;
        row.hasTarget = true;
        return {row};
    }
    const Result<CpuTimes> cpu = timeOnNullDevice(files, counter);
    std::vector<BenchRow> rows{cpuRow(files, cpu)};
    if (!cpu || !openDriver())
        return rows;
    std::vector<world::Place> places = someOf(files.world.tour, cpu->indoors, true);
    const std::vector<world::Place> outside = someOf(files.world.tour, cpu->indoors, false);
    places.insert(places.end(), outside.begin(), outside.end());
    FrameEffort effort;
    effort.pictures = pictures;
    const std::vector<BenchRow> compared = compareFrames(*files.archive, files.world, places, effort);
    rows.insert(rows.end(), compared.begin(), compared.end());
    return rows;
}

std::vector<BenchRow> benchFrame(AllocationCounter counter) {
    return benchFrameWith(counter, {});
}

} // namespace limen::bench
