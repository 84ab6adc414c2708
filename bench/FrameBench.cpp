#include "FrameBench.h"

#include "BuiltInFiles.h"
#include "DrawnPart.h"
#include "HeadlessDriver.h"
#include "Stopwatch.h"
#include "ViewTimes.h"

#include "core/Hash.h"
#include "gpu/device/NullDevice.h"

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <limits>
#include <span>

namespace limen::bench {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t kWidth = 1280, kHeight = 720;
constexpr int kCpuRepeats = 3, kDriverRepeats = 3;
constexpr std::size_t kDriverPlaces = 8; // of each kind

constexpr double kMostCpu = 500.0; // microseconds
constexpr double kFasterIndoors = 3.0, kFasterInTown = 1.3;
constexpr double kMostForOwnership = 15.0; // percent

/// The step that is left out of a frame.
enum class Without { Nothing, Visibility, Ownership, Occlusion, VisibilityAndOcclusion };
constexpr std::size_t kWithouts = 5;

bool seesAll(Without without) {
    return without == Without::Visibility || without == Without::VisibilityAndOcclusion;
}

bool hidesNothing(Without without) {
    return without == Without::Occlusion || without == Without::VisibilityAndOcclusion;
}

/// One frame, from the dynamic state to the last GL call.
Result<void> drawFrame(DrawnPart& part, const frame::FrameView& view, Without without) {
    part.move(view);
    if (seesAll(without))
        part.takeAll(view);
    else
        part.flood(view);
    part.plan(view);
    if (without == Without::Ownership)
        part.leaveOutOwnership();
    return part.submit({.wantIds = false, .occlusion = !hidesNothing(without)});
}

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
            return tl::unexpected(drawn.error());
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
    PartOfTour tour(*files.archive, files.world, device, kWidth, kHeight);
    for (const world::Place& place : files.world.tour) {
        const Result<DrawnPart*> part = tour.at(place);
        if (!part)
            return tl::unexpected(part.error());
        const frame::FrameView view = (*part)->viewFrom(place);
        std::uint64_t allocations = 0, ignored = 0;
        const Result<double> all = cpuMicroseconds(**part, view, Without::Visibility, nullptr, ignored);
        const Result<double> flooded = cpuMicroseconds(**part, view, Without::Nothing, counter, allocations);
        if (!all || !flooded)
            return tl::unexpected((all ? flooded : all).error());
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
                 kNone, kNone, "us"};
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
    std::vector<world::Place> all, some;
    for (std::size_t i = 0; i < tour.size(); ++i)
        if (isIndoors[i] == indoors)
            all.push_back(tour[i]);
    for (std::size_t i = 0; i < kDriverPlaces && !all.empty(); ++i)
        some.push_back(all[i * all.size() / kDriverPlaces]);
    return some;
}

/// Milliseconds until the GPU has finished, by place, medians over the repeats.
struct DriverTimes {
    std::array<std::vector<double>, kWithouts> byWithout;
    Hash hash; ///< of the complete pictures

    [[nodiscard]] std::vector<double>& of(Without without) {
        return byWithout[static_cast<std::size_t>(without)];
    }
    [[nodiscard]] const std::vector<double>& of(Without without) const {
        return byWithout[static_cast<std::size_t>(without)];
    }
};

Result<double> finishedMilliseconds(DrawnPart& part, const frame::FrameView& view, Without without) {
    Result<void> drawn;
    glFinish();
    const double seconds = secondsOf([&] {
        drawn = drawFrame(part, view, without);
        glFinish();
    });
    return drawn.map([&] { return seconds * 1e3; });
}

Result<void> timePlace(DrawnPart& part, const world::Place& place, DriverTimes& times) {
    constexpr Without kKinds[kWithouts] = {Without::VisibilityAndOcclusion, Without::Visibility,
                                           Without::Occlusion, Without::Ownership, Without::Nothing};
    const frame::FrameView view = part.viewFrom(place);
    std::array<std::vector<double>, kWithouts> repeats;
    for (int i = 0; i < 1 + kDriverRepeats; ++i) { // one to warm up
        for (const Without without : kKinds) {     // in turn
            const Result<double> taken = finishedMilliseconds(part, view, without);
            if (!taken)
                return tl::unexpected(taken.error());
            if (i > 0)
                repeats[static_cast<std::size_t>(without)].push_back(*taken);
        }
    }
    for (const Without without : kKinds)
        times.of(without).push_back(medianOf(repeats[static_cast<std::size_t>(without)]));
    for (const std::uint8_t value : part.target().readColour())
        times.hash.add(value);
    return {};
}

