#include "CallsBench.h"

#include "BuiltInFiles.h"
#include "CallList.h"
#include "DrawnPart.h"
#include "TwoWays.h"

#include "gpu/device/NullDevice.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace limen::bench {

namespace {

constexpr double kMost = 40.0; // GL calls a frame

BenchRow rowOf(const char* bench, const std::string& scene, const CallList& calls) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double most = calls.isOneForEachList() && !calls.frames().empty() ? calls.most() : none;
    BenchRow row{bench, fmt::format("{}, {} stage lists", scene, calls.lists()), most, most, "calls"};
    row.target = kMost;
    row.hasTarget = true;
    row.hash = calls.hash();
    return row;
}

/// Draws from a place in four headings, with doors as loaded, closed and open, and adds the calls.
Result<void> addCalls(DrawnPart& part, const world::Place& place, CallList& calls) {
    for (const std::optional<double> doors :
         {std::optional<double>(), std::optional(0.0), std::optional(1.0)}) {
        for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
            const frame::FrameView view = part.viewFrom(place, turn);
            part.move(view, doors);
            part.flood(view);
            part.plan(view);
            if (Result<void> drawn = part.submit(); !drawn)
                return drawn;
            calls.add(part.plan(), part.renderer().report().glCalls);
        }
    }
    return {};
}

Result<CallList> tourCalls(const dat::Archive& archive, const world::WorldFile& file, gpu::Drawing drawing) {
    std::vector<world::Place> places = file.tour;
    places.insert(places.end(), file.places.begin(), file.places.end());
    CallList calls;
    gpu::Capabilities capabilities = gpu::NullDevice::defaultCapabilities();
    capabilities.software = drawing == gpu::Drawing::Fast; // the way of drawing without a card
    gpu::NullDevice device(capabilities);
    PartOfTour part(archive, file, device, kFrameWidth, kFrameHeight, {.drawing = drawing});
    for (const world::Place& place : places) {
        Result<void> added =
            part.at(place).and_then([&](DrawnPart* there) { return addCalls(*there, place, calls); });
        if (!added)
            return Failure(added.error());
    }
    return calls;
}

BenchRow tourRow(const char* bench, gpu::Drawing drawing) {
    BuiltInFiles files;
    if (Result<void> opened = files.open(); !opened)
        return failedRow(bench, opened.error().message(), "calls");
    const Result<CallList> calls = tourCalls(*files.archive, files.world, drawing);
    if (!calls)
        return failedRow(bench, calls.error().message(), "calls");
    return rowOf(bench,
                 fmt::format("{} way points, {} places, {} frames", files.world.tour.size(),
                             files.world.places.size(), calls->frames().size()),
                 *calls);
}

BenchRow objectsRow() {
    constexpr const char* kBench = "calls/objects";
    CallList calls;
    double classic = 0.0;
    for (const double share : {0.0, 0.01, 1.0}) {
        const ObjectField field = makeField({100'000, 5000, 1000.0, share});
        gpu::NullDevice device;
        const Result<std::unique_ptr<TwoWays>> ways =
            TwoWays::create(device, field, kFrameWidth, kFrameHeight);
        if (!ways)
            return failedRow(kBench, ways.error().message(), "calls");
        for (const FieldView& view : fieldViews(field, 16, kFrameWidth, kFrameHeight)) {
            const Result<void> drawn = (*ways)->drawReal(view);
            calls.add((*ways)->plan(), device.glCalls());
            const Result<void> drawnBoth = drawn.and_then([&] { return (*ways)->drawClassic(view); });
            if (!drawnBoth)
                return failedRow(kBench, drawnBoth.error().message(), "calls");
            classic = std::max(classic, static_cast<double>(device.glCalls()));
        }
    }
    BenchRow row = rowOf(kBench, "100,000 objects in 5,000 groups, 0, 1 and 100 % moving", calls);
    row.against = {{"classic path", classic}};
    return row;
}

} // namespace

std::vector<BenchRow> benchCalls(AllocationCounter) {
    return {tourRow("calls/tour", gpu::Drawing::Exact), tourRow("calls/tour/fast", gpu::Drawing::Fast),
            objectsRow()};
}

} // namespace limen::bench
