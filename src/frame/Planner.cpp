#include "frame/Planner.h"

#include "core/Assert.h"
#include "frame/Ownership.h"
#include "frame/PackInstance.h"

#include <algorithm>

namespace limen::frame {

namespace {

using visibility::Containment;

// Draws a range of a mesh, in as many commands as it takes.
void addCommands(const world::Mesh& mesh, const world::Mesh::Range& range, std::uint32_t instance,
                 FramePlan& plan) {
    constexpr std::uint32_t kMost = 3 * gpu::kTrianglesPerCommand;
    for (std::uint32_t done = 0; done < range.indexCount; done += kMost) {
        plan.commands.push_back({std::min(range.indexCount - done, kMost), 1, range.firstIndex + done,
                                 static_cast<std::int32_t>(mesh.firstVertex), instance});
    }
}

void beginStage(FramePlan& plan, StageKind kind) {
    plan.stages.push_back({kind, static_cast<std::uint32_t>(plan.batches.size()), 0});
}

void endStage(FramePlan& plan) {
    plan.stages.back().batchCount =
        static_cast<std::uint32_t>(plan.batches.size()) - plan.stages.back().firstBatch;
}

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

/// Straight up the plain sky is this much of the horizon's colour: bluer and darker.
constexpr float kZenith[3] = {0.42f, 0.58f, 0.86f};

} // namespace

Planner::Planner(const world::World& world) : world_(world) {
    std::vector<gpu::Member> zones;
    for (const world::Instance& in : world.instances) {
        zones.clear();
        const std::uint32_t count = packInstance(world, in, world.members, zones).memberCount;
        singleZone_.push_back(count == 1 ? 1 : 0);
        staticMembers_ += count;
    }
}

void Planner::packMovers(FramePlan& plan) {
    plan.constants.staticInstances = static_cast<std::uint32_t>(world_.instances.size());
    plan.constants.staticMembers = staticMembers_;
    singleZone_.resize(world_.instances.size());
    for (const world::Instance& in : moment_->instances) {
        gpu::Instance packed = packInstance(world_, in, moment_->members, plan.moverMembers);
        packed.firstMember += staticMembers_;
        singleZone_.push_back(packed.memberCount == 1 ? 1 : 0);
        plan.movers.push_back(packed);
    }
    marks_.resize(singleZone_.size());
}

void Planner::plan(const FrameView& frame, const world::Moment& moment, const visibility::VisibleSet& set,
                   FramePlan& plan) {
    LIMEN_ASSERT(!set.visits.empty(), "a flood yields at least the root");
    moment_ = &moment;
    plan.clear();
    fillConstants(frame, set, plan);
    packMovers(plan);
    beginStage(plan, StageKind::Ownership);
    planOwnership(world_, moment, frame, set, plan);
    const bool several = set.visits.size() > 1;
    if (several) {
        plan.batches.push_back(
            {Program::Ownership, false, 0, static_cast<std::uint32_t>(plan.ownershipVertices.size())});
    }
    endStage(plan);
    collect(frame, set, plan);
    finishDrawn(frame, set, plan);
    beginStage(plan, StageKind::Solid);
    planSolid(several, plan);
    endStage(plan);
    beginStage(plan, StageKind::Sky);
    planSky(frame, set, plan);
    endStage(plan);
    beginStage(plan, StageKind::Late);
    planLate(several, plan);
    endStage(plan);
    beginStage(plan, StageKind::Overlay);
    endStage(plan);
    plan.counts.visits = static_cast<std::uint32_t>(set.visits.size());
    plan.counts.cellsSeen = static_cast<std::uint32_t>(set.seen.size());
}

void Planner::fillConstants(const FrameView& frame, const visibility::VisibleSet& set,
                            FramePlan& plan) const {
    const Vec3& eye = frame.view.eye;
    const Vec3 eyeBlock(std::floor(eye.x / world::kBlockSize), std::floor(eye.y / world::kBlockSize), 0.0);
    const Vec3 local = eye - eyeBlock * world::kBlockSize;
    const Vec3f high(local);
    gpu::FrameConstants& c = plan.constants;
    c.clipFromEye = clipFromEye(frame);
    c.eyeHigh = {high, 0.0f};
    c.eyeLow = {Vec3f(local - Vec3(high)), 0.0f};
    for (const world::Block& block : world_.blocks) {
        plan.blocks.emplace_back(static_cast<float>((block.coord.x - eyeBlock.x) * world::kBlockSize),
                                 static_cast<float>((block.coord.y - eyeBlock.y) * world::kBlockSize), 0.0f,
                                 0.0f);
    }
    const world::SkyState sky = world::skyAt(world_.sky, frame.dayGroup, frame.timeOfDay);
    c.sunDirection = {sky.sunDirection, 0.0f};
    c.sunColour = {sky.sunColour, 0.0f};
    c.skyAmbient = {sky.ambient, 0.0f};
    c.fogColour = {sky.fogColour, 1.0f};
    c.fogRange = {sky.fogNear, sky.fogFar, 0.0f, 0.0f};
    c.skyZenith = {sky.fogColour * Vec3f(kZenith[0], kZenith[1], kZenith[2]), 1.0f};
    c.voidColour = {frame.voidColour, 1.0f};
    c.rootZone = set.visits[0].zone;
    c.visitCount = static_cast<std::uint32_t>(set.visits.size());
    c.flags = frame.exactCutOuts ? gpu::kFrameExactCutOuts : 0;
    c.nearPlane = static_cast<float>(frame.nearPlane);
}

void Planner::collect(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
    ++frameNumber_;
    met_.clear();
    const double pixel =
        2.0 * std::max(frame.view.tanHalfX / frame.width, frame.view.tanHalfY / frame.height);
    cones_.prepare(frame.view, set, pixel);
    for (const visibility::SeenSpace& seen : set.seen) {
        const world::Space& space = world_.spaces[seen.space];
        for (std::uint32_t i = space.firstInstance; i < space.firstInstance + space.instanceCount; ++i) {
            meet(frame, seen, world_.spaceInstances[i], plan);
        }
        for (const world::InstanceIndex moving : moment_->instancesIn(seen.space)) {
            meet(frame, seen, static_cast<std::uint32_t>(world_.instances.size()) + moving, plan);
        }
    }
}

void Planner::meet(const FrameView& frame, const visibility::SeenSpace& seen, world::InstanceIndex index,
                   FramePlan& plan) {
    Mark& mark = marks_[index];
    if (mark.frame != frameNumber_) {
        mark = {frameNumber_, Containment::Outside, false};
        met_.push_back(index);
    }
    const bool again = mark.tested;
    mark.tested = true;
    if (mark.seen == Containment::Inside || (again && !frame.rules.viewcone)) {
        return;
    }
    ++plan.counts.instancesTested;
    const Sphere& bounds = instance(index).bounds;
    const Sphere ball{bounds.centre - frame.view.eye, bounds.radius};
    const Containment here = cones_.classify(seen.visit, ball);
    if (here == Containment::Outside || !cones_.touches(seen.rect, ball)) {
        return;
    }
    mark.seen = here == Containment::Inside ? Containment::Inside : Containment::Partial;
}

void Planner::finishDrawn(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
    drawn_.clear();
    const bool several = set.visits.size() > 1;
    for (const std::uint32_t index : met_) {
        const Mark& mark = marks_[index];
        if (mark.seen == Containment::Outside) {
            ++plan.counts.instancesCulled;
            continue;
        }
        const Sphere& bounds = instance(index).bounds;
        const Vec3 offset = bounds.centre - frame.view.eye;
        // A member of several zones is lit by the zone that keeps each fragment, so it always takes the test.
        const bool gated = several && !(mark.seen == Containment::Inside && singleZone_[index] != 0);
        drawn_.push_back({std::sqrt(glm::dot(offset, offset)) - bounds.radius, index, gated});
        plan.counts.drawsUngated += gated ? 0 : 1;
    }
    plan.counts.instancesDrawn = static_cast<std::uint32_t>(drawn_.size());
    std::sort(drawn_.begin(), drawn_.end(), [](const Drawn& a, const Drawn& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.instance < b.instance;
    });
}

void Planner::addCommand(FramePlan& plan, std::uint32_t index, world::SurfaceClass surfaces) const {
    const world::Mesh& mesh = world_.meshes[instance(index).mesh];
    const world::Mesh::Range& range = mesh.ranges[static_cast<std::size_t>(surfaces)];
    addCommands(mesh, range, index, plan);
    plan.counts.triangles += range.indexCount / 3;
}

void Planner::addBatch(FramePlan& plan, Program program, bool gated, world::SurfaceClass surfaces,
                       bool terrain) const {
    Batch batch{program, gated, static_cast<std::uint32_t>(plan.commands.size()), 0};
    const auto add = [&](const Drawn& d) {
        const bool isTerrain = instance(d.instance).kind == world::Kind::Terrain;
        if (d.gated == gated && isTerrain == terrain) {
            addCommand(plan, d.instance, surfaces);
        }
    };
    std::for_each(drawn_.begin(), drawn_.end(), add);
    batch.commandCount = static_cast<std::uint32_t>(plan.commands.size()) - batch.firstCommand;
    plan.batches.push_back(batch); // kept when empty: a stage's calls are the same in every frame that has it
}

void Planner::planSolid(bool several, FramePlan& plan) const {
    using world::SurfaceClass;
    for (const bool gated : {false, true}) {
        if (gated && !several) {
            continue;
        }
        addBatch(plan, Program::Opaque, gated, SurfaceClass::Opaque, false);
        addBatch(plan, Program::CutOut, gated, SurfaceClass::CutOut, false);
        addBatch(plan, Program::Terrain, gated, SurfaceClass::Opaque, true);
    }
}

void Planner::planSky(const FrameView& frame, const visibility::VisibleSet& set, FramePlan& plan) {
    if (!seesOutside(set)) {
        return;
    }
    plan.batches.push_back({Program::SkyPlain, false, 0, 1});
    world::skyPlacements(world_.sky, frame.dayGroup, frame.timeOfDay, frame.seconds, sky_);
    Batch batch{Program::SkyObjects, false, static_cast<std::uint32_t>(plan.commands.size()), 0};
    for (const world::SkyPlacement& p : sky_) {
        const world::SkyPart& part = world_.sky.parts[p.part];
        const auto instance = static_cast<std::uint32_t>(plan.skyInstances.size());
        gpu::SkyInstance out;
        out.row0 = {p.rotation[0][0], p.rotation[1][0], p.rotation[2][0], 0.0f};
        out.row1 = {p.rotation[0][1], p.rotation[1][1], p.rotation[2][1], 0.0f};
        out.row2 = {p.rotation[0][2], p.rotation[1][2], p.rotation[2][2], 0.0f};
        out.firstMaterial = part.firstMaterial;
        out.opacity = 1.0f - p.transparent;
        out.luminosity = p.luminosity;
        out.uvOffsetX = p.uvOffset.x;
        out.uvOffsetY = p.uvOffset.y;
        plan.skyInstances.push_back(out);
        const world::Mesh& mesh = world_.meshes[part.mesh];
        for (const world::Mesh::Range& range : mesh.ranges) {
            addCommands(mesh, range, instance, plan);
        }
    }
    batch.commandCount = static_cast<std::uint32_t>(plan.commands.size()) - batch.firstCommand;
    plan.batches.push_back(batch);
}

void Planner::planLate(bool several, FramePlan& plan) const {
    // One list, back to front: gated for every draw as soon as a frame has several visits, so that no two
    // batches have to be interleaved.
    const bool gated = several;
    Batch batch{Program::Blended, gated, static_cast<std::uint32_t>(plan.commands.size()), 0};
    std::for_each(drawn_.rbegin(), drawn_.rend(),
                  [&](const Drawn& d) { addCommand(plan, d.instance, world::SurfaceClass::Blended); });
    batch.commandCount = static_cast<std::uint32_t>(plan.commands.size()) - batch.firstCommand;
    plan.batches.push_back(batch);
}

} // namespace limen::frame
