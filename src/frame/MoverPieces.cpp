#include "frame/MoverPieces.h"

namespace limen::frame {

MoverPieces::MoverPieces(const world::World& world) {
    meshes_.reserve(world.meshes.size());
    std::vector<gpu::DrawPiece> cut;
    for (const world::Mesh& mesh : world.meshes) {
        MeshPiece* last = nullptr;
        const auto append = [&](const MeshPiece& piece) {
            if (last == nullptr) {
                last = &meshes_.emplace_back(piece);
            } else {
                last->next = static_cast<std::uint32_t>(more_.size());
                last = &more_.emplace_back(piece);
            }
        };
        eachRangeOf(
            mesh, world::InstanceKind::Dynamic, [&](DrawClass drawn, const world::Mesh::Range& range) {
                std::uint32_t indices = 0;
                cut.clear();
                addPieces(range, 0, indices, cut);
                for (const gpu::DrawPiece& piece : cut) {
                    append({piece.firstIndex, piece.triangles, static_cast<std::uint32_t>(drawn), kNoMore});
                }
            });
        if (last == nullptr)
            meshes_.emplace_back();
    }
}

void MoverPieces::begin(const FramePlan& plan) {
    // The two change places (movePieces), and a steady frame allocates nothing whichever it has.
    classes_[static_cast<std::size_t>(DrawClass::Opaque)].pieces.reserve(plan.pieces.capacity());
    for (OfClass& of : classes_) {
        of.pieces.clear();
        of.runs.clear();
        of.indices = 0;
        of.gated = -1;
    }
}

void MoverPieces::beginRun(OfClass& of, bool gated) {
    of.runs.push_back({static_cast<std::uint32_t>(of.pieces.size()), of.indices, gated});
    of.gated = gated ? 1 : 0;
}

std::span<const gpu::DrawPiece> MoverPieces::movePieces(DrawClass drawn, FramePlan& plan) {
    std::vector<gpu::DrawPiece>& pieces = classes_[static_cast<std::size_t>(drawn)].pieces;
    const std::size_t first = plan.pieces.size(), count = pieces.size();
    if (first == 0 && drawn == DrawClass::Opaque) // mostly all there are: they are not copied
        plan.pieces.swap(pieces);
    else
        plan.pieces.insert(plan.pieces.end(), pieces.begin(), pieces.end());
    pieces.clear();
    return std::span(plan.pieces).subspan(first, count);
}

void MoverPieces::moveRuns(DrawClass drawn, FramePlan& plan) {
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
