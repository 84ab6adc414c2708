#pragma once

#include "frame/FramePlan.h"
#include "frame/ResidentPieces.h"
#include "world/World.h"

// Functions that write a plan: its stages in order, in each its batches, in each batch its runs of pieces.
namespace limen::frame {

/// The program that draws a class.
[[nodiscard]] Program programOf(DrawClass drawn);

void beginStage(FramePlan& plan, StageKind kind);
void endStage(FramePlan& plan);

/// Begins a batch, which stays in the plan even if it remains empty: then a stage makes the same GL calls in
/// every frame that has it.
void beginBatch(Program program, bool gated, FramePlan& plan);

/// Adds a run to the last batch. Consecutive runs are merged.
void addRun(const PieceRun& run, FramePlan& plan);

/// Cuts a range of a mesh into pieces of the plan's own, for one of the plan's own instances. Requires
/// constants.staticPieces.
[[nodiscard]] PieceRun addOwnPieces(const world::Mesh::Range& range, std::uint32_t instance, FramePlan& plan);

/// Adds the triangles of the last batch to the plan's counts.
void countTriangles(FramePlan& plan);

} // namespace limen::frame
