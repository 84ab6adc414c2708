#include "DrawnPart.h"

#include "frame/SceneBuilder.h"
#include "frame/WorldGraph.h"
#include "motion/Locate.h"

#include <algorithm>

namespace limen::bench {

namespace {

constexpr double kFieldOfView = 75.0; // degrees

} // namespace

Result<std::unique_ptr<DrawnPart>> DrawnPart::around(const dat::Archive& archive,
                                                     const world::WorldFile& file, const world::Place& place,
                                                     gpu::Device& device, std::uint32_t width,
                                                     std::uint32_t height,
                                                     const world::LoadOptions& options) {
    const dat::BlockCoord centre = place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
    Result<world::World> world = world::loadWorld(archive, centre, options, file.moving);
    if (!world)
        return tl::unexpected(world.error());
    Result<visibility::Graph> graph = frame::visibilityGraph(*world);
    if (!graph)
        return tl::unexpected(graph.error());
    Result<gpu::RenderTarget> target = gpu::RenderTarget::create(device, width, height);
    if (!target)
        return tl::unexpected(target.error());
    std::unique_ptr<DrawnPart> part(
        new DrawnPart(std::move(*world), std::move(*graph), device, std::move(*target)));
    if (Result<void> uploaded =
            part->renderer_.upload(frame::buildScene(part->world_, part->planner_.pieces()));
        !uploaded)
        return tl::unexpected(uploaded.error());
    if (!part->holds(place))
        return fail(ErrorCode::NotFound, place.name, "is not where the world file says");
    return part;
}

bool DrawnPart::holds(const world::Place& place) const {
    return place.cell != 0 ? world::findCell(world_, place.cell) != world::kNone
                           : world::findBlock(world_, world::blockAt(place.eye)) != nullptr;
}

frame::FrameView DrawnPart::viewFrom(const world::Place& place, double turn) const {
    const world::SpaceIndex root =
        place.cell != 0 ? world::findCell(world_, place.cell) : motion::locate(world_, place.eye).space;
    return frame::makeView(place.eye, place.yaw + turn, place.pitch, kFieldOfView, target_.width(),
                           target_.height(), root);
}

void DrawnPart::move(const frame::FrameView& view, std::optional<double> doors) {
    motion::DynamicStateInput input;
    input.allDoors = doors;
    input.eye = view.view.eye;
    input.right = view.view.right;
    input.up = view.view.up;
    input.forward = view.view.forward;
    dynamicsBuilder_.build(input, dynamics_);
}

void DrawnPart::flood(const frame::FrameView& view) {
    visibility::flood(graph_, dynamics_.closed, view.view, {}, scratch_, visible_);
}

void DrawnPart::takeAll(const frame::FrameView& view) {
    visible_.clear();
    visibility::Visit root;
    root.space = view.view.root;
    root.zone = world_.spaces[root.space].zone;
    root.inPlane = true;
    root.vertexCount = 4;
    visible_.visits.push_back(root);
    visible_.regionVertices.assign({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}});
    for (std::uint32_t space = 0; space < world_.spaces.size(); ++space)
        visible_.seen.push_back({space, 0, {-1, -1, 1, 1}});
}

void DrawnPart::leaveOutOwnership() {
    for (frame::Batch& batch : plan_.batches)
        batch.gated = false;
    const auto end = std::remove_if(plan_.stages.begin(), plan_.stages.end(), [](const frame::Stage& stage) {
        return stage.kind == frame::StageKind::Ownership;
    });
    plan_.stages.erase(end, plan_.stages.end());
}

Result<DrawnPart*> PartOfTour::at(const world::Place& place) {
    if (!part_ || !part_->holds(place)) {
        part_.reset(); // room for the next
        Result<std::unique_ptr<DrawnPart>> loaded =
            DrawnPart::around(archive_, file_, place, device_, width_, height_);
        if (!loaded)
            return tl::unexpected(loaded.error());
        part_ = std::move(*loaded);
    }
    return part_.get();
}

} // namespace limen::bench
