#pragma once

#include "visibility/Candidate.h"

namespace limen::visibility {

/// Puts the children of one visit far to near. Two openings that overlap on the screen are compared where
/// they do: the farther one along a ray through both comes first (openings of one zone do not pierce each
/// other, so any ray of the overlap tells). The hole around an opening comes before it. An opening wholly covered by one nearer opening is dropped: no
/// ray of this visit reaches it. Should overlaps run in a circle, an opening is cut along the edges of the
/// one that must precede it, and its parts are ordered each for itself.
class SiblingOrder {
public:
    /// Reorders `list`; the order of openings that do not overlap is by distance, far first, then by portal.
    void sort(CandidateList& list, FloodCounts& counts);

private:
    enum class Relation : std::uint8_t { None, Before, After, Covered };
    [[nodiscard]] Relation compare(const CandidateList& list, const Candidate& a, const Candidate& b);
    void relate(const CandidateList& list);
    [[nodiscard]] bool place(const CandidateList& list);
    /// Cuts one of those that wait for each other; false if no cut would part anything.
    [[nodiscard]] bool split(CandidateList& list);
    /// The list with `cut` parted along the edges of `by`, in next_; false if that leaves it whole.
    [[nodiscard]] bool cutInto(const CandidateList& list, std::uint32_t cut, std::uint32_t by);
    void placeRest();

    std::vector<Relation> relations_;  ///< n × n; [i*n+j]: i comes before or after j, or is covered by j
    std::vector<std::uint32_t> order_; ///< placed so far
    std::vector<std::uint8_t> done_;
    std::vector<std::uint32_t> byDistance_;
    std::vector<double> distance_;
    std::vector<Vec3> overlap_, swap_, rest_;
    CandidateList next_;
};

} // namespace limen::visibility
