#pragma once

#include "core/Assert.h"
#include "world/mesh/Stitch.h"
#include "world/mesh/Weld.h"
#include "world/records/PolygonSource.h"

#include <memory>

namespace limen::world {

/// Transform from a record's space into the space of the geometry (block-local, or a model's own).
struct Placement {
    Mat3 linear{1.0};
    Vec3 origin{0.0};
};

/// The cofactor matrix: it transforms normals correctly under every scale. The results are not unit vectors.
[[nodiscard]] Mat3 normalMatrix(const Mat3& m);

/// Polygons that must meet without cracks: the shells, exteriors and portal polygons of a block, or the
/// polygons of a model. First all are added. Then bake() welds corners to common positions and stitches
/// T-junctions.
class BakedGeometry {
public:
    /// Yields a handle; kNone if a corner is not finite or more than 500 km from the origin.
    std::uint32_t add(SourcePolygon polygon, const Placement& placement);
    void bake();

    /// The polygon without its corners.
    [[nodiscard]] const SourcePolygon& source(std::uint32_t handle) const {
        LIMEN_ASSERT(handle < sources_.size(), "add() gave this handle");
        return sources_[handle];
    }
    /// The polygon's own corners after welding, without inserted ones: indices into vertices(). Requires
    /// bake().
    [[nodiscard]] const std::vector<std::uint32_t>& corners(std::uint32_t handle) const {
        LIMEN_ASSERT(handle < corners_.size(), "the polygon is baked");
        return corners_[handle];
    }
    /// The polygon after stitching; none if it was thinner than the weld tolerance. Requires bake().
    [[nodiscard]] const std::vector<StitchLoop>& loops(std::uint32_t handle) const {
        LIMEN_ASSERT(handle < corners_.size(), "the polygon is baked");
        return loops_[handle];
    }
    [[nodiscard]] std::span<const Vec3> vertices() const { return welder_.positions(); }

private:
    Welder welder_;
    std::vector<SourcePolygon> sources_;
    std::vector<std::vector<std::uint32_t>> corners_;
    std::vector<std::vector<StitchLoop>> loops_;
};

} // namespace limen::world
