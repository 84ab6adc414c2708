#pragma once

#include "visibility/Graph.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace limen::visibility {

/// An opening between two spaces.
struct OpeningDesc {
    std::uint32_t from = 0;
    std::uint32_t to = kNone;  ///< kNone: leads nowhere, as a window that shows only sky does
    std::vector<Vec3> polygon; ///< metres; flat, convex, counter-clockwise seen from inside `from`
    std::vector<Vec3>
        backPolygon{};   ///< the opening as `to` has it, counter-clockwise seen from inside `to`, if
                         ///< it differs: the opening is where both are. Empty: it is the same
    bool oneWay = false; ///< there is no way back from `to`
};

/// The numbers of an opening's portals in the graph, for the `closed` of flood(). kNone: there is none.
struct PortalPair {
    std::uint32_t out = kNone;  ///< leads from `from` to `to`
    std::uint32_t back = kNone; ///< leads back
    friend bool operator==(const PortalPair&, const PortalPair&) = default;
};

struct BuiltGraph {
    Graph graph;
    std::vector<PortalPair> openings; ///< by opening, in the order of addOpening
};

/// Collects spaces and openings in any order, and makes the arrays of a Graph from them: portals grouped by
/// space, reciprocal portals that name each other, indices of vertices.
class LIMEN_API GraphBuilder {
public:
    /// Metres by which a corner may be off the plane of its opening, or inside the hull of the others.
    static constexpr double kUneven = 0.001;

    /// Adds a space and returns its number: 0, 1, 2, ... Its zone is its own.
    std::uint32_t addSpace();
    /// Adds a space to the zone of an earlier one. The zone must be as SpaceDesc requires;
    /// checkZones tests it.
    std::uint32_t addSpaceInZoneOf(std::uint32_t other);
    /// Adds an opening and returns its number: 0, 1, 2, ... Faults are reported by `build`.
    std::uint32_t addOpening(OpeningDesc opening);

    /// The graph of all that was added. Cost: linear but for a sort of the openings. Errors: BadArgument for a
    /// space that does not exist, and for a polygon with fewer than three corners, with a corner that is not
    /// finite, without area, or uneven or dented by more than kUneven; for a second polygon on the same side.
    [[nodiscard]] Result<BuiltGraph> build() const;

private:
    std::vector<std::uint32_t> zoneOf_; ///< by space: the first space of its zone
    std::vector<OpeningDesc> openings_;
};

/// The reason why a polygon is no opening: a corner off its plane or inside the hull of the others by more than
/// `uneven` metres, no area, and so on; no value for a good one.
[[nodiscard]] LIMEN_API std::optional<std::string> faultOfOpening(std::span<const Vec3> polygon,
                                                                  double uneven);

} // namespace limen::visibility
