#include "world/block/CellClosure.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "world/PolygonDistance.h"

#include <algorithm>

namespace limen::world {
namespace {

/// Metres. An edge farther inside a wall's border than this is in its middle; an edge nearer to its plane is
/// on it.
constexpr double kInside = 0.001;

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

} // namespace

void CellClosure::addDrawn(const StitchLoop& loop, bool front, bool back) {
    std::vector<Vec3> wall;
    for (const StitchCorner& corner : loop)
        wall.push_back(vertices_[corner.vertex]);
    walls_.push_back(std::move(wall));
    if (front != back)
        addEdges(loop, front ? 1 : -1);
}

void CellClosure::addEdges(const StitchLoop& loop, int direction) {
    LIMEN_ASSERT(direction == 1 || direction == -1, "as it is, or reversed");
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t a = loop[i].vertex, b = loop[(i + 1) % loop.size()].vertex;
        balance_[edgeKey(a, b)] += a < b ? direction : -direction;
    }
}

int CellClosure::fit(const StitchLoop& portal) const {
    int fit = 0;
    for (std::size_t i = 0; i < portal.size(); ++i) {
        const std::uint32_t a = portal[i].vertex, b = portal[(i + 1) % portal.size()].vertex;
        const auto found = balance_.find(edgeKey(a, b));
        if (found != balance_.end() && found->second != 0)
            fit += (found->second < 0) == (a < b) ? 1 : -1;
    }
    return fit;
}

bool CellClosure::isOnAWall(std::uint32_t a, std::uint32_t b) const {
    const Vec3 from(vertices_[a]), to(vertices_[b]), middle = (from + to) * 0.5;
    return std::any_of(walls_.begin(), walls_.end(), [&](const std::vector<Vec3>& wall) {
        const Plane plane = planeOf(wall);
        return plane.n != Vec3(0.0) && std::abs(plane.signedDistance(middle)) < kInside &&
               containsProjection(wall, plane.n, middle, -kInside) &&
               distanceToPolygon(wall, plane, from) < kInside && distanceToPolygon(wall, plane, to) < kInside;
    });
}

std::size_t CellClosure::openEdges(std::size_t limit, std::uint64_t* first) const {
    std::size_t open = 0;
    std::size_t tested = 0;
    for (const auto& [key, balance] : balance_) {
        if (balance == 0)
            continue;
        // The search is limited: a cell with more such edges is certainly open.
        if (++tested <= 256 &&
            isOnAWall(static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)))
            continue;
        if (first != nullptr && (open == 0 || key < *first))
            *first = key;
        if (++open >= limit)
            break;
    }
    return open;
}

std::string CellClosure::describe() const {
    std::uint64_t first = 0;
    const std::size_t open = openEdges(vertices_.size() * 2 + 1, &first);
    LIMEN_ASSERT(open > 0, "only an open cell is described");
    const Vec3 a = vertices_[static_cast<std::uint32_t>(first >> 32)],
               b = vertices_[static_cast<std::uint32_t>(first)];
    const auto text = [](const Vec3& p) {
        return std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z);
    };
    return std::to_string(open) + " open edges, one from " + text(a) + " to " + text(b);
}

} // namespace limen::world
