#include "DrawnPart.h"

#include "core/Assert.h"
#include "motion/Locate.h"

#include <algorithm>

namespace limen::bench {

Result<std::shared_ptr<const engine::LoadedPart>> loadAround(const dat::Archive& archive,
                                                             const world::WorldFile& file,
                                                             const world::Place& place,
                                                             const world::LoadOptions& options) {
    const dat::BlockCoord centre = place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
    Result<std::shared_ptr<const engine::LoadedPart>> loaded =
        engine::loadPart(archive, {centre, options}, file.moving);
    if (loaded && !holds(**loaded, place))
        return fail(ErrorCode::NotFound, place.name, "the place's space is not loaded");
    return loaded;
}

bool holds(const engine::LoadedPart& part, const world::Place& place) {
    return place.cell != 0 ? world::findCell(part.world, place.cell) != world::kNone
                           : world::findBlock(part.world, world::blockAt(place.eye)) != nullptr;
}

frame::FrameView viewFrom(const engine::LoadedPart& part, const world::Place& place, std::uint32_t width,
                          std::uint32_t height, double turn) {
    const world::SpaceIndex root = place.cell != 0 ? world::findCell(part.world, place.cell)
                                                   : motion::locate(part.world, place.eye).space;
    return frame::makeView(place.eye, place.yaw + turn, place.pitch, kFieldOfView, width, height, root);
}

motion::DynamicStateInput dynamicsFor(const frame::FrameView& view) {
    motion::DynamicStateInput input;
    input.eye = view.view.eye;
    input.right = view.view.right;
    input.up = view.view.up;
    input.forward = view.view.forward;
    return input;
}

Result<std::unique_ptr<DrawnPart>> DrawnPart::around(const dat::Archive& archive,
                                                     const world::WorldFile& file, const world::Place& place,
                                                     gpu::Device& device, std::uint32_t width,
                                                     std::uint32_t height,
                                                     const world::LoadOptions& options) {
    return loadAround(archive, file, place, options)
        .and_then([&](std::shared_ptr<const engine::LoadedPart> loaded) {
            return of(std::move(loaded), device, width, height);
        });
}

Result<std::unique_ptr<DrawnPart>> DrawnPart::of(std::shared_ptr<const engine::LoadedPart> loaded,
                                                 gpu::Device& device, std::uint32_t width,
                                                 std::uint32_t height, const gpu::RendererOptions& options) {
    Result<gpu::RenderTarget> target = gpu::RenderTarget::create(device, width, height);
    if (!target)
        return Failure(target.error());
    std::unique_ptr<DrawnPart> part(new DrawnPart(device, std::move(*target), options));
    if (Result<void> shown = part->pipeline_.show(std::make_unique<engine::PartPlanner>(std::move(loaded)));
        !shown)
        return Failure(shown.error());
    return part;
}

void DrawnPart::move(const frame::FrameView& view, std::optional<double> doors) {
    motion::DynamicStateInput input = dynamicsFor(view);
    input.allDoors = doors;
    pipeline_.updateDynamics(input);
}

void DrawnPart::flood(const frame::FrameView& view) {
    const Result<void> flooded = pipeline_.flood(view.view);
    LIMEN_ASSERT(flooded.has_value(), "the views of a benchmark are valid");
}

void DrawnPart::takeAll(const frame::FrameView& view) {
    const world::World& world = pipeline_.part().world;
    visibility::VisibleSet& visible = pipeline_.state().visible;
    visible.clear();
    visibility::Visit root;
    root.space = view.view.root;
    root.zone = world.spaces[root.space].zone;
    root.inPlane = true;
    root.vertexCount = 4;
    visible.visits.push_back(root);
    visible.regionVertices.assign({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
    for (std::uint32_t space = 0; space < world.spaces.size(); ++space)
        visible.seen.push_back({space, 0, {-1, -1, 1, 1}});
}

void DrawnPart::leaveOutOwnership() {
    frame::FramePlan& plan = pipeline_.state().plan;
    for (frame::Batch& batch : plan.batches)
        batch.gated = false;
    const auto end = std::remove_if(plan.stages.begin(), plan.stages.end(), [](const frame::Stage& stage) {
        return stage.kind == frame::StageKind::Ownership;
    });
    plan.stages.erase(end, plan.stages.end());
}

Result<DrawnPart*> PartOfTour::at(const world::Place& place) {
    if (!part_ || !part_->holds(place)) {
        part_.reset(); // frees its memory before the next is loaded
        Result<std::unique_ptr<DrawnPart>> loaded =
            loadAround(archive_, file_, place).and_then([&](std::shared_ptr<const engine::LoadedPart> there) {
                return DrawnPart::of(std::move(there), device_, width_, height_, options_);
            });
        if (!loaded)
            return Failure(loaded.error());
        part_ = std::move(*loaded);
    }
    return part_.get();
}

} // namespace limen::bench
