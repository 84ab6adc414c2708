#include "frame/ResidentPieces.h"

namespace limen::frame {

ResidentPieces buildPieces(const world::World& world, const Clusters& clusters) {
    ResidentPieces out;
    out.starts.resize(clusters.order.size() + 1);
    std::uint32_t indices = 0;
    for (std::size_t c = 0; c < kDrawClasses; ++c) {
        const auto mark = [&](std::size_t position) {
            out.starts[position].piece[c] = static_cast<std::uint32_t>(out.pieces.size());
            out.starts[position].indices[c] = indices;
        };
        for (std::size_t i = 0; i < clusters.order.size(); ++i) {
            const world::Instance& instance = world.instances[clusters.order[i]];
            mark(i);
            eachRangeOf(world.meshes[instance.mesh], instance.kind,
                        [&](DrawClass drawn, const world::Mesh::Range& range) {
                            if (static_cast<std::size_t>(drawn) == c)
                                addPieces(range, clusters.order[i], indices, out.pieces);
                        });
        }
        mark(clusters.order.size());
    }
    return out;
}

MeshPieces::MeshPieces(const world::World& world) {
    first.reserve(world.meshes.size());
    std::vector<gpu::DrawPiece> cut;
    for (const world::Mesh& mesh : world.meshes) {
        Piece* last = nullptr;
        const auto append = [&](const Piece& piece) {
            if (last == nullptr) {
                last = &first.emplace_back(piece);
            } else {
                last->next = static_cast<std::uint32_t>(more.size());
                last = &more.emplace_back(piece);
            }
        };
        eachRangeOf(
            mesh, world::InstanceKind::Dynamic, [&](DrawClass drawn, const world::Mesh::Range& range) {
                std::uint32_t indices = 0;
                cut.clear();
                addPieces(range, 0, indices, cut);
                for (const gpu::DrawPiece& piece : cut)
                    append({piece.firstIndex, piece.triangles, static_cast<std::uint32_t>(drawn), kNoMore});
            });
        if (last == nullptr)
            first.emplace_back();
    }
}

} // namespace limen::frame
