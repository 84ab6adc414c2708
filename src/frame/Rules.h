#pragma once

namespace limen::frame {

/// Parts of the method that tests can switch off. Each part is necessary: without it some view is wrong (docs/proof.md),
/// and a test shows that the check notices.
struct Rules {
    bool ownership = true;    ///< off: every pixel belongs to the root
    bool ancestorClip = true; ///< off: openings are not clipped by the visits before them
    bool growth = true;       ///< off: the visits before clip at their exact edges
    bool nearOpening = true;  ///< off: openings within 5 cm of the eye are drawn like any other
    bool viewcone = true;     ///< off: an instance is tested only against the first visit that lists it
};

} // namespace limen::frame
