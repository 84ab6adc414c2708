#include "world/mesh/BakedGeometry.h"

#include <algorithm>

namespace limen::world {
namespace {

constexpr double kFarthestCorner = 500000.0; ///< metres; within the limits of the welder's grid
constexpr int kPasses = 4;                   ///< of stitching; a second one is rare, a third has not occurred

} // namespace

Mat3 normalMatrix(const Mat3& m) {
    return Mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

std::uint32_t BakedGeometry::add(SourcePolygon polygon, const Placement& placement) {
    LIMEN_ASSERT(corners_.empty(), "polygons are added before bake()");
    LIMEN_ASSERT(polygon.corners.size() >= 3, "readPolygons leaves out polygons with fewer corners");
    const Mat3 normals = normalMatrix(placement.linear);
    StitchLoop loop;
    for (SourcePolygon::Corner& corner : polygon.corners) {
        corner.position = placement.origin + placement.linear * corner.position;
        const Vec3& p = corner.position;
        if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kFarthestCorner))
            return kNone;
    }
    for (const SourcePolygon::Corner& corner : polygon.corners) {
        const Vec3 n = normals * corner.normal;
        const double length = glm::length(n);
        loop.push_back({welder_.add(corner.position), length > 0.0 ? Vec3f(n / length) : Vec3f(0.0f),
                        corner.front, corner.back});
    }
    polygon.corners.clear();
    sources_.push_back(std::move(polygon));
    loops_.push_back({std::move(loop)});
    return static_cast<std::uint32_t>(sources_.size() - 1);
}

void BakedGeometry::bake() {
    welder_.weld();
    corners_.resize(loops_.size());
    std::vector<StitchLoop> welded;
    for (std::size_t i = 0; i < loops_.size(); ++i) {
        welded.push_back(std::move(loops_[i].front()));
        for (StitchCorner& corner : welded.back()) {
            corner.vertex = welder_.vertexOf(corner.vertex);
            corners_[i].push_back(corner.vertex);
        }
    }
    Stitcher stitcher(welder_.positions());
    for (int pass = 0; pass < kPasses; ++pass) {
        for (std::size_t i = 0; i < loops_.size(); ++i)
            loops_[i] = stitcher.stitch(welded[i]);
        if (!stitcher.reconcile())
            return;
    }
}

} // namespace limen::world
