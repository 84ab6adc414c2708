#pragma once

#include <cstdint>
#include <vector>

namespace limen::visibility {

/// What became of the rays of a visit at one portal of a space that it sees. Weakest first: of a portal that several visits come to, the
/// last of these tells most.
enum class PortalFate : std::uint8_t {
    NoArea,        ///< the polygon has none
    WayBack,       ///< they came by this opening
    WrongSide,     ///< the eye is behind the portal's plane: it leads towards the eye
    EdgeOn,        ///< the eye is in the plane and not in the opening, or in an opening that is shut
    BehindEye,     ///< all of it lies behind the eye
    BeforeEntry,   ///< no part of it lies beyond the plane that the visit was entered by
    OutsideRegion, ///< no ray of the visit meets it
    InChain,       ///< they have passed it before (of polygons that are not flat)
    Covered,       ///< nearer openings of the same visit take all rays that meet it
    Budget,        ///< it was left out because of Limits::maxVisits
    PairMissed,    ///< all rays through it miss the other polygon of its inexact pair: a hole
    LeadsNowhere,  ///< there is no space behind it: a hole
    Shut,          ///< they end at what fills it
    WithinZone,    ///< they may go on into another space of the same zone, where depth decides
    Admitted       ///< they go on: a visit
};
inline constexpr std::size_t kPortalFates = static_cast<std::size_t>(PortalFate::Admitted) + 1;

/// What a flood decided at each portal that it came to, in the order it did: for people. Several entries a portal are possible, also of
/// one visit.
struct FloodTrace {
    struct Entry {
        std::uint32_t visit = 0; ///< whose rays; of those that were admitted, the parent
        std::uint32_t portal = 0;
        PortalFate fate = PortalFate::NoArea;
        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> entries;

    void clear() { entries.clear(); }
};

/// Notes what became of a portal. A template, so that a flood that nobody watches pays nothing for it.
template <bool kTraced>
void note([[maybe_unused]] FloodTrace* trace, [[maybe_unused]] std::uint32_t visit,
          [[maybe_unused]] std::uint32_t portal, [[maybe_unused]] PortalFate fate) {
    if constexpr (kTraced)
        trace->entries.push_back({visit, portal, fate});
}

} // namespace limen::visibility
