#pragma once

#include "geometry/Vec.h"

#include <cstdint>
#include <vector>

namespace limen::world {

/// Vertices nearer to each other than this are one vertex; a vertex nearer to an edge than this lies on it.
/// Metres. The dats store floats relative to frames of their own, so copies of one corner differ by some
/// hundredths of a millimetre; real details are centimetres apart.
inline constexpr double kWeldTolerance = 0.0002;

/// Gives positions that lie within kWeldTolerance of each other, directly or through others, one canonical
/// float position: that of the first one added. The result depends on the order of adding only in that way.
/// Cost: O(n) expected. Ref: union-find, Tarjan 1975.
class Welder {
public:
    /// Yields the index to ask for after weld(). The position must be finite and within 10^6 m of the origin.
    std::uint32_t add(const Vec3& position);
    void weld();

    /// The canonical vertex of an added position: an index into positions().
    [[nodiscard]] std::uint32_t vertexOf(std::uint32_t added) const { return vertexOf_[added]; }
    [[nodiscard]] const std::vector<Vec3f>& positions() const { return positions_; }

private:
    std::vector<Vec3> added_;
    std::vector<std::uint32_t> vertexOf_;
    std::vector<Vec3f> positions_;
};

} // namespace limen::world
