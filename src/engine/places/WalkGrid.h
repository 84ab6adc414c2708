#pragma once

#include "engine/places/Viewpoints.h"

#include <cstdint>

namespace limen::engine {

/// The ground of one block as squares of a metre on which a body may stand, for ways between buildings.
class WalkGrid {
public:
    /// Closed squares: obstacles at the height of a body, steep or missing ground, and the floors of the rooms
    /// behind `doors` (a way must not cut through a house).
    WalkGrid(Shapes& shapes, const BlockShape& block, const std::vector<FrontDoor>& doors);

    /// Eyes of the shortest way over open squares, without `from` and with `to`, corners only. Both ends are
    /// moved to the nearest open square within three metres. Empty if there is none.
    [[nodiscard]] std::vector<Vec3> way(const Vec3& from, const Vec3& to) const;
    /// The eye at the nearest open square within `metres`; none if there is none.
    [[nodiscard]] std::optional<Vec3> openNear(const Vec3& at, double metres) const;

private:
    static constexpr int kSide = 192; ///< squares along the block
    struct Square {
        int x, y;
    };
    [[nodiscard]] static std::size_t slot(int x, int y) {
        return static_cast<std::size_t>(x) * kSide + static_cast<std::size_t>(y);
    }
    [[nodiscard]] bool isOpen(int x, int y) const {
        return x >= 0 && y >= 0 && x < kSide && y < kSide && open_[slot(x, y)] != 0;
    }
    [[nodiscard]] std::optional<Square> squareNear(const Vec3& at, double metres) const;
    [[nodiscard]] bool isClear(Square from, Square to) const;
    [[nodiscard]] Vec3 eyeAt(Square square) const;
    void close(const Triangle& triangle, int depth);

    Vec3 origin_{0.0};
    std::vector<float> ground_;      ///< at the squares' middles
    std::vector<std::uint8_t> open_; ///< 1: a body can stand there
};

} // namespace limen::engine
