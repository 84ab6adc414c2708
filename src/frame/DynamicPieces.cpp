#include "frame/DynamicPieces.h"

namespace limen::frame {

void DynamicPieces::begin(const FramePlan& plan) {
    // movePieces swaps these two vectors. Equal capacities keep a steady frame free of allocations.
    classes_[static_cast<std::size_t>(DrawClass::Opaque)].pieces.reserve(plan.pieces.capacity());
    for (OfClass& of : classes_) {
        of.pieces.clear();
        of.runs.clear();
        of.indices = 0;
        of.gated = -1;
    }
}

void DynamicPieces::beginRun(OfClass& of, bool gated) {
    of.runs.push_back({static_cast<std::uint32_t>(of.pieces.size()), of.indices, gated});
    of.gated = gated ? 1 : 0;
}

std::span<const gpu::DrawPiece> DynamicPieces::movePieces(DrawClass drawn, FramePlan& plan) {
    std::vector<gpu::DrawPiece>& pieces = classes_[static_cast<std::size_t>(drawn)].pieces;
    const std::size_t first = plan.pieces.size(), count = pieces.size();
    if (first == 0 && drawn == DrawClass::Opaque) // most pieces are opaque: they are not copied
        plan.pieces.swap(pieces);
    else
        plan.pieces.insert(plan.pieces.end(), pieces.begin(), pieces.end());
    pieces.clear();
    return std::span(plan.pieces).subspan(first, count);
}

void DynamicPieces::moveRuns(DrawClass drawn, FramePlan& plan) {
    const OfClass& of = classes_[static_cast<std::size_t>(drawn)];
    const std::uint32_t first = plan.constants.staticPieces + static_cast<std::uint32_t>(plan.pieces.size());
    const auto count = static_cast<std::uint32_t>(movePieces(drawn, plan).size());
    for (std::size_t i = 0; i < of.runs.size(); ++i) {
        const Run& run = of.runs[i];
        const bool isLast = i + 1 == of.runs.size();
        const std::uint32_t endPiece = isLast ? count : of.runs[i + 1].firstPiece;
        const std::uint32_t endIndices = isLast ? of.indices : of.runs[i + 1].indicesBefore;
        addRun({first + run.firstPiece, endPiece - run.firstPiece, run.indicesBefore,
                endIndices - run.indicesBefore, run.gated},
               plan);
    }
}

} // namespace limen::frame
