#pragma once

#include "output/Picture.h"
#include "visibility/FloodTrace.h"
#include "world/World.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace limen::visibility {
struct View;
}

namespace limen::viewer {

/// The fate of a portal in a flood: the strongest of its fates in all visits.
struct PortalTrace {
    world::PortalIndex portal = world::kNone;
    visibility::PortalFate fate = visibility::PortalFate::NoArea;
    std::uint32_t visit = 0; ///< the first visit with this fate
    friend bool operator==(const PortalTrace&, const PortalTrace&) = default;
};

/// One trace per portal that the flood tested, sorted by portal index.
[[nodiscard]] std::vector<PortalTrace> portalTraces(const visibility::FloodTrace& trace);

/// The number of portals of each fate.
[[nodiscard]] std::array<std::size_t, visibility::kPortalFates>
countFates(std::span<const PortalTrace> traces);

/// Description and colour of a fate. The description is also a key of the window's state JSON.
[[nodiscard]] std::string_view nameOf(visibility::PortalFate fate);
[[nodiscard]] output::Rgb colourOf(visibility::PortalFate fate);

/// One line of text: the portal's index and space, its destination, and the visit.
[[nodiscard]] std::string portalLabel(const world::World& world, const PortalTrace& trace);

/// An edge of a portal in NDC. It can extend beyond the picture.
struct PortalLine {
    Vec2 from{0.0}, to{0.0};
    visibility::PortalFate fate = visibility::PortalFate::NoArea;
};

/// The outlines of portals projected for an eye, ignoring walls. Strong fates come last, so that an admitted
/// portal is drawn over its reciprocal. Parts behind the eye are clipped.
[[nodiscard]] std::vector<PortalLine>
portalLines(const world::World& world, std::span<const PortalTrace> traces, const visibility::View& eye);

} // namespace limen::viewer
