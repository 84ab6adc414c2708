#pragma once

#include "frame/Clusters.h"
#include "frame/FramePlan.h"
#include "frame/GpuLayout.h"

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

/// The part of a mesh that a class draws of an instance; empty if there is none. Surfaces that are split are of two: as cut-outs
/// they show where they are nearly opaque, blended where they are not.
[[nodiscard]] inline world::Mesh::Range rangeOf(const world::Mesh& mesh, world::Kind kind, DrawClass drawn) {
    const bool isTerrain = kind == world::Kind::Terrain;
    const bool isBuilt = kind == world::Kind::Shell || kind == world::Kind::Exterior;
    switch (drawn) {
    case DrawClass::Wall:
        return isBuilt ? mesh.ranges[0] : world::Mesh::Range();
    case DrawClass::Opaque:
        return isTerrain || isBuilt ? world::Mesh::Range() : mesh.ranges[0];
    case DrawClass::CutOut:
        return isTerrain ? world::Mesh::Range()
                         : world::Mesh::Range{mesh.ranges[1].firstIndex,
                                              mesh.ranges[1].indexCount + mesh.splitIndexCount};
    case DrawClass::Terrain:
        return isTerrain ? mesh.ranges[0] : world::Mesh::Range();
    case DrawClass::Blended:
        return mesh.ranges[2];
    }
    return {};
}
static_assert(static_cast<int>(world::SurfaceClass::Opaque) == 0 &&
              static_cast<int>(world::SurfaceClass::CutOut) == 1 &&
              static_cast<int>(world::SurfaceClass::Blended) == 2);

/// Cuts a range of a mesh into pieces of at most gpu::kTrianglesPerPiece triangles. `indices`: of all pieces before.
void addPieces(const world::Mesh::Range& range, std::uint32_t instance, std::uint32_t& indices,
               std::vector<gpu::DrawPiece>& pieces);

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
