#include "SoakBench.h"

#include "BuiltInFiles.h"
#include "DrawnPart.h"
#include "HeadlessDriver.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace limen::bench {

namespace {

constexpr std::size_t kLaps = 8;
constexpr std::size_t kStep = 4; // every fourth way point is drawn
constexpr std::uint32_t kSmallWidth = 64, kSmallHeight = 36;
constexpr double kMostGrowth = 2.0; // percent
constexpr double kMiB = 1 << 20;

/// Resident memory of this program in bytes; 0 if the system does not report it.
double residentBytes() {
    std::ifstream in("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    in >> all >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Device objects at the end of a lap, and the largest memory during the lap.
struct Lap {
    gpu::DeviceObjects objects;
    double memory = 0.0; ///< bytes
    std::size_t frames = 0, loads = 0;
};

Result<Lap> walkOnce(const BuiltInFiles& files, gpu::Device& device) {
    Lap lap;
    std::unique_ptr<DrawnPart> part;
    std::optional<dat::BlockCoord> around;
    for (std::size_t i = 0; i < files.world.tour.size(); i += kStep) {
        const world::Place& place = files.world.tour[i];
        if (around != world::blockAt(place.eye)) {
            Result<std::unique_ptr<DrawnPart>> loaded = DrawnPart::around(
                *files.archive, files.world, place, device, kSmallWidth, kSmallHeight, {.radius = 1});
            if (!loaded)
                return Failure(loaded.error());
            part = std::move(*loaded); // the old part is freed after the new one is loaded, as in a session
            around = world::blockAt(place.eye);
            ++lap.loads;
        }
        const frame::FrameView view = part->viewFrom(place);
        part->move(view);
        part->flood(view);
        part->plan(view);
        if (Result<void> drawn = part->submit(); !drawn)
            return Failure(drawn.error());
        ++lap.frames;
        lap.memory = std::max(lap.memory, residentBytes());
    }
    lap.objects = device.objects();
    return lap;
}

BenchRow memoryRow(std::span<const Lap> laps, const std::string& driver) {
    std::vector<std::string> figures;
    for (const Lap& lap : laps)
        figures.push_back(fmt::format("{:.0f}", lap.memory / kMiB));
    BenchRow row{"soak/memory",
                 fmt::format("{} laps of {} frames and {} loads, MiB by lap: {}; {}", laps.size(),
                             laps[0].frames, laps[0].loads, fmt::join(figures, " "), driver),
                 kNotMeasured, kNotMeasured, "%"};
    const double early = std::max(laps[1].memory, laps[2].memory);
    const double late = std::max(laps[laps.size() - 2].memory, laps[laps.size() - 1].memory);
    row.value = row.p95 = 100.0 * (late / early - 1.0);
    row.target = kMostGrowth;
    row.hasTarget = true;
    return row;
}

BenchRow objectsRow(std::span<const Lap> laps) {
    const gpu::DeviceObjects& first = laps[0].objects;
    BenchRow row{
        "soak/objects",
        fmt::format("{} buffers of {:.0f} MiB, {} textures, {} handles, {} programs, ring of {:.1f} MiB",
                    first.buffers, static_cast<double>(first.bufferBytes) / kMiB, first.textures,
                    first.residentHandles, first.programs, static_cast<double>(first.ringBytes) / kMiB),
        kNotMeasured, kNotMeasured, "laps"};
    row.value = row.p95 = static_cast<double>(
        std::count_if(laps.begin(), laps.end(), [&](const Lap& lap) { return !(lap.objects == first); }));
    row.target = 0.0;
    row.hasTarget = true;
    return row;
}

} // namespace

std::vector<BenchRow> benchSoak(AllocationCounter) {
    const std::optional<HeadlessDriver> driver = openDriver();
    if (!driver)
        return {};
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened)
        return {failedRow("soak", opened.error().message(), "%")};
    std::vector<Lap> laps;
    for (std::size_t i = 0; i < kLaps; ++i) {
        const Result<Lap> lap = walkOnce(files, *driver->device);
        if (!lap)
            return {failedRow("soak", lap.error().message(), "%")};
        laps.push_back(*lap);
    }
    return {memoryRow(laps, driver->device->capabilities().renderer), objectsRow(laps)};
}

} // namespace limen::bench
