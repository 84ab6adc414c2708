#pragma once

#include "frame/Clusters.h"
#include "frame/FramePlan.h"
#include "frame/GpuLayout.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace limen::frame {

/// Selects the program that draws a range of an instance's mesh.
enum class DrawClass : std::uint8_t {
    Wall, ///< opaque parts of shells and exteriors, which occlude other instances
    Terrain,
    Opaque, ///< any other opaque part
    CutOut,
    Blended
};
inline constexpr std::size_t kDrawClasses = 5;

/// The class of the opaque part of an instance's mesh.
[[nodiscard]] constexpr DrawClass solidClassOf(world::InstanceKind kind) {
    const bool isBuilt = kind == world::InstanceKind::Shell || kind == world::InstanceKind::Exterior;
    return kind == world::InstanceKind::Terrain ? DrawClass::Terrain
                                                : (isBuilt ? DrawClass::Wall : DrawClass::Opaque);
}
/// Calls `draw(class, range)` for each class that can draw a part of an instance's mesh; ranges may be empty.
/// Split surfaces are in two classes: cut-outs where they are nearly opaque, blended elsewhere.
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

/// Cuts a range of a mesh into pieces of at most gpu::kTrianglesPerPiece triangles. `indices`: total of all
/// pieces before; advanced.
inline void addPieces(const world::Mesh::Range& range, std::uint32_t instance, std::uint32_t& indices,
                      std::vector<gpu::DrawPiece>& pieces) {
    constexpr std::uint32_t kMost = 3 * gpu::kTrianglesPerPiece;
    for (std::uint32_t done = 0; done < range.indexCount; done += kMost) {
        const std::uint32_t count = std::min(range.indexCount - done, kMost);
        pieces.push_back({range.firstIndex + done, count / 3, instance, indices});
        indices += count;
    }
}

/// The pieces of all static instances, by class, and within a class in the order of the clusters. So a range
/// of that order is one run of each class.
struct ResidentPieces {
    /// The first piece of a position, and the number of indices before it, by class.
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

/// The pieces of each mesh as a dynamic instance draws it, so that a frame only adds the instance's number.
/// Shells, exteriors and terrain are never dynamic: the opaque part is of DrawClass::Opaque.
struct MeshPieces {
    static constexpr std::uint32_t kNoMore = 0xFFFFFFFFu;
    /// Same size and first members as gpu::DrawPiece, so that one is made from it by a cast.
    struct Piece {
        std::uint32_t firstIndex = 0, triangles = 0; ///< triangles 0: the mesh is empty
        std::uint32_t drawn = 0;                     ///< a DrawClass
        std::uint32_t next = kNoMore;                ///< the next piece of the mesh, index into `more`
    };
    static_assert(sizeof(Piece) == sizeof(gpu::DrawPiece) && offsetof(gpu::DrawPiece, firstIndex) == 0 &&
                  offsetof(gpu::DrawPiece, triangles) == 4);
    explicit MeshPieces(const world::World& world);

    /// By mesh, its first piece. Nearly all meshes have one piece only, which one look-up then finds.
    std::vector<Piece> first;
    std::vector<Piece> more;
};

} // namespace limen::frame
