#pragma once

#include <cstdint>
#include <vector>

namespace limen::visibility {

/// The fate of a visit's rays at one portal of a space that it sees. In ascending order of importance: of
/// several fates of one portal, the last in this list is the most informative.
enum class PortalFate : std::uint8_t {
    NoArea,        ///< the polygon has no area
    WayBack,       ///< the visit was entered through this opening
    WrongSide,     ///< the eye is behind the portal's plane: it leads towards the eye
    EdgeOn,        ///< the eye is in the plane but not in the opening, or in an opening that is closed
    BehindEye,     ///< all of the polygon is behind the eye
    BeforeEntry,   ///< no part of the polygon is beyond the visit's entry plane
    OutsideRegion, ///< no ray of the visit meets the polygon
    InChain,       ///< the rays have passed the portal before (possible if its polygon is not flat)
    Covered,       ///< nearer openings of the same visit take all rays that meet the polygon
    Budget,        ///< left out because of Limits::maxVisits
    PairMissed,    ///< all rays through the polygon miss the other one of its inexact pair: a hole
    LeadsNowhere,  ///< there is no space behind the portal: a hole
    Shut,          ///< the rays end at the filling of the closed portal
    WithinZone,    ///< the rays may enter another space of the same zone, where depth decides
    Admitted       ///< a visit
};
inline constexpr std::size_t kPortalFates = static_cast<std::size_t>(PortalFate::Admitted) + 1;

/// The decisions of a flood at each portal that it tested, in order, for display. A portal may have several entries, also of
/// one visit.
struct FloodTrace {
    struct Entry {
        std::uint32_t visit =
            0; ///< whose rays were tested; for an admitted portal, the parent of the new visit
        std::uint32_t portal = 0;
        PortalFate fate = PortalFate::NoArea;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> entries;

    void clear() { entries.clear(); }
};

/// Internal: adds an entry to the trace. A template, so that a flood without a trace has no cost.
template <bool kTraced>
void note([[maybe_unused]] FloodTrace* trace, [[maybe_unused]] std::uint32_t visit,
          [[maybe_unused]] std::uint32_t portal, [[maybe_unused]] PortalFate fate) {
    if constexpr (kTraced)
        trace->entries.push_back({visit, portal, fate});
}

} // namespace limen::visibility
