#include "DispatchBench.h"

#include "DispatchTimes.h"
#include "HeadlessDriver.h"
#include "ViewTimes.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace limen::bench {

namespace {

constexpr std::uint32_t kHeadings = 16;
constexpr std::uint32_t kDriverHeadings = 4, kDriverWidth = 320, kDriverHeight = 180;
constexpr int kDriverRepeats = 3;

struct FieldScene {
    const char* name;
    FieldSpec spec;
    int repeats;
    double mostAtRest; ///< target in microseconds a frame if all objects are static
};
const FieldScene kFields[] = {
    {"10,000 objects in 1,662 groups", {10'000, 1662, 400.0}, 31, 60.0},
    {"100,000 objects in 5,000 groups", {100'000, 5000, 1000.0}, 11, std::numeric_limits<double>::infinity()},
};

/// The share of dynamic objects, and the target as a share of the classic path's time.
struct Share {
    const char* name;
    double moving, part;
};
constexpr Share kShares[] = {
    {"0 % moving", 0.0, 1.0 / 20.0}, {"1 % moving", 0.01, 1.0 / 20.0}, {"100 % moving", 1.0, 1.0 / 4.0}};

/// glibc's allocator maps large blocks from the system, page by page, until a block of that size was freed
/// once. Software drivers allocate such blocks in each frame, which would double the time of the first rows.
void settleAllocator() {
    constexpr std::size_t kLarge = std::size_t{30} << 20; // glibc's threshold grows up to 32 MiB
    const auto block = std::make_unique<volatile std::byte[]>(kLarge);
    block[kLarge / 2] = std::byte{1};
}

BenchRow rowOf(const char* bench, std::string scene, const WayTimes& times) {
    BenchRow row{bench, std::move(scene), quantileOf(times.real, 0.5), quantileOf(times.real, 0.95), "us"};
    row.against = {{"classic path", quantileOf(times.classic, 0.5)}};
    row.allocations = times.allocations;
    return row;
}

/// Adds the hash of the driver's ids to the first row, and the driver's rows.
void addDriver(const std::string& scene, const Result<DriverRun>& run, const std::string& driver,
               BenchRow& row, std::vector<BenchRow>& rows) {
    if (!run) {
        row = failedRow("dispatch/plan+submit", scene + ": " + run.error().message(), "us");
        return;
    }
    row.hash = run->hash;
    if (!run->same) {
        row.scene += ": the classic path shows other ids";
        row.value = row.p95 = kNotMeasured;
    }
    rows.push_back(rowOf("dispatch/driver", fmt::format("{}, {}, calls alone", scene, driver), run->calls));
    rows.push_back(
        rowOf("dispatch/driver", fmt::format("{}, {}, with glFinish", scene, driver), run->finished));
    for (std::size_t i = rows.size() - 2; i < rows.size(); ++i)
        rows[i].hash = run->hash;
}

BenchRow measureField(const FieldScene& scene, const Share& share,
                      const std::optional<HeadlessDriver>& driver, AllocationCounter counter,
                      std::vector<BenchRow>& driverRows) {
    FieldSpec spec = scene.spec;
    spec.movingShare = share.moving;
    ObjectField field = makeField(spec);
    const std::string name = fmt::format("{}, {}", scene.name, share.name);
    const Result<WayTimes> times = timeOnNullDevice(
        field, fieldViews(field, kHeadings, kFrameWidth, kFrameHeight), scene.repeats, counter);
    if (!times)
        return failedRow("dispatch/plan+submit", name + ": " + times.error().message(), "us");
    BenchRow row = rowOf("dispatch/plan+submit", driver ? name : name + ", no GL", *times);
    row.hasTarget = true;
    row.target = row.against.front().second * share.part;
    if (share.moving == 0.0)
        row.target = std::min(row.target, scene.mostAtRest);
    if (driver) {
        const std::vector<FieldView> views = fieldViews(field, kDriverHeadings, kDriverWidth, kDriverHeight);
        addDriver(name, runOnDriver(*driver->device, field, views, kDriverRepeats),
                  driver->device->capabilities().renderer, row, driverRows);
    }
    return row;
}

} // namespace

std::vector<BenchRow> benchDispatch(AllocationCounter counter) {
    settleAllocator();
    const std::optional<HeadlessDriver> driver = openDriver();
    std::vector<BenchRow> rows, driverRows;
    for (const FieldScene& scene : kFields)
        for (const Share& share : kShares)
            rows.push_back(measureField(scene, share, driver, counter, driverRows));
    rows.insert(rows.end(), driverRows.begin(), driverRows.end());
    return rows;
}

} // namespace limen::bench
