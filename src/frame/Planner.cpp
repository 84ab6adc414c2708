#include "frame/Planner.h"

#include "core/Assert.h"
#include "core/Prefetch.h"
#include "frame/Highlights.h"
#include "frame/OpeningCells.h"
#include "frame/Ownership.h"
#include "frame/PlanBatches.h"
#include "frame/PlanDynamics.h"
#include "frame/PlanSky.h"
#include "frame/gates/GatePlanner.h"
#include "world/SkyCover.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// Clip from eye-relative: reversed depth (1 at the near plane, 0 at infinity), no far plane.
gpu::mat4 clipFromEye(const FrameView& frame) {
    const Vec3 x = frame.view.right / frame.view.tanHalfX;
    const Vec3 y = frame.view.up / frame.view.tanHalfY;
    const Vec3& w = frame.view.forward;
    const auto n = static_cast<float>(frame.nearPlane);
    // Columns.
    return {gpu::vec4(x.x, y.x, 0.0, w.x), gpu::vec4(x.y, y.y, 0.0, w.y), gpu::vec4(x.z, y.z, 0.0, w.z),
            gpu::vec4(0.0f, 0.0f, n, 0.0f)};
}

bool seesOutside(const visibility::VisibleSet& set) {
    return std::any_of(set.visits.begin(), set.visits.end(),
                       [](const visibility::Visit& v) { return v.zone == world::kOutsideZone; });
}

/// Metres. Triangles near the eye are clipped, which rounds their corners apart. Of 288 million pixels from eyes at openings eight
/// were void in frames of one visit, all within 0.02 mm of an opening's plane.
constexpr double kAtOpening = 1e-3;

bool isAtAnOpening(const world::World& world, world::SpaceIndex space, const Vec3& eye) {
    const world::Space& here = world.spaces[space];
    const auto portals = std::span(world.portals).subspan(here.firstPortal, here.portalCount);
    return std::any_of(portals.begin(), portals.end(), [&](const world::Portal& portal) {
        return std::abs(portal.plane.signedDistance(eye)) < kAtOpening;
    });
}

// Light in cells: docs/formats/light.md.
constexpr float kSealedAmbient = 0.2f;
constexpr float kViewerIntensity = 2.25f;
constexpr std::size_t kMostLamps = 40; ///< that shine in a frame
/// FrameView::rootFirst: the share of the picture that openings may have. Behind them the root is drawn in vain. With 5 % a tenth
/// of a frame was gained, with 30 % nothing (decision 216).
constexpr double kMostOpen = 0.125;

void placeDetails(const world::Details& details, const FrameView& frame, gpu::ViewConstants& c) {
    const auto place = [&c](const world::DetailPicture& picture, std::uint32_t detail) {
        c.detailTextures[static_cast<int>(detail)] = picture.texture;
        c.detailTiling[static_cast<int>(detail)] = picture.tiling;
    };
    place(details.exteriors, gpu::kDetailOfExteriors);
    place(details.shells, gpu::kDetailOfShells);
    if (frame.look == world::Look::Enhanced)
        place(details.land, gpu::kDetailOfLand);
}

/// The plain sky's colour straight up, as a factor of the horizon's: bluer and darker.
constexpr float kZenith[3] = {0.42f, 0.58f, 0.86f};

} // namespace

Planner::Planner(const StaticScene& scene)
    : scene_(scene), world_(scene.world()), pieces_(scene.pieces()), selection_(scene),
      rects_(world_.zones.size()), dynamicPieces_(scene.meshPieces()) {}

Planner::~Planner() = default;

void Planner::plan(const FrameView& frame, const world::DynamicState& dynamics,
                   const visibility::VisibleSet& set, FramePlan& plan) {
    LIMEN_ASSERT(!set.visits.empty(), "a flood yields at least the root");
    plan.clear();
    fillConstants(frame, set, plan);
    placeLamps(frame.view.eye, plan);
    // With a single visit there is nothing to gate, and all gates have one plan.
    if (frame.gate != Gate::Ownership && set.visits.size() > 1) {
        if (gates_ == nullptr)
            gates_ = std::make_unique<GatePlanner>(scene_);
        gates_->plan(frame, dynamics, set, plan);
        return;
    }
    plan.gate = frame.gate;
    plan.levelSixteenths = frame.levels.sixteenths;
    if (frame.gate != Gate::Ownership)
        plan.spaces.push_back({set.visits[0].space, 1, 0, 0});
    beginStage(plan, StageKind::Ownership);
    planOwnership(world_, dynamics, frame, set, plan);
    const bool several = set.visits.size() > 1;
    if (several) {
        const auto vertices = static_cast<std::uint32_t>(plan.ownershipVertices.size());
        plan.batches.push_back({Program::Ownership, false, 0, vertices, vertices > 0 ? 1u : 0u});
    }
    endStage(plan);
    rects_.find(frame, set, plan);
    LIMEN_ASSERT(!frame.rootFirst || frame.fillsVoids, "FrameView::rootFirst requires it");
    std::optional<RectRun> openings;
    if (several && frame.fillsVoids && set.visits.front().space == world::kOutside)
        openings = rectsOfOpenings(frame, set, plan);
    isRootFirst_ = frame.rootFirst && openings && shareOf(*openings, plan) <= kMostOpen;
    selection_.select(frame, dynamics, set, isRootFirst_);
    planDynamics(world_, frame, dynamics, selection_.dynamicInstances(), dynamicPieces_, plan);
    replaceHighlighted(scene_, frame.highlights, plan);
    beginStage(plan, StageKind::Solid);
    if (isRootFirst_)
        planSolidRootFirst(*openings, plan);
    else
        planSolid(several, plan);
    endStage(plan);
    beginStage(plan, StageKind::Sky);
    planSky(frame, set, openings, plan);
    endStage(plan);
    beginStage(plan, StageKind::Transparent);
    planTransparent(frame.view.eye, several, dynamics, plan);
    endStage(plan);
    beginStage(plan, StageKind::Overlay);
    endStage(plan);
    fillCounts(set, plan);
}

