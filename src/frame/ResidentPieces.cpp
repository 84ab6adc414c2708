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

} // namespace limen::frame
