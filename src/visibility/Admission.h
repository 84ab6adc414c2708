#pragma once

#include "visibility/Candidate.h"
#include "visibility/EyePaths.h"
#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/ScreenOpenings.h"

#include <span>
#include <vector>

namespace limen::visibility {

/// The input of one flood.
struct FloodInput {
    const Graph& graph;
    std::span<const std::uint8_t> closed; ///< by portal; empty: all open
    const View& view;
    const Rules& rules;
    Mat3 screen;                  ///< View::screenFromEye
    Mat3 eyeFromScreenTransposed; ///< takes a plane's normal from eye-relative to (x, y, w)
    FloodTrace* trace = nullptr;  ///< null: no trace
};

/// Metres by which a portal must extend beyond its visit's entry plane. A ray that enters through a plane
/// does not leave through the same plane (two openings in one wall).
inline constexpr double kBeyondEntry = 1e-6;

/// Decides through which openings the rays of a visit leave, and which of its rays.
class Admission {
public:
    /// Of a visit, for the tests of its openings.
    struct Summary {
        Rect rect;               ///< bounds of its region
        std::uint64_t chain = 0; ///< the bits (bitOf) of the portals of its chain
    };
    /// Buffers for clipping, kept for their capacity.
    struct Scratch {
        std::vector<Vec3> relative, beyond, region, whole, swap;
        EyePaths paths;
        std::vector<Summary> summaries; ///< by visit
    };

    /// Openings narrower than `smallest` (coneSize) are left out and counted. Reads the visits of `set`.
    Admission(const FloodInput& input, double smallest, const ScreenOpenings& openings, Scratch& scratch,
              VisibleSet& set)
        : in_(input), smallest_(smallest), openings_(openings), s_(scratch), set_(set) {}

    /// Appends the candidates for the rays that leave visit `index` through a portal of one of its spaces:
    /// none, one, or for an inexact pair also the hole around it. A portal that is refused gets an entry in
    /// the trace. `known`: the portal's outline on the screen; null: not known.
    template <bool kTraced>
    void admit(std::uint32_t index, std::uint32_t portal, const ScreenOpenings::Exit* known,
               CandidateList& children);
    /// Makes the summary of a visit that has been added to the set. `rect`: bounds of its region.
    void summarise(std::uint32_t index, const Rect& rect);

    /// The reason why no ray of the visit passes a portal of one of its spaces, as far as its position shows
    /// it.
    [[nodiscard]] PortalFate whyUnseen(std::uint32_t visit, std::uint32_t portal) const;

private:
    template <bool kTraced>
    void admitAtEye(std::uint32_t index, std::uint32_t portal, CandidateList& children);
    template <bool kTraced>
    void leave(std::uint32_t index, std::uint32_t portal, bool inPlane, CandidateList& children);
    [[nodiscard]] bool isWayBack(const Visit& visit, std::uint32_t portal) const;
    [[nodiscard]] bool isInChain(std::uint32_t visit, std::uint32_t portal) const;
    [[nodiscard]] bool isCutByReciprocal(const Visit& visit, const Graph::Portal& portal) const;
    [[nodiscard]] bool openingRegion(std::uint32_t index, const Graph::Portal& portal,
                                     const ScreenOpenings::Exit* known);
    void clipByReciprocal(const Graph::Portal& reciprocal);
    void addPair(const Visit& visit, Candidate candidate, CandidateList& children);
    void add(Candidate candidate, bool hole, CandidateList& children) const;

    const FloodInput& in_;
    double smallest_;
    const ScreenOpenings& openings_;
    Scratch& s_; ///< `region`: of the current opening
    VisibleSet& set_;
};

} // namespace limen::visibility