void Planner::fillCounts(const visibility::VisibleSet& set, FramePlan& plan) const {
    const Selection::Counts& selected = selection_.counts();
    plan.counts.visits = static_cast<std::uint32_t>(set.visits.size());
    plan.counts.cellsSeen = static_cast<std::uint32_t>(set.seen.size());
    plan.counts.instancesTested = selected.tested;
    plan.counts.instancesDrawn = selected.drawn;
    plan.counts.instancesCulled = selected.tested - selected.drawn;
    plan.counts.drawsUngated = selected.ungated;
    plan.counts.boundsTested = selected.boundsTested;
}

void Planner::fillConstants(const FrameView& frame, const visibility::VisibleSet& set,
                            FramePlan& plan) const {
    const Vec3& eye = frame.view.eye;
    const Vec3 eyeBlock(std::floor(eye.x / world::kBlockSize), std::floor(eye.y / world::kBlockSize), 0.0);
    const Vec3 local = eye - eyeBlock * world::kBlockSize;
    const Vec3f high(local);
    gpu::ViewConstants& c = plan.constants;
    c.clipFromEye = clipFromEye(frame);
    c.eyeHigh = {high, 0.0f};
    c.eyeLow = {Vec3f(local - Vec3(high)), 0.0f};
    c.eyeSteps = {Vec3f(glm::floor(local * double{world::kRangeSteps})), 0.0f};
    for (const world::Block& block : world_.blocks) {
        plan.blocks.emplace_back(static_cast<float>((block.coord.x - eyeBlock.x) * world::kBlockSize),
                                 static_cast<float>((block.coord.y - eyeBlock.y) * world::kBlockSize), 0.0f,
                                 0.0f);
    }
    const world::SkyState sky =
        world::skyAt(world_.sky, frame.dayGroup, world::timeOfLight(world_.sky, frame.timeOfDay));
    c.sunDirection = {sky.sunDirection, 0.0f};
    c.sunColour = {sky.sunColour, 0.0f};
    c.landAmbient = {sky.ambient, 0.0f};
    c.skyAmbient = {sky.thingsAmbient(), 0.0f};
    c.sealedAmbient = {Vec3f(kSealedAmbient), 0.0f};
    if (frame.viewerLight)
        c.viewerLight = {Vec3f(*frame.viewerLight - eye), kViewerIntensity};
    c.fogColour = {sky.fogColour, 1.0f};
    c.fogRange = {sky.fogNear, sky.fogFar, 0.0f, 0.0f};
    c.skyZenith = {sky.fogColour * Vec3f(kZenith[0], kZenith[1], kZenith[2]), 1.0f};
    c.voidColour = {frame.voidColour, 1.0f};
    c.rootZone =
        world_.spaces[set.visits[0].space].zone; // not the visit's: a flood may have zones of its own
    c.visitCount = static_cast<std::uint32_t>(set.visits.size());
    c.flags = (frame.exactCutOuts ? gpu::kFrameExactCutOuts : 0) |
              (frame.look == world::Look::Enhanced ? gpu::kFramePixelLamps : 0);
    placeDetails(world_.details, frame, c);
    c.nearPlane = static_cast<float>(frame.nearPlane);
    c.staticInstances = static_cast<std::uint32_t>(scene_.records().size());
    c.staticMembers = static_cast<std::uint32_t>(scene_.members().size());
    c.staticPieces = static_cast<std::uint32_t>(pieces_.pieces.size());
}

void Planner::placeLamps(const Vec3& eye, FramePlan& plan) {
    lamps_.clear();
    for (const world::Light& light : world_.lights) {
        const Vec3 offset = light.position - eye;
        lamps_.emplace_back(glm::dot(offset, offset), static_cast<std::uint32_t>(plan.lamps.size()));
        plan.lamps.push_back({{Vec3f(offset), light.falloff}, {light.colour, 0.0f}});
    }
    const std::size_t shining = std::min(lamps_.size(), kMostLamps);
    std::nth_element(lamps_.begin(), lamps_.begin() + static_cast<std::ptrdiff_t>(shining), lamps_.end());
    for (std::size_t i = 0; i < shining; ++i)
        plan.lamps[lamps_[i].second].colour.w = world_.lights[lamps_[i].second].intensity;
}

