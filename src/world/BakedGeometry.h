#pragma once

#include "world/PolygonSource.h"
#include "world/Stitch.h"
#include "world/Weld.h"

#include <memory>

namespace limen::world {

/// Space of the geometry (block-local, a model's own) from a record's space.
struct Placement {
    Mat3 linear{1.0};
    Vec3 origin{0.0};
};

/// Takes normals along with positions under any scale: the cofactor matrix. Not unit ones.
[[nodiscard]] Mat3 normalMatrix(const Mat3& m);

/// Polygons that must meet without cracks: the shells, exteriors and portal polygons of a block, or the
/// polygons of a model. They are added, then baked together: corners welded to common positions, T-junctions
/// stitched.
class BakedGeometry {
public:
    /// Yields a handle, or kNone if the polygon comes to lie absurdly far away.
    std::uint32_t add(SourcePolygon polygon, const Placement& placement);
    void bake();

    /// The polygon as it was read; its corners are emptied.
    [[nodiscard]] const SourcePolygon& source(std::uint32_t handle) const { return sources_[handle]; }
    /// Its own corners after welding, nothing inserted: vertices().
    [[nodiscard]] const std::vector<std::uint32_t>& corners(std::uint32_t handle) const {
        return corners_[handle];
    }
    /// What became of it: none if it was thinner than the weld tolerance. Corners index vertices().
    [[nodiscard]] const std::vector<StitchLoop>& loops(std::uint32_t handle) const { return loops_[handle]; }
    [[nodiscard]] std::span<const Vec3> vertices() const { return welder_.positions(); }

private:
    Welder welder_;
    std::vector<SourcePolygon> sources_;
    std::vector<std::vector<std::uint32_t>> corners_;
    std::vector<std::vector<StitchLoop>> loops_;
};

} // namespace limen::world
