#include "CallsBench.h"

#include "CallList.h"
#include "TemporaryDirectory.h"
#include "TwoWays.h"

#include "dat/Archive.h"
#include "demo/Demo.h"
#include "frame/SceneBuilder.h"
#include "frame/WorldGraph.h"
#include "gpu/NullDevice.h"
#include "motion/Moments.h"
#include "visibility/Flood.h"
#include "world/Loader.h"
#include "world/Places.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>

namespace limen::bench {

namespace {

constexpr double kMost = 40.0; // GL calls a frame
constexpr std::uint32_t kWidth = 1280, kHeight = 720;

BenchRow rowOf(const char* bench, const std::string& scene, const CallList& calls) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double most = calls.isOneForEachList() && !calls.frames().empty() ? calls.most() : none;
    BenchRow row{bench, fmt::format("{}, {} stage lists", scene, calls.lists()), most, most, "calls"};
    row.target = kMost;
    row.hasTarget = true;
    row.hash = calls.hash();
    return row;
}

BenchRow failedRow(const char* bench, const Error& error) {
    return rowOf(bench, error.message(), {});
}

/// A part of the built-in world, ready to be drawn.
class Part {
public:
    /// Errors: what the renderer reports.
    [[nodiscard]] static Result<std::unique_ptr<Part>> create(world::World world) {
        Result<visibility::Graph> graph = frame::visibilityGraph(world);
        if (!graph) {
            return tl::unexpected(graph.error());
        }
        std::unique_ptr<Part> part(new Part(std::move(world), std::move(*graph)));
        Result<gpu::RenderTarget> target = gpu::RenderTarget::create(part->device_, kWidth, kHeight);
        if (!target) {
            return tl::unexpected(target.error());
        }
        part->target_.emplace(std::move(*target));
        if (Result<void> uploaded = part->renderer_.upload(frame::buildScene(part->world_)); !uploaded) {
            return tl::unexpected(uploaded.error());
        }
        return part;
    }

    /// Whether a place's space is loaded.
    [[nodiscard]] bool holds(const world::Place& place) const {
        return place.cell != 0 ? world::findCell(world_, place.cell) != world::kNone
                               : world::findBlock(world_, world::blockAt(place.eye)) != nullptr;
    }

    /// Draws from a place, four headings, and adds what it takes.
    [[nodiscard]] Result<void> addCalls(const world::Place& place, CallList& calls) {
        const world::SpaceIndex root =
            place.cell != 0 ? world::findCell(world_, place.cell) : world::kOutside;
        for (const std::optional<double> doors :
             {std::optional<double>(), std::optional(0.0), std::optional(1.0)}) {
            for (const double turn : {0.0, 90.0, 180.0, 270.0}) {
                const frame::FrameView view =
                    frame::makeView(place.eye, place.yaw + turn, place.pitch, 75.0, kWidth, kHeight, root);
                if (Result<void> drawn = draw(view, doors); !drawn) {
                    return drawn;
                }
                calls.add(plan_, renderer_.report().glCalls);
            }
        }
        return {};
    }

private:
    Part(world::World world, visibility::Graph graph)
        : world_(std::move(world)), graph_(std::move(graph)), moments_(world_), planner_(world_),
          renderer_(device_) {}

    [[nodiscard]] Result<void> draw(const frame::FrameView& view, std::optional<double> doors) {
        motion::MomentInput input;
        input.allDoors = doors;
        input.eye = view.view.eye;
        input.right = view.view.right;
        input.up = view.view.up;
        input.forward = view.view.forward;
        moments_.at(input, moment_);
        visibility::flood(graph_, moment_.closed, view.view, {}, scratch_, visible_);
        planner_.plan(view, moment_, visible_, plan_);
        return renderer_.render(plan_, *target_);
    }

    world::World world_;
    visibility::Graph graph_;
    motion::Moments moments_;
    world::Moment moment_;
    visibility::FloodScratch scratch_;
    visibility::VisibleSet visible_;
    frame::Planner planner_;
    frame::FramePlan plan_;
    gpu::NullDevice device_;
    gpu::Renderer renderer_;
    std::optional<gpu::RenderTarget> target_;
};

Result<std::unique_ptr<Part>> loadAround(const dat::Archive& archive, const world::WorldFile& file,
                                         const world::Place& place) {
    const dat::BlockCoord centre = place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
    Result<world::World> world = world::loadWorld(archive, centre, {}, file.moving);
    if (!world) {
        return tl::unexpected(world.error());
    }
    return Part::create(std::move(*world)).and_then([&](std::unique_ptr<Part> part) {
        return part->holds(place) ? Result<std::unique_ptr<Part>>(std::move(part))
                                  : fail(ErrorCode::NotFound, place.name, "is not where the world file says");
    });
}

Result<CallList> tourCalls(const dat::Archive& archive, const world::WorldFile& file) {
    std::vector<world::Place> places = file.tour;
    places.insert(places.end(), file.places.begin(), file.places.end());
    CallList calls;
    std::unique_ptr<Part> part;
    for (const world::Place& place : places) {
        if (!part || !part->holds(place)) {
            Result<std::unique_ptr<Part>> loaded = loadAround(archive, file, place);
            if (!loaded) {
                return tl::unexpected(loaded.error());
            }
            part = std::move(*loaded);
        }
        if (Result<void> added = part->addCalls(place, calls); !added) {
            return tl::unexpected(added.error());
        }
    }
    return calls;
}

BenchRow tourRow() {
    constexpr const char* kBench = "calls/tour";
    const TemporaryDirectory directory("bench-calls");
    if (Result<void> written = demo::writeBuiltInWorld(directory.path()); !written) {
        return failedRow(kBench, written.error());
    }
    const Result<dat::Archive> archive = dat::Archive::open(directory.path());
    if (!archive) {
        return failedRow(kBench, archive.error());
    }
    const Result<world::WorldFile> file = world::loadWorldFile(directory.path());
    if (!file) {
        return failedRow(kBench, file.error());
    }
    const Result<CallList> calls = tourCalls(*archive, *file);
    if (!calls) {
        return failedRow(kBench, calls.error());
    }
    return rowOf(kBench,
                 fmt::format("{} way points, {} places, {} frames", file->tour.size(), file->places.size(),
                             calls->frames().size()),
                 *calls);
}

BenchRow objectsRow() {
    constexpr const char* kBench = "calls/objects";
    CallList calls;
    double classic = 0.0;
    for (const double share : {0.0, 0.01, 1.0}) {
        const ObjectField field = makeField({100'000, 5000, 1000.0, share});
        gpu::NullDevice device;
        const Result<std::unique_ptr<TwoWays>> ways = TwoWays::create(device, field, kWidth, kHeight);
        if (!ways) {
            return failedRow(kBench, ways.error());
        }
        for (const FieldView& view : fieldViews(field, 16, kWidth, kHeight)) {
            const Result<void> drawn = (*ways)->drawReal(view);
            calls.add((*ways)->plan(), device.glCalls());
            const Result<void> drawnBoth = drawn.and_then([&] { return (*ways)->drawClassic(view); });
            if (!drawnBoth) {
                return failedRow(kBench, drawnBoth.error());
            }
            classic = std::max(classic, static_cast<double>(device.glCalls()));
        }
    }
    BenchRow row = rowOf(kBench, "100,000 objects in 5,000 groups, 0, 1 and 100 % moving", calls);
    row.against = {{"classic path", classic}};
    return row;
}

} // namespace

std::vector<BenchRow> benchCalls(AllocationCounter) {
    return {tourRow(), objectsRow()};
}

} // namespace limen::bench
