#include "frame/ResidentPieces.h"

#include <algorithm>

namespace limen::frame {

world::Mesh::Range rangeOf(const world::World& world, const world::Instance& instance, DrawClass drawn) {
    using world::SurfaceClass;
    const auto& ranges = world.meshes[instance.mesh].ranges;
    const bool isTerrain = instance.kind == world::Kind::Terrain;
    switch (drawn) {
    case DrawClass::Opaque:
        return isTerrain ? world::Mesh::Range() : ranges[static_cast<std::size_t>(SurfaceClass::Opaque)];
    case DrawClass::CutOut:
        return isTerrain ? world::Mesh::Range() : ranges[static_cast<std::size_t>(SurfaceClass::CutOut)];
    case DrawClass::Terrain:
        return isTerrain ? ranges[static_cast<std::size_t>(SurfaceClass::Opaque)] : world::Mesh::Range();
    case DrawClass::Blended:
        return ranges[static_cast<std::size_t>(SurfaceClass::Blended)];
    }
    return {};
}

void addPieces(const world::Mesh::Range& range, std::uint32_t instance, std::uint32_t& indices,
               std::vector<gpu::DrawPiece>& pieces) {
    constexpr std::uint32_t kMost = 3 * gpu::kTrianglesPerPiece;
    for (std::uint32_t done = 0; done < range.indexCount; done += kMost) {
        const std::uint32_t count = std::min(range.indexCount - done, kMost);
        pieces.push_back({range.firstIndex + done, count / 3, instance, indices});
        indices += count;
    }
}

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
            const std::uint32_t instance = clusters.order[i];
            mark(i);
            addPieces(rangeOf(world, world.instances[instance], static_cast<DrawClass>(c)), instance, indices,
                      out.pieces);
        }
        mark(clusters.order.size());
    }
    return out;
}

} // namespace limen::frame
