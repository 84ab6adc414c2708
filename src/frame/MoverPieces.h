#pragma once

#include "core/Fetch.h"
#include "frame/PlanBatches.h"
#include "frame/ResidentPieces.h"

#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <vector>

namespace limen::frame {

/// The pieces of what moves and is drawn in a frame, by class, in the order in which they are added. Reuse it: steady frames allocate
/// nothing.
class MoverPieces {
public:
    /// Cuts all meshes into pieces, so that a frame has only to number them. Requires the world to stay as it is.
    explicit MoverPieces(const world::World& world);

    /// Forgets those of the frame before. `plan`: what they go to.
    void begin(const FramePlan& plan);
    /// Those of an instance of the frame's own, by its number (after the scene's). Shells, exteriors and terrain do not move: what is
    /// solid is of DrawClass::Opaque.
    void add(std::uint32_t mesh, std::uint32_t number, bool gated) {
        const MeshPiece* piece = &meshes_[mesh];
        addOne(*piece, number, gated);
        while (piece->next != kNoMore)
            [[unlikely]] {
                piece = &more_[piece->next];
                addOne(*piece, number, gated);
            }
    }
    /// Begins to load what `add` reads.
    void fetchFor(std::uint32_t mesh) const { fetch(meshes_[mesh]); }

    /// Moves those of one class into the plan, as runs of the batch that was begun last. Requires constants.staticPieces.
    void moveRuns(DrawClass drawn, FramePlan& plan);
    /// Moves those of one class to the end of the plan's pieces, without runs; yields which of these they are.
    std::span<const gpu::DrawPiece> movePieces(DrawClass drawn, FramePlan& plan);

private:
    static constexpr std::uint32_t kNoMore = 0xFFFFFFFFu;
    /// As long as a gpu::DrawPiece, and begins as one.
    struct MeshPiece {
        std::uint32_t firstIndex = 0, triangles = 0; ///< no triangles: the mesh has none
        std::uint32_t drawn = 0;                     ///< a DrawClass
        std::uint32_t next = kNoMore;                ///< of the same mesh, index into more_
    };
    static_assert(offsetof(gpu::DrawPiece, firstIndex) == 0 && offsetof(gpu::DrawPiece, triangles) == 4);
    struct Run {
        std::uint32_t firstPiece = 0, indicesBefore = 0;
        bool gated = false;
    };
    struct OfClass {
        std::vector<gpu::DrawPiece> pieces; ///< indicesBefore: in the class
        std::vector<Run> runs;              ///< each up to the next
        std::uint32_t indices = 0;          ///< of all pieces
        int gated = -1;                     ///< the last run; -1: there is none
    };
    void addOne(const MeshPiece& piece, std::uint32_t number, bool gated) {
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

    /// By mesh, its first: nearly all have one alone, and what they have is looked up in one place.
    std::vector<MeshPiece> meshes_;
    std::vector<MeshPiece> more_;
    std::array<OfClass, kDrawClasses> classes_;
};

} // namespace limen::frame
