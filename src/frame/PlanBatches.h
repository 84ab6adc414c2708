#pragma once

#include "frame/FramePlan.h"
#include "world/World.h"

// Writing a plan: stages one after the other, in them batches, in these runs of pieces.
namespace limen::frame {

void beginStage(FramePlan& plan, StageKind kind);
void endStage(FramePlan& plan);

/// Kept when nothing is added: a stage's calls are the same in every frame that has it.
void beginBatch(Program program, bool gated, FramePlan& plan);

/// Adds to the batch that was begun last. Runs that follow one another become one.
void addRun(const PieceRun& run, FramePlan& plan);

/// Cuts a range of a mesh, drawn for an instance of the plan's own, into pieces of the plan's own, which are a run together.
/// Requires constants.staticPieces.
[[nodiscard]] PieceRun addOwnPieces(const world::Mesh::Range& range, std::uint32_t instance, FramePlan& plan);

/// Counts those of the batch that was begun last.
void countTriangles(FramePlan& plan);

} // namespace limen::frame
