#pragma once

#include "core/Prefetch.h"
#include "frame/PlanBatches.h"
#include "frame/ResidentPieces.h"

#include <array>
#include <bit>
#include <span>
#include <vector>

namespace limen::frame {

/// The pieces of a frame's visible dynamic instances, by class, in the order in which they are added. Reuse
/// it: steady frames allocate nothing.
class DynamicPieces {
public:
    /// `meshes` must outlive it.
    explicit DynamicPieces(const MeshPieces& meshes) : meshes_(meshes) {}

    /// Forgets the pieces of the frame before. `plan`: the plan that the new ones are moved to.
    void begin(const FramePlan& plan);
    /// Adds the pieces of an instance. `number`: its number in the frame, after the scene's instances.
    void add(std::uint32_t mesh, std::uint32_t number, bool gated) {
        const MeshPieces::Piece* piece = &meshes_.first[mesh];
        addOne(*piece, number, gated);
        while (piece->next != MeshPieces::kNoMore)
            [[unlikely]] {
                piece = &meshes_.more[piece->next];
                addOne(*piece, number, gated);
            }
    }
    /// Prefetches the data that `add` reads.
    void prefetchFor(std::uint32_t mesh) const { prefetch(meshes_.first[mesh]); }

    /// Moves the pieces of one class into the plan, as runs of its last batch. Requires
    /// constants.staticPieces.
    void moveRuns(DrawClass drawn, FramePlan& plan);
    /// Moves the pieces of one class to the end of the plan's pieces, without runs; returns them there.
    std::span<const gpu::DrawPiece> movePieces(DrawClass drawn, FramePlan& plan);

private:
    struct Run {
        std::uint32_t firstPiece = 0, indicesBefore = 0;
        bool gated = false;
    };
    struct OfClass {
        std::vector<gpu::DrawPiece> pieces; ///< indicesBefore: within the class
        std::vector<Run> runs;              ///< each up to the next
        std::uint32_t indices = 0;          ///< of all pieces
        int gated = -1;                     ///< of the last run; -1: there is none
    };
    void addOne(const MeshPieces::Piece& piece, std::uint32_t number, bool gated) {
        OfClass& of = classes_[piece.drawn];
        if (piece.triangles == 0) [[unlikely]]
            return;
        if (of.gated != (gated ? 1 : 0)) [[unlikely]]
            beginRun(of, gated);
        of.pieces.push_back(std::bit_cast<gpu::DrawPiece>(piece));
        of.pieces.back().instance = number;
        of.pieces.back().indicesBefore = of.indices;
        of.indices += 3 * piece.triangles;
    }
    static void beginRun(OfClass& of, bool gated);

    const MeshPieces& meshes_;
    std::array<OfClass, kDrawClasses> classes_;
};

} // namespace limen::frame
