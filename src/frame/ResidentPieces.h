#pragma once

#include "frame/Clusters.h"
#include "frame/FramePlan.h"
#include "frame/GpuLayout.h"

#include <algorithm>
#include <array>

namespace limen::frame {

/// Which program draws a range of an instance's mesh.
enum class DrawClass : std::uint8_t {
    Wall, ///< opaque, of what is built: hides what is behind it
    Terrain,
    Opaque, ///< any other
    CutOut,
    Blended
};
inline constexpr std::size_t kDrawClasses = 5;

/// What draws the opaque part of an instance's mesh.
[[nodiscard]] constexpr DrawClass solidClassOf(world::InstanceKind kind) {
    const bool isBuilt = kind == world::InstanceKind::Shell || kind == world::InstanceKind::Exterior;
    return kind == world::InstanceKind::Terrain ? DrawClass::Terrain
                                                : (isBuilt ? DrawClass::Wall : DrawClass::Opaque);
}
/// Calls `draw(class, range)` for each class that may draw a part of an instance's mesh; parts may be empty. Surfaces that are split are
/// of two classes: as cut-outs they show where they are nearly opaque, blended where they are not.
template <class Draw>
void eachRangeOf(const world::Mesh& mesh, world::InstanceKind kind, const Draw& draw) {
    draw(solidClassOf(kind), mesh.ranges[0]);
    if (kind != world::InstanceKind::Terrain) {
        draw(DrawClass::CutOut,
             world::Mesh::Range{mesh.ranges[1].firstIndex, mesh.ranges[1].indexCount + mesh.splitIndexCount});
    }
    draw(DrawClass::Blended, mesh.ranges[2]);
}
static_assert(static_cast<int>(world::SurfaceClass::Opaque) == 0 &&
              static_cast<int>(world::SurfaceClass::CutOut) == 1 &&
              static_cast<int>(world::SurfaceClass::Blended) == 2);

/// Cuts a range of a mesh into pieces of at most gpu::kTrianglesPerPiece triangles. `indices`: of all pieces before.
inline void addPieces(const world::Mesh::Range& range, std::uint32_t instance, std::uint32_t& indices,
                      std::vector<gpu::DrawPiece>& pieces) {
    constexpr std::uint32_t kMost = 3 * gpu::kTrianglesPerPiece;
    for (std::uint32_t done = 0; done < range.indexCount; done += kMost) {
        const std::uint32_t count = std::min(range.indexCount - done, kMost);
        pieces.push_back({range.firstIndex + done, count / 3, instance, indices});
        indices += count;
    }
}

/// The pieces of all that stands still, by class, and in a class in the order of the clusters: what is near each other is one run of
/// each class.
struct ResidentPieces {
    /// Where the pieces of a position begin, and the indices of these.
    struct Start {
        std::array<std::uint32_t, kDrawClasses> piece{}, indices{};
    };
    std::vector<gpu::DrawPiece> pieces;
    std::vector<Start> starts; ///< by position, and one more

    /// The pieces of one class of the positions from `first` to before `end`.
    [[nodiscard]] PieceRun run(std::uint32_t first, std::uint32_t end, DrawClass drawn) const {
        const auto c = static_cast<std::size_t>(drawn);
        const Start &a = starts[first], &b = starts[end];
        return {a.piece[c], b.piece[c] - a.piece[c], a.indices[c], b.indices[c] - a.indices[c], false};
    }
};

[[nodiscard]] ResidentPieces buildPieces(const world::World& world, const Clusters& clusters);

} // namespace limen::frame
