#pragma once

namespace limen::frame {

/// Parts of the method. All are needed: each has a view that goes wrong without it (docs/proof.md), and tests switch
/// them off one by one to show that they would notice.
struct Rules {
    bool ownership = true;    ///< off: every pixel belongs to the root
    bool ancestorClip = true; ///< off: openings are drawn uncut by the visits before them
    bool growth = true;       ///< off: the visits before cut at their exact edges
    bool nearOpening = true;  ///< off: openings within 5 cm of the eye are drawn like any other
    bool viewcone = true;     ///< off: an instance is asked for only in the first visit that lists it
};

} // namespace limen::frame
