#pragma once

#include "frame/FramePlan.h"
#include "world/World.h"

#include <span>

// Writing a plan: stages one after the other, in them batches, in these runs of pieces.
namespace limen::frame {

void beginStage(FramePlan& plan, StageKind kind);
void endStage(FramePlan& plan);

/// Kept when nothing is added: a stage's calls are the same in every frame that has it.
void beginBatch(Program program, bool gated, FramePlan& plan);

/// Adds to the batch that was begun last. Runs that follow one another become one.
void addRun(const PieceRun& run, FramePlan& plan);

/// A range of a mesh that is drawn for an instance of the plan's own.
struct OwnRange {
    world::Mesh::Range range;
    std::uint32_t instance = 0; ///< numbered on from the scene's
    bool gated = false;
};
/// Cuts ranges into pieces of the plan's own, which are a run together. Requires constants.staticPieces.
[[nodiscard]] PieceRun addOwnPieces(std::span<const OwnRange> ranges, FramePlan& plan);

/// Counts those of the batch that was begun last.
void countTriangles(FramePlan& plan);

} // namespace limen::frame