Result<DriverTimes> timeOnDriver(const BuiltInFiles& files, gpu::Device& device,
                                 std::span<const world::Place> places) {
    DriverTimes times;
    PartOfTour tour(*files.archive, files.world, device, kWidth, kHeight);
    for (const world::Place& place : places) {
        Result<void> timed =
            tour.at(place).and_then([&](DrawnPart* part) { return timePlace(*part, place, times); });
        if (!timed)
            return tl::unexpected(timed.error());
    }
    return times;
}

BenchRow driverRow(const char* bench, const std::string& scene, const Result<DriverTimes>& times,
                   double faster) {
    BenchRow row{bench, scene, kNone, kNone, "ms"};
    row.hasTarget = true;
    row.target = kNone;
    if (!times || times->of(Without::Nothing).empty()) {
        row.scene += times ? ": there are none" : ": " + times.error().message();
        return row;
    }
    const double all = meanOf(times->of(Without::Visibility));
    row.value = meanOf(times->of(Without::Nothing));
    row.p95 = quantileOf(times->of(Without::Nothing), 0.95);
    row.against = {{"without visibility", all},
                   {"without occlusion", meanOf(times->of(Without::Occlusion))},
                   {"without either", meanOf(times->of(Without::VisibilityAndOcclusion))}};
    row.target = all / faster;
    row.hash = times->hash.value();
    return row;
}

BenchRow ownershipRow(const std::string& scene, std::span<const Result<DriverTimes>* const> kinds) {
    BenchRow row{"frame/ownership", scene, kNone, kNone, "%"};
    row.hasTarget = true;
    row.target = kMostForOwnership;
    double whole = 0.0, without = 0.0;
    for (const Result<DriverTimes>* times : kinds) {
        if (!*times || (*times)->of(Without::Nothing).empty())
            return row;
        whole += meanOf((*times)->of(Without::Nothing));
        without += meanOf((*times)->of(Without::Ownership));
    }
    row.value = row.p95 = 100.0 * (whole - without) / whole;
    return row;
}

void addDriverRows(const BuiltInFiles& files, const std::vector<bool>& isIndoors,
                   std::vector<BenchRow>& rows) {
    const std::optional<HeadlessDriver> driver = openDriver();
    if (!driver)
        return;
    const std::string name = driver->device->capabilities().renderer;
    const std::vector<world::Place> rooms = someOf(files.world.tour, isIndoors, true),
                                    streets = someOf(files.world.tour, isIndoors, false);
    const Result<DriverTimes> indoors = timeOnDriver(files, *driver->device, rooms),
                              town = timeOnDriver(files, *driver->device, streets);
    rows.push_back(driverRow("frame/indoors", fmt::format("{} way points in cells, {}", rooms.size(), name),
                             indoors, kFasterIndoors));
    rows.push_back(driverRow("frame/town", fmt::format("{} way points outside, {}", streets.size(), name),
                             town, kFasterInTown));
    const Result<DriverTimes>* const both[] = {&indoors, &town};
    rows.push_back(ownershipRow(fmt::format("these frames, {}", name), both));
}

} // namespace

std::vector<BenchRow> benchFrame(AllocationCounter counter) {
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened) {
        BenchRow row{"frame/cpu", opened.error().message(), kNone, kNone, "us"};
        row.target = kMostCpu;
        row.hasTarget = true;
        return {row};
    }
    const Result<CpuTimes> cpu = timeOnNullDevice(files, counter);
    std::vector<BenchRow> rows{cpuRow(files, cpu)};
    if (cpu)
        addDriverRows(files, cpu->indoors, rows);
    return rows;
}

} // namespace limen::bench
