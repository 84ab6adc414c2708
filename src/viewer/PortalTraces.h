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

/// What became of a portal in a flood: the most that it came to in any visit.
struct PortalTrace {
    world::PortalIndex portal = world::kNone;
    visibility::PortalFate fate = visibility::PortalFate::NoArea;
    std::uint32_t visit = 0; ///< the first whose rays it came to that by
    friend bool operator==(const PortalTrace&, const PortalTrace&) = default;
};

/// Of every portal that a flood came to, each once, by number.
[[nodiscard]] std::vector<PortalTrace> portalTraces(const visibility::FloodTrace& trace);

/// How many came to each fate.
[[nodiscard]] std::array<std::size_t, visibility::kPortalFates>
countFates(std::span<const PortalTrace> traces);

/// In a few words, and in a colour.
[[nodiscard]] std::string_view nameOf(visibility::PortalFate fate);
[[nodiscard]] output::Rgb colourOf(visibility::PortalFate fate);

/// A portal in a line: which of which space, where it leads, and from which visit it was seen.
[[nodiscard]] std::string portalLabel(const world::World& world, const PortalTrace& trace);

/// A portal's edge in a picture, in NDC; it may leave the picture.
struct PortalLine {
    Vec2 from{0.0}, to{0.0};
    visibility::PortalFate fate = visibility::PortalFate::NoArea;
};

/// The outlines of portals as an eye sees them, walls or no walls; those that came to most last, so that they lie on top of their ways
/// back. What lies behind the eye is cut off.
[[nodiscard]] std::vector<PortalLine>
portalLines(const world::World& world, std::span<const PortalTrace> traces, const visibility::View& eye);

} // namespace limen::viewer