void Planner::addSolid(DrawClass drawn, bool several, FramePlan& plan) {
    beginBatch(programOf(drawn), several, plan);
    plan.batches.back().shells = scene_.mayBeShells(drawn);
    for (const SelectedRange& range : selection_.ranges()) {
        PieceRun run = pieces_.run(range.first, range.end, drawn);
        run.gated = range.gated;
        run.rects = rects_.of(range.zone);
        run.turn = isRootFirst_ ? range.turn : Turn::After;
        run.inRange = range.inRange;
        addRun(run, plan);
    }
    dynamicPieces_.moveRuns(drawn, plan);
    countTriangles(plan);
}

void Planner::planSolid(bool several, FramePlan& plan) {
    // The starts are scattered in memory. Without the prefetch, cache misses took a tenth of planning.
    for (const SelectedRange& range : selection_.ranges()) {
        prefetch(pieces_.starts[range.first]);
        prefetch(pieces_.starts[range.end]);
    }
    addSolid(DrawClass::Wall, several, plan);
    addSolid(DrawClass::Terrain, several, plan);
    plan.firstOccludee = static_cast<std::uint32_t>(plan.batches.size());
    addSolid(DrawClass::Opaque, several, plan);
    addSolid(DrawClass::CutOut, several, plan);
}

// The ground is drawn second, and its runs are the first, so that those of all meshes follow each other.
void Planner::planSolidRootFirst(const RectRun& openings, FramePlan& plan) {
    plan.constants.flags |= gpu::kFrameRootFirst;
    const std::size_t first = plan.batches.size();
    for (const DrawClass drawn :
         {DrawClass::Terrain, DrawClass::Wall, DrawClass::Opaque, DrawClass::CutOut}) {
        addSolid(drawn, false, plan);
        plan.batches.back().turn = Turn::Before;
    }
    plan.batches.push_back({Program::Clearing, false, openings.first, openings.count, openings.count});
    Batch ground = plan.batches[first], meshes = plan.batches[first + 3];
    ground.gated = meshes.gated = true;
    ground.turn = meshes.turn = Turn::After;
    meshes.first = ground.first + ground.count;
    meshes.count = static_cast<std::uint32_t>(plan.runs.size()) - meshes.first;
    meshes.draws += plan.batches[first + 1].draws + plan.batches[first + 2].draws;
    plan.batches.push_back(meshes); // first, because it hides ground
    plan.batches.push_back(ground);
    std::swap(plan.batches[first], plan.batches[first + 1]);
    plan.firstOccludee = static_cast<std::uint32_t>(plan.batches.size()); // the device culls none
}

void Planner::planPlainSky(const visibility::VisibleSet& set, const std::optional<RectRun>& openings,
                           FramePlan& plan) {
    const bool several = set.visits.size() > 1, seesSky = seesOutside(set);
    Batch batch{Program::SkyPlain, several || !seesSky, 0, 0, seesSky ? 1u : 0u};
    if (openings) {
        batch.gated = openings->count > 0;
        batch.first = openings->first;
        batch.count = openings->count;
    }
    plan.batches.push_back(batch);
}

void Planner::planSky(const FrameView& frame, const visibility::VisibleSet& set,
                      const std::optional<RectRun>& openings, FramePlan& plan) {
    const bool seesSky = seesOutside(set), several = set.visits.size() > 1;
    const bool hasCracks = several || isAtAnOpening(world_, set.visits.front().space, frame.view.eye);
    if (seesSky || (frame.fillsVoids && hasCracks))
        planPlainSky(set, openings, plan);
    if (!seesSky)
        return;
    placeSky(world_, frame, set.visits.front().space, sky_);
    // Where voids are drawn, the depth keeps objects behind everything out of them.
    const bool overLand = std::any_of(sky_.begin(), sky_.end(),
                                      [](const world::SkyPlacement& placed) { return placed.isOverLand; });
    beginBatch(Program::SkyObjects, several && (overLand || !frame.fillsVoids), plan);
    plan.plainSky = plainSkyBelow(world::coveredFrom(world_.sky, sky_), plan);
    for (const bool isOverLand : {false, true})
        addSkyObjects(world_, sky_, {isOverLand}, plan);
}

void Planner::planTransparent(const Vec3& eye, bool several, const world::DynamicState& dynamics,
                              FramePlan& plan) {
    transparent_.clear();
    for (const SelectedRange& range : selection_.ranges())
        transparent_.addStatic(scene_, eye, range.first, range.end);
    transparent_.addDynamic(dynamics, eye, dynamicPieces_, plan);
    // With several visits every draw is gated: blended instances are few, and equal gating makes fewer,
    // longer runs.
    beginBatch(Program::Blended, several, plan);
    transparent_.write(several, plan);
    countTriangles(plan);
}

} // namespace limen::frame
