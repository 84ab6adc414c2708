#pragma once

#include "visibility/Candidate.h"

namespace limen::visibility {

/// Sorts the children of one visit from far to near. Two openings that overlap on the screen are compared in
/// the overlap: the farther one along a ray through both comes first. Any ray of the overlap decides, because
/// openings of one zone do not intersect each other. The hole around an opening comes before it. An opening
/// wholly covered by one nearer opening is dropped: no ray of this visit reaches it. If the overlaps have a
/// cycle, an opening is cut along the edges of the one that must precede it, and its parts are sorted
/// separately.
class SiblingOrder {
public:
    /// Reorders `list`. Openings that do not overlap are sorted by distance, far first, then by portal.
    void sort(CandidateList& list, FloodCounts& counts);

private:
    enum class Relation : std::uint8_t { None, Before, After, Covered };
    [[nodiscard]] Relation compare(const CandidateList& list, const Candidate& a, const Candidate& b);
    void relate(const CandidateList& list);
    [[nodiscard]] bool place(const CandidateList& list);
    /// Cuts one opening of a cycle; false if no cut divides any.
    [[nodiscard]] bool split(CandidateList& list);
    /// Writes the list with `cut` divided along the edges of `by` to next_; false if `cut` stays whole.
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
