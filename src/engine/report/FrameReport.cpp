#include "engine/report/FrameReport.h"

#include <algorithm>

namespace limen::engine {

std::vector<Vec2> regionNdc(const visibility::VisibleSet& visible, const visibility::Visit& visit) {
    constexpr double kAtEye = 1e-12; // metres forward of the eye; positions in files are much coarser
    std::vector<Vec2> corners;
    for (const Vec3& corner : visible.region(visit))
        if (corner.z > kAtEye)
            corners.emplace_back(corner.x / corner.z, corner.y / corner.z);
    return corners;
}

std::vector<std::vector<Vec2>> regionOutlines(const visibility::VisibleSet& visible) {
    std::vector<std::vector<Vec2>> outlines;
    for (const visibility::Visit& visit : visible.visits)
        outlines.push_back(regionNdc(visible, visit));
    return outlines;
}

std::vector<dat::RecordId> cellsSeen(const world::World& world, const visibility::VisibleSet& visible) {
    std::vector<dat::RecordId> cells;
    for (const visibility::SeenSpace& seen : visible.seen)
        if (seen.space != world::kOutside && seen.space < world.spaces.size())
            cells.push_back(world.spaces[seen.space].cellId);
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    return cells;
}

} // namespace limen::engine
