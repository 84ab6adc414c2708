#pragma once

#include "reference/Pyramid.h"
#include "reference/SceneData.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace limen::reference {

/// The triangles of one kind of surface that the rays of a tile may meet in one space, from near to far. They
/// are gathered as far as the rays so far needed them, and kept for the next rays. A ray is offered every
/// triangle that it meets.
class TileSurfaces {
public:
    enum class SurfaceKind : std::uint8_t { Solid, Blended };

    /// Begins with a space; keeps its capacity. `pyramid` must stay unchanged.
    void begin(const SceneData& scene, const Pyramid& pyramid, const world::RangeSteps& eye,
               world::SpaceIndex space, SurfaceKind kind);

    /// A triangle, or a whole set of triangles so small that each ray finds its own faster.
    struct Found {
        float least = 0.0f; ///< no later candidate is met before this parameter
        bool isFilling = false;
        double from = 0.0, to = 0.0; ///< the parameters between which it is met
        const TriangleSet* set = nullptr;
        const Triangle* triangle = nullptr; ///< null: the whole set
    };
    /// Calls visit(found) for the candidates of a pixel's ray after `after` and up to `farthest`, which
    /// `visit` may lower; roughly from near to far. Fillings are visited at any distance.
    template <class Visit>
    void walk(std::uint32_t pixel, double after, const double& farthest, Visit&& visit);

private:
    /// An unopened node or leaf, of a body's triangles or of a list of bodies.
    struct Pending {
        float least = 0.0f; ///< nothing in it is met before this parameter
        std::uint32_t child = 0, count = 0;
        std::uint16_t list = 0; ///< index into lists_
        bool isFilling = false;
        const TriangleSet* set = nullptr; ///< null: a node or leaf of bodies
    };
    /// A list of bodies that is searched.
    struct SearchedList {
        const Bodies* bodies = nullptr;
        const BodyLists::List* list = nullptr;
        bool isEager = false; ///< may contain fillings: opened at any distance
    };
    static constexpr std::uint32_t kBlock = 64; ///< candidates whose bits share a word
    using Bits = std::array<std::uint64_t, Tile::kPixels>;

    /// Gathers the next candidates that may be met up to `farthest`. False: there are none.
    bool gather(double farthest);
    void open(const Hierarchy& tree, const Pending& node);
    void openBody(const Pending& leaf, std::uint32_t body);
    void find(const Pending& leaf);
    void add(const Found& found, PixelMask pixels);

    const Pyramid* pyramid_ = nullptr;
    world::RangeSteps eye_;
    SurfaceKind kind_ = SurfaceKind::Solid;
    std::vector<SearchedList> lists_;
    std::vector<Pending> pending_; ///< a heap, the nearest first
    std::vector<Found> found_;
    std::vector<Bits> bits_; ///< by block and pixel: the block's candidates that the pixel's ray may meet
};

/// The candidates of a tile's rays, space by space. For one thread.
class TileCandidates {
public:
    /// Call begin() before use.
    explicit TileCandidates(const SceneData& scene) : scene_(scene) {}
    /// Begins with another tile; keeps its capacity.
    void begin(const Tile& tile);

    struct Space {
        world::SpaceIndex space = world::kOutside;
        TileSurfaces solid, blended;
        std::vector<world::PortalIndex> portals;
    };
    /// Valid until the next begin().
    [[nodiscard]] Space& in(world::SpaceIndex space);

private:
    const SceneData& scene_;
    std::optional<Pyramid> pyramid_;
    world::RangeSteps eye_;
    std::vector<std::unique_ptr<Space>> spaces_; ///< the first used_ belong to the current tile
    std::size_t used_ = 0;
};

template <class Visit>
void TileSurfaces::walk(std::uint32_t pixel, double after, const double& farthest, Visit&& visit) {
    std::size_t next = 0;
    do {
        while (next < found_.size()) {
            const std::uint64_t rest = bits_[next / kBlock][pixel] >> (next % kBlock);
            if (rest == 0) {
                next = std::min((next / kBlock + 1) * kBlock, found_.size());
                continue;
            }
            next += static_cast<std::size_t>(__builtin_ctzll(rest));
            const Found& found = found_[next++];
            if (static_cast<double>(found.least) > farthest)
                return;
            if (found.to >= after && (found.from <= farthest || found.isFilling))
                visit(found);
        }
    } while (gather(farthest));
}

} // namespace limen::reference
