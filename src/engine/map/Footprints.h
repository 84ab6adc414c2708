#pragma once

#include "dat/records/Cells.h"
#include "geometry/Vec.h"
#include "world/records/Records.h"

#include <array>
#include <map>

namespace limen::engine {

/// The rectangle around a building's model seen from above, block-local metres. Corners in order around it.
using Footprint = std::array<Vec2, 4>;

/// Footprints of buildings; each model is read once. For one thread.
class Footprints {
public:
    /// The archive must outlive it.
    explicit Footprints(const dat::Archive& archive) : records_(archive) {}
    /// None: the model is missing, damaged or empty.
    [[nodiscard]] std::optional<Footprint> of(const dat::Building& building);

private:
    struct Extent {
        Vec2 least{0.0}, most{0.0};
        bool isEmpty = true;
        void add(const Vec3& point);
    };
    Extent extentOf(dat::RecordId model);
    void addMesh(dat::RecordId gfxObj, const dat::Frame& frame, const Vec3& scale, Extent& extent);

    world::Records records_;
    std::map<dat::RecordId, Extent> extents_;
};

} // namespace limen::engine
