#include "frame/PlanBatches.h"

namespace limen::frame {

Program programOf(DrawClass drawn) {
    switch (drawn) {
    case DrawClass::Wall:
    case DrawClass::Opaque:
        return Program::Opaque;
    case DrawClass::Terrain:
        return Program::Terrain;
    case DrawClass::CutOut:
        return Program::CutOut;
    case DrawClass::Blended:
        return Program::Blended;
    }
    return Program::Opaque;
}

void beginStage(FramePlan& plan, StageKind kind) {
    plan.stages.push_back({kind, static_cast<std::uint32_t>(plan.batches.size()), 0});
}

void endStage(FramePlan& plan) {
    plan.stages.back().batchCount =
        static_cast<std::uint32_t>(plan.batches.size()) - plan.stages.back().firstBatch;
}

void beginBatch(Program program, bool gated, FramePlan& plan) {
    plan.batches.push_back({program, gated, static_cast<std::uint32_t>(plan.runs.size()), 0, 0});
}

void addRun(const PieceRun& run, FramePlan& plan) {
    if (run.pieceCount == 0)
        return;
    Batch& batch = plan.batches.back();
    batch.draws += run.pieceCount;
    PieceRun* last = batch.count > 0 ? &plan.runs.back() : nullptr;
    if (last != nullptr && last->gated == run.gated && last->rects == run.rects && last->turn == run.turn &&
        last->inRange == run.inRange && last->firstPiece + last->pieceCount == run.firstPiece &&
        last->indicesBefore + last->indexCount == run.indicesBefore) {
        last->pieceCount += run.pieceCount;
        last->indexCount += run.indexCount;
        return;
    }
    plan.runs.push_back(run);
    ++batch.count;
}

PieceRun addOwnPieces(const world::Mesh::Range& range, std::uint32_t instance, FramePlan& plan) {
    const auto first = static_cast<std::uint32_t>(plan.pieces.size());
    std::uint32_t before = 0;
    if (first > 0) {
        const gpu::DrawPiece& last = plan.pieces.back();
        before = last.indicesBefore + 3 * (last.triangles & ~gpu::kNeverCulled);
    }
    std::uint32_t indices = before;
    addPieces(range, instance, indices, plan.pieces);
    return {plan.constants.staticPieces + first, static_cast<std::uint32_t>(plan.pieces.size()) - first,
            before, indices - before, false};
}

void countTriangles(FramePlan& plan) {
    const Batch& batch = plan.batches.back();
    for (std::uint32_t i = batch.first; i < batch.first + batch.count; ++i)
        plan.counts.triangles += plan.runs[i].indexCount / 3;
}

} // namespace limen::frame
