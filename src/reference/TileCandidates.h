#pragma once

#include "reference/Pyramid.h"
#include "reference/SceneData.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace limen::reference {

/// What the rays of a tile may meet in one space, of one kind of surface, from near to far. It is gathered as far as a
/// ray has asked for it; the next rays find it there. Every triangle that a ray of the tile meets is among what it is
/// offered.
class TileSurfaces {
public:
    enum class Kind : std::uint8_t { Solid, Blended };

    /// Begins anew; keeps its capacity. `pyramid` must stay as it is.
    void begin(const SceneData& scene, const Pyramid& pyramid, const world::RangeSteps& eye,
               world::SpaceIndex space, Kind kind);

    /// A triangle, or a whole body's whose triangles are so small that each ray had better find its own.
    struct Found {
        float least = 0.0f; ///< nothing that follows is met before
        bool isFilling = false;
        double from = 0.0, to = 0.0; ///< it is met between these
        const TriangleSet* set = nullptr;
        const Triangle* triangle = nullptr; ///< null: all of the set
    };
    /// Calls visit(found) for what the ray of a pixel may meet after `after`, not beyond `farthest`, which `visit` may
    /// lower; roughly from near to far. Fillings are visited however far they lie.
    template <class Visit>
    void walk(std::uint32_t pixel, double after, const double& farthest, Visit&& visit);

private:
    /// A node or leaf that has not been opened yet: of a body's triangles, or of the bodies of a place.
    struct Pending {
        float least = 0.0f; ///< nothing in it is met before
        std::uint32_t child = 0, count = 0;
        std::uint16_t place = 0;
        bool isFilling = false;
        const TriangleSet* set = nullptr; ///< null: bodies
    };
    struct Place {
        const Bodies* bodies = nullptr;
        const BodyLists::List* list = nullptr;
        bool isEager = false; ///< may hold fillings: is opened however far it lies
    };
    static constexpr std::uint32_t kBlock = 64; ///< things found whose bits are kept together
    using Bits = std::array<std::uint64_t, Tile::kPixels>;

    /// Finds more if some may be met at `farthest` or before. False: there is none.
    bool gather(double farthest);
    void open(const Hierarchy& tree, const Pending& node);
    void openBody(const Pending& leaf, std::uint32_t body);
    void find(const Pending& leaf);
    void add(const Found& found, PixelMask pixels);

    const Pyramid* pyramid_ = nullptr;
    world::RangeSteps eye_;
    Kind kind_ = Kind::Solid;
    std::vector<Place> places_;
    std::vector<Pending> pending_; ///< a heap, the nearest first
    std::vector<Found> found_;
    std::vector<Bits> bits_; ///< by block and pixel: which of the block's things the pixel's ray may meet
};

/// What the rays of a tile may meet, space by space. For one thread.
class TileCandidates {
public:
    /// begin() must follow.
    explicit TileCandidates(const SceneData& scene) : scene_(scene) {}
    /// Begins with another tile; keeps its capacity.
    void begin(const Tile& tile);

    struct Space {
        world::SpaceIndex space = world::kOutside;
        TileSurfaces solid, blended;
        std::vector<world::PortalIndex> portals;
    };
    /// Stays valid until begin().
    [[nodiscard]] Space& in(world::SpaceIndex space);

private:
    const SceneData& scene_;
    std::optional<Pyramid> pyramid_;
    world::RangeSteps eye_;
    std::vector<std::unique_ptr<Space>> spaces_; ///< the first used_ of them are the tile's
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
