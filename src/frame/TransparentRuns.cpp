#include "frame/TransparentRuns.h"

#include "frame/PlanBatches.h"

#include <algorithm>

namespace limen::frame {

namespace {

/// From the eye to the nearest point of a sphere, metres; negative inside it.
double nearestOf(const Sphere& sphere, const Vec3& eye) {
    const Vec3 offset = sphere.centre - eye;
    return std::sqrt(glm::dot(offset, offset)) - sphere.radius;
}

} // namespace

template <class BoundsOf>
void TransparentRuns::gather(const Vec3& eye, std::span<const gpu::DrawPiece> pieces, std::uint32_t first,
                             const BoundsOf& boundsOf) {
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        const gpu::DrawPiece& piece = pieces[i];
        if (runs_.empty() || runs_.back().instance != piece.instance) {
            runs_.push_back({nearestOf(boundsOf(piece.instance), eye),
                             piece.instance,
                             {first + i, 0, piece.indicesBefore, 0, false}});
        }
        ++runs_.back().run.pieceCount;
        runs_.back().run.indexCount += 3 * piece.triangles;
    }
}

void TransparentRuns::addStatic(const StaticScene& scene, const Vec3& eye, std::uint32_t first,
                                std::uint32_t end) {
    const PieceRun all = scene.pieces().run(first, end, DrawClass::Blended);
    gather(eye, std::span(scene.pieces().pieces).subspan(all.firstPiece, all.pieceCount), all.firstPiece,
           [&](std::uint32_t instance) { return scene.world().instances[instance].bounds; });
}

void TransparentRuns::addRun(const PieceRun& run, std::uint32_t instance, const Sphere& bounds,
                             const Vec3& eye) {
    if (run.pieceCount > 0)
        runs_.push_back({nearestOf(bounds, eye), instance, run});
}

void TransparentRuns::addDynamic(const world::DynamicState& dynamics, const Vec3& eye, DynamicPieces& pieces,
                                 FramePlan& plan) {
    const auto first = plan.constants.staticPieces + static_cast<std::uint32_t>(plan.pieces.size());
    gather(eye, pieces.movePieces(DrawClass::Blended, plan), first, [&](std::uint32_t instance) {
        return dynamics.instances[plan.dynamicInstances[instance - plan.constants.staticInstances]].bounds;
    });
}

void TransparentRuns::write(bool gated, FramePlan& plan) {
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) {
        return a.distance != b.distance ? a.distance > b.distance : a.instance > b.instance;
    });
    for (Run& each : runs_) {
        each.run.gated = gated;
        frame::addRun(each.run, plan);
    }
}

} // namespace limen::frame
