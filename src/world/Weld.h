#pragma once

#include "geometry/Tolerances.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <vector>

namespace limen::world {

/// The storable position next to a block-local one: within 0.1 nanometres, or, of one more than 32 km away, 0.1 micrometres. It
/// is the exact sum of two floats, and exact relative to any origin within 1000 km that is a multiple of a block's size; so
/// meshes, portals and their global copies agree to the bit.
[[nodiscard]] Vec3 canonicalPosition(const Vec3& position);

/// Gives positions that lie within kWeldTolerance of each other, directly or through others, one canonical
/// position: that of the first one added, as it can be stored (canonicalPosition). The result depends on the order
/// of adding only in that way.
/// Cost: O(n) expected. Ref: union-find, Tarjan 1975.
class Welder {
public:
    /// Yields the index to ask for after weld(). The position must be finite and within 10^6 m of the origin.
    std::uint32_t add(const Vec3& position);
    void weld();

    /// The canonical vertex of an added position: an index into positions().
    [[nodiscard]] std::uint32_t vertexOf(std::uint32_t added) const { return vertexOf_[added]; }
    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }

private:
    std::vector<Vec3> added_;
    std::vector<std::uint32_t> vertexOf_;
    std::vector<Vec3> positions_;
};

} // namespace limen::world
