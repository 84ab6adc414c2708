#pragma once

#include "core/Assert.h"
#include "geometry/Tolerances.h"
#include "geometry/Vec.h"

#include <cstdint>
#include <vector>

namespace limen::world {

/// The storable position nearest to a block-local one: within 0.1 nm, or 0.1 um beyond 32 km. It is the exact
/// sum of two floats, and exact relative to every origin within 1000 km that is a multiple of a block's size.
/// So meshes, portals and their global copies agree to the bit.
[[nodiscard]] Vec3 canonicalPosition(const Vec3& position);

/// Gives all positions within kWeldTolerance of each other, directly or through others, one canonical
/// position: that of the first one added, as canonicalPosition stores it. The order of adding has no other
/// effect. Cost: O(n) expected. Ref: union-find, Tarjan 1975.
class Welder {
public:
    /// Yields the argument for vertexOf(). The position must be finite and within 10^6 m of the origin.
    std::uint32_t add(const Vec3& position);
    void weld();

    /// The canonical vertex of an added position: an index into positions(). Requires weld().
    [[nodiscard]] std::uint32_t vertexOf(std::uint32_t added) const {
        LIMEN_ASSERT(added < vertexOf_.size(), "the position was added before weld()");
        return vertexOf_[added];
    }
    [[nodiscard]] const std::vector<Vec3>& positions() const { return positions_; }

private:
    std::vector<Vec3> added_;
    std::vector<std::uint32_t> vertexOf_;
    std::vector<Vec3> positions_;
};

} // namespace limen::world
