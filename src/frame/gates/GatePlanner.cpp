#include "frame/gates/GatePlanner.h"

#include "core/Assert.h"
#include "frame/Highlights.h"
#include "frame/PlanBatches.h"
#include "frame/PlanDynamics.h"
#include "frame/PlanSky.h"
#include "visibility/Region.h"

#include <algorithm>
#include <limits>

namespace limen::frame {

namespace {

constexpr std::array kSolidClasses{DrawClass::Wall, DrawClass::Terrain, DrawClass::Opaque, DrawClass::CutOut};

/// The largest number of clip sets: those of slices are numbers in half a word (gpu::Instance::block).
constexpr std::size_t kMostClipSets = gpu::kBlockMask;

gpu::ClipSet clipSetOf(const ScreenPlanes& planes) {
    gpu::ClipSet set = OpeningTriangles::openClipSet();
    for (std::uint32_t i = 0; i < planes.count; ++i)
        set.planes[i] = gpu::vec4(Vec3f(planes.lines[i]), 0.0f);
    return set;
}

/// A rectangle around a region, NDC, a pixel larger on each side than its planes can be.
gpu::vec4 rectAround(std::span<const Vec3> region, const FrameView& frame) {
    const visibility::Rect rect = visibility::boundsOf(region);
    const double x = 4.0 / frame.width, y = 4.0 / frame.height;
    return {static_cast<float>(rect.minX - x), static_cast<float>(rect.minY - y),
            static_cast<float>(rect.maxX + x), static_cast<float>(rect.maxY + y)};
}

/// Ends a batch of a stage whose batches depend on the view: without draws it makes no call.
void endBatch(FramePlan& plan) {
    countTriangles(plan);
    if (plan.batches.back().draws == 0)
        plan.batches.pop_back();
}

/// Ends a stage; one without batches is left out.
void endUsedStage(FramePlan& plan) {
    endStage(plan);
    if (plan.stages.back().batchCount == 0 && !plan.stages.back().clearsDepth)
        plan.stages.pop_back();
}

} // namespace

GatePlanner::GatePlanner(const StaticScene& scene)
    : scene_(scene), world_(scene.world()), selection_(scene) {}

void GatePlanner::plan(const FrameView& frame, const world::DynamicState& dynamics,
                       const visibility::VisibleSet& set, FramePlan& plan) {
    LIMEN_ASSERT(set.visits.size() > 1, "a single visit needs no gate");
    const Input in{frame, dynamics, set, plan};
    begin(in);
    if (frame.gate == Gate::Planes)
        planPlanes(in);
    else
        planDepth(in);
    plan.counts.visits = static_cast<std::uint32_t>(set.visits.size());
    plan.counts.cellsSeen = static_cast<std::uint32_t>(set.seen.size());
    const Selection::Counts& selected = selection_.counts();
    plan.counts.instancesTested = selected.tested;
    plan.counts.instancesDrawn = selected.drawn;
    plan.counts.instancesCulled = selected.tested - selected.drawn;
    plan.counts.drawsUngated = selected.drawn;
    plan.counts.boundsTested = selected.boundsTested;
}

void GatePlanner::begin(const Input& in) {
    in.plan.gate = in.frame.gate;
    in.plan.clips = true;
    in.plan.clipSets.push_back(OpeningTriangles::openClipSet());
    for (const visibility::Visit& visit : in.set.visits) {
        gpu::Visit& out = in.plan.visits.emplace_back();
        out.entryPlane = OpeningTriangles::entryPlaneOf(visit);
        out.zone = in.plan.constants.rootZone;
        out.parent = gpu::kNoVisit;
    }
    in.plan.constants.visitCount = 1; // no fragment looks for another; openings need their plane
    const double pixel =
        2.0 * std::max(in.frame.view.tanHalfX / in.frame.width, in.frame.view.tanHalfY / in.frame.height);
    cones_.prepare(in.frame.view, in.set, pixel);
    selection_.begin(in.frame, in.dynamics, in.set);
    slices_.clear();
    planes_.assign(in.set.visits.size(), {});
    outsideSlices_ = 0;
    surfaces_.clear();
    ground_.clear();
    placeSky(world_, in.frame, in.set.visits.front().space, sky_);
}

GatePlanner::Slice GatePlanner::makeSlice(const Input& in, std::uint32_t visit) {
    const auto region = in.set.region(in.set.visits[visit]);
    ScreenPlanes& planes = planes_[visit];
    planes = screenPlanes(region, {in.frame.width, in.frame.height});
    Slice slice{visit, 0, {}};
    if (planes.count == 0 || in.plan.clipSets.size() > kMostClipSets)
        return slice;
    slice.clipSet = static_cast<std::uint32_t>(in.plan.clipSets.size());
    in.plan.clipSets.push_back(clipSetOf(planes));
    if (in.plan.rects.size() <= std::numeric_limits<std::uint16_t>::max()) {
        slice.rects = {static_cast<std::uint16_t>(in.plan.rects.size()), 1};
        in.plan.rects.push_back(rectAround(region, in.frame));
    }
    return slice;
}

void GatePlanner::makeSlices(const Input& in, Order visits) {
    const auto isOutside = [&](std::uint32_t visit) { return in.set.visits[visit].space == world::kOutside; };
    for (const std::uint32_t visit : visits) {
        if (!isOutside(visit))
            continue;
        const Slice slice = makeSlice(in, visit);
        if (slice.clipSet == 0) { // the whole picture contains all other regions
            slices_.assign(1, slice);
            break;
        }
        slices_.push_back(slice);
    }
    outsideSlices_ = slices_.size();
    for (const std::uint32_t visit : visits)
        if (!isOutside(visit) && !in.set.visits[visit].hole)
            slices_.push_back(makeSlice(in, visit));
}

void GatePlanner::reportSpaces(const Input& in, Order visits) {
    for (const std::uint32_t space : spacesOf(in.set.visits, visits)) {
        GatedSpace& report = in.plan.spaces.emplace_back();
        report.space = space;
        for (const Slice& slice : slices_) {
            if (in.set.visits[slice.visit].space != space)
                continue;
            ++report.regions;
            report.planes += planes_[slice.visit].count;
            report.fallbacks += planes_[slice.visit].isRectangle ? 1 : 0;
        }
    }
}

void GatePlanner::selectPart(const Input& in, Order visits, std::size_t number) {
    if (number >= parts_.size())
        parts_.resize(number + 1);
    while (number >= pieces_.size())
        pieces_.emplace_back(scene_.meshPieces());
    selection_.select(visits, parts_[number]);
    planDynamics(world_, in.frame, in.dynamics, parts_[number].dynamics, pieces_[number], in.plan);
}

GatePlanner::Surface GatePlanner::clipped(const Input& in, std::uint32_t position, const Slice& slice) const {
    if (slice.clipSet == 0)
        return {position, world::kNone, {}};
    const world::InstanceIndex instance = scene_.clusters().order[position];
    FramePlan& plan = in.plan;
    const auto record = static_cast<std::uint32_t>(plan.constants.staticInstances +
                                                   plan.dynamicInstances.size() + plan.records.size());
    gpu::Instance& own = plan.records.emplace_back(scene_.records()[instance]);
    own.block |= slice.clipSet << gpu::kClipSetShift;
    own.highlight = colourOf(in.frame.highlights, world_.instances[instance].object);
    return {position, record, slice.rects};
}

void GatePlanner::addSliced(const Input& in, const Slice& slice, const SelectedPart& part,
                            std::vector<Surface>& out) {
    const std::uint32_t space = in.set.visits[slice.visit].space;
    for (const std::uint32_t position : part.surfaces) {
        const world::Instance& instance = instanceAt(position);
        const bool isShell = instance.kind == world::InstanceKind::Shell;
        if (isShell ? instance.placedIn != space : space != world::kOutside)
            continue;
        const Sphere relative{instance.bounds.centre - in.frame.view.eye, instance.bounds.radius};
        if (isShell || slice.clipSet == 0 ||
            cones_.classify(slice.visit, cones_.sphereOf(relative)) != visibility::Containment::Outside)
            out.push_back(clipped(in, position, slice));
    }
}

void GatePlanner::addWhole(Order visits, const SelectedPart& part, const visibility::VisibleSet& set,
                           std::vector<Surface>& out) const {
    for (const std::uint32_t space : spacesOf(set.visits, visits))
        for (const std::uint32_t position : part.surfaces)
            if (instanceAt(position).placedIn == space)
                out.push_back({position, world::kNone, {}});
}

PieceRun GatePlanner::runOf(const Surface& surface, DrawClass drawn, FramePlan& plan) const {
    if (surface.record == world::kNone)
        return scene_.pieces().run(surface.position, surface.position + 1, drawn);
    PieceRun run;
    const world::Instance& instance = instanceAt(surface.position);
    eachRangeOf(world_.meshes[instance.mesh], instance.kind,
                [&](DrawClass each, const world::Mesh::Range& range) {
                    if (each == drawn && range.indexCount > 0)
                        run = addOwnPieces(range, surface.record, plan);
                });
    run.rects = surface.rects;
    return run;
}

void GatePlanner::addSurfaces(std::span<const Surface> surfaces, DrawClass drawn, FramePlan& plan) const {
    for (const Surface& surface : surfaces)
        addRun(runOf(surface, drawn, plan), plan);
}

void GatePlanner::addObjects(std::size_t part, DrawClass drawn, FramePlan& plan) {
    for (const PositionRange& range : parts_[part].objects)
        addRun(scene_.pieces().run(range.first, range.end, drawn), plan);
    pieces_[part].moveRuns(drawn, plan);
}

void GatePlanner::addBlended(const Input& in, std::span<const Surface> surfaces,
                             std::optional<std::size_t> part) {
    const Vec3& eye = in.frame.view.eye;
    transparent_.clear();
    for (const Surface& surface : surfaces) {
        const world::InstanceIndex instance = scene_.clusters().order[surface.position];
        transparent_.addRun(runOf(surface, DrawClass::Blended, in.plan), instance,
                            world_.instances[instance].bounds, eye);
    }
    if (part) {
        for (const PositionRange& range : parts_[*part].objects)
            transparent_.addStatic(scene_, eye, range.first, range.end);
        transparent_.addDynamic(in.dynamics, eye, pieces_[*part], in.plan);
    }
    beginBatch(Program::Blended, false, in.plan);
    transparent_.write(false, in.plan);
}

void GatePlanner::addPlainSky(FramePlan& plan) const {
    plan.batches.push_back(
        {Program::SkyPlain, true, slices_[0].clipSet, 0, static_cast<std::uint32_t>(outsideSlices_)});
}

void GatePlanner::addSky(const Input& in, bool overLand) {
    for (std::size_t i = 0; i < outsideSlices_; ++i)
        addSkyObjects(world_, sky_, {overLand, slices_[i].clipSet}, in.plan);
}

void GatePlanner::addOpenings(const Input& in, Order visits, Program program) {
    FramePlan& plan = in.plan;
    const auto first = static_cast<std::uint32_t>(plan.ownershipVertices.size());
    OpeningTriangles openings(world_, in.frame, in.set, plan);
    for (const std::uint32_t i : visits) {
        const visibility::Visit& visit = in.set.visits[i];
        if (OpeningTriangles::isEdgeOn(visit))
            openings.drawWithin(i, in.set.region(visit), {});
        else
            openings.draw(i);
    }
    const auto count = static_cast<std::uint32_t>(plan.ownershipVertices.size()) - first;
    plan.counts.ownershipTriangles += count / 3;
    plan.batches.push_back({program, false, first, count, count > 0 ? 1u : 0u});
}

void GatePlanner::planPlanes(const Input& in) {
    FramePlan& plan = in.plan;
    const std::vector<std::uint32_t> order = farToNear(in.set.visits);
    makeSlices(in, order);
    reportSpaces(in, order);
    selectPart(in, order, 0);
    replaceHighlighted(scene_, in.frame.highlights, plan);
    std::vector<std::uint32_t> sliceOf(in.set.visits.size(), world::kNone);
    for (std::uint32_t i = 0; i < slices_.size(); ++i)
        sliceOf[slices_[i].visit] = i;
    for (const std::uint32_t visit : order)
        if (sliceOf[visit] != world::kNone)
            addSliced(in, slices_[sliceOf[visit]], parts_[0], surfaces_);
    beginStage(plan, StageKind::Ownership);
    endStage(plan);
    beginStage(plan, StageKind::Solid);
    for (const DrawClass drawn : kSolidClasses) {
        if (drawn == DrawClass::Opaque) // walls and ground are the occluders
            plan.firstOccludee = static_cast<std::uint32_t>(plan.batches.size());
        beginBatch(programOf(drawn), false, plan);
        addSurfaces(surfaces_, drawn, plan);
        addObjects(0, drawn, plan);
        countTriangles(plan);
    }
    endStage(plan);
    beginStage(plan, StageKind::Sky);
    if (outsideSlices_ > 0) {
        addPlainSky(plan);
        beginBatch(Program::SkyObjects, true, plan);
        for (const bool overLand : {false, true})
            addSky(in, overLand);
    }
    endStage(plan);
    beginStage(plan, StageKind::Transparent);
    addBlended(in, surfaces_, 0);
    countTriangles(plan);
    endStage(plan);
    beginStage(plan, StageKind::Overlay);
    endStage(plan);
}

void GatePlanner::planDepth(const Input& in) {
    FramePlan& plan = in.plan;
    if (!exteriors_)
        exteriors_ = exteriorsOf(world_);
    views_ = depthViews(world_, *exteriors_, in.set.visits, in.frame.view.eye);
    makeSlices(in, views_.landscape);
    std::vector<std::uint32_t> order = views_.landscape;
    for (const SeenBuilding& building : views_.buildings)
        order.insert(order.end(), building.visits.begin(), building.visits.end());
    order.insert(order.end(), views_.inside.begin(), views_.inside.end());
    reportSpaces(in, order);
    // The dynamic instances of all parts are numbered before the plan's own records.
    selectPart(in, views_.landscape, 0);
    const std::size_t inside = views_.buildings.size() + 1;
    for (std::size_t b = 0; b < views_.buildings.size(); ++b)
        selectPart(in, views_.buildings[b].visits, b + 1);
    selectPart(in, views_.inside, inside);
    replaceHighlighted(scene_, in.frame.highlights, plan);
    if (!views_.landscape.empty())
        planLandscape(in);
    if (!views_.inside.empty())
        planInside(in, inside);
    plan.firstOccludee = static_cast<std::uint32_t>(plan.batches.size()); // depth is overwritten in the frame
}

void GatePlanner::planLandscape(const Input& in) {
    FramePlan& plan = in.plan;
    beginStage(plan, StageKind::Sky);
    addPlainSky(plan);
    beginBatch(Program::SkyObjects, true, plan);
    addSky(in, false);
    endBatch(plan);
    endUsedStage(plan);
    for (std::size_t i = 0; i < outsideSlices_; ++i)
        addSliced(in, slices_[i], parts_[0], surfaces_);
    for (const LandscapeStep& step : views_.steps) {
        if (step.kind == LandscapeStep::Kind::Building) {
            flushGround(plan);
            planBuilding(in, step.index);
        }
        for (const Surface& surface : surfaces_)
            if (isOf(surface, step))
                ground_.push_back(surface);
    }
    flushGround(plan);
    beginStage(plan, StageKind::Solid);
    for (const DrawClass drawn : {DrawClass::Opaque, DrawClass::CutOut}) {
        beginBatch(programOf(drawn), false, plan);
        addObjects(0, drawn, plan);
        endBatch(plan);
    }
    endUsedStage(plan);
    beginStage(plan, StageKind::Sky);
    beginBatch(Program::SkyObjects, true, plan);
    addSky(in, true);
    endBatch(plan);
    endUsedStage(plan);
    beginStage(plan, StageKind::Transparent);
    addBlended(in, surfaces_, 0);
    endBatch(plan);
    endUsedStage(plan);
}

bool GatePlanner::isOf(const Surface& surface, const LandscapeStep& step) const {
    const world::InstanceIndex instance = scene_.clusters().order[surface.position];
    switch (step.kind) {
    case LandscapeStep::Kind::Block:
        return world_.instances[instance].kind == world::InstanceKind::Terrain &&
               world_.instances[instance].block == step.index;
    case LandscapeStep::Kind::Exterior:
        return instance == step.index;
    case LandscapeStep::Kind::Building:
        return instance == views_.buildings[step.index].exterior;
    }
    return false;
}

void GatePlanner::flushGround(FramePlan& plan) {
    beginStage(plan, StageKind::Solid);
    for (const DrawClass drawn : {DrawClass::Terrain, DrawClass::Wall, DrawClass::CutOut}) {
        beginBatch(programOf(drawn), false, plan);
        addSurfaces(ground_, drawn, plan);
        endBatch(plan);
    }
    endUsedStage(plan);
    ground_.clear();
}

void GatePlanner::planBuilding(const Input& in, std::size_t building) {
    FramePlan& plan = in.plan;
    const SeenBuilding& seen = views_.buildings[building];
    beginStage(plan, StageKind::Ownership);
    addOpenings(in, seen.openings, Program::Stamp);
    endUsedStage(plan);
    std::vector<Surface> walls;
    addWhole(seen.visits, parts_[building + 1], in.set, walls);
    beginStage(plan, StageKind::Solid);
    for (const DrawClass drawn : {DrawClass::Wall, DrawClass::Opaque, DrawClass::CutOut}) {
        beginBatch(programOf(drawn), false, plan);
        addSurfaces(walls, drawn, plan);
        addObjects(building + 1, drawn, plan);
        endBatch(plan);
    }
    endUsedStage(plan);
    beginStage(plan, StageKind::Transparent);
    addBlended(in, walls, building + 1);
    endBatch(plan);
    endUsedStage(plan);
}

void GatePlanner::planInside(const Input& in, std::size_t part) {
    FramePlan& plan = in.plan;
    if (views_.clearsDepth()) {
        beginStage(plan, StageKind::Ownership);
        plan.stages.back().clearsDepth = true;
        addOpenings(in, views_.fences, Program::Fence);
        endStage(plan);
    }
    std::vector<Surface> walls;
    addWhole(views_.inside, parts_[part], in.set, walls);
    beginStage(plan, StageKind::Solid);
    for (const DrawClass drawn : {DrawClass::Wall, DrawClass::Opaque, DrawClass::CutOut}) {
        beginBatch(programOf(drawn), false, plan);
        addSurfaces(walls, drawn, plan);
        addObjects(part, drawn, plan);
        endBatch(plan);
    }
    endUsedStage(plan);
    beginStage(plan, StageKind::Transparent);
    addBlended(in, walls, part);
    endBatch(plan);
    endUsedStage(plan);
}

} // namespace limen::frame
