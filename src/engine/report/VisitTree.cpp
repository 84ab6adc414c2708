#include "engine/report/VisitTree.h"

#include "core/Assert.h"
#include "engine/report/FrameReport.h"
#include "engine/report/IdTable.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace limen::engine {

namespace {

/// Area of the visit's region as a share of the picture, 0..1.
double shareOf(const visibility::VisibleSet& visible, const visibility::Visit& visit) {
    std::vector<Vec2> corners = regionNdc(visible, visit);
    for (Vec2& corner : corners)
        corner = {std::clamp(corner.x, -1.0, 1.0), std::clamp(corner.y, -1.0, 1.0)};
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 8.0; // the picture's area in NDC is 4
}

/// The space that a visit leads into; for a hole, the reason why the rays end.
std::string targetOf(const world::World& world, const visibility::Visit& visit) {
    if (!visit.hole)
        return spaceName(world, visit.space);
    return visit.shut ? "shut" : "leads nowhere";
}

} // namespace

std::string visitLabel(const world::World& world, const visibility::VisibleSet& visible,
                       std::uint32_t visit) {
    LIMEN_ASSERT(visit < visible.visits.size(), "a visit of this frame");
    const visibility::Visit& of = visible.visits[visit];
    std::string label = fmt::format("{} {}", visit, targetOf(world, of));
    if (of.portal < world.portals.size()) {
        const world::Portal& portal = world.portals[of.portal];
        label += fmt::format(", portal {} of {}", portal.recordIndex, spaceName(world, portal.space));
    } else {
        label += ", the eye's";
    }
    label += fmt::format(", {:.3g} %", 100.0 * shareOf(visible, of));
    if (of.portal < world.portals.size() && of.inPlane)
        label += ", eye in its plane";
    if (of.split)
        label += ", a part of it";
    return label;
}

std::vector<std::string> seenBesides(const world::World& world, const visibility::VisibleSet& visible,
                                     std::uint32_t visit) {
    LIMEN_ASSERT(visit < visible.visits.size(), "a visit of this frame");
    std::vector<std::string> names;
    for (const visibility::SeenSpace& seen : visible.seen)
        if (seen.visit == visit && seen.space != visible.visits[visit].space)
            names.push_back(spaceName(world, seen.space));
    return names;
}

} // namespace limen::engine
