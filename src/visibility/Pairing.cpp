#include "visibility/Pairing.h"

#include "visibility/OpeningMatch.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace limen::visibility {

namespace {

using Kind = OpeningMatch::Kind;

using ByWay = std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>>;

/// The portals without a reciprocal, by space and destination.
ByWay singlesOf(std::span<const PortalDesc> portals) {
    ByWay singles;
    for (std::uint32_t i = 0; i < portals.size(); ++i)
        if (portals[i].destination != kNone && portals[i].reciprocal == kNone)
            singles[{portals[i].space, portals[i].destination}].push_back(i);
    return singles;
}

std::vector<PairProposal> proposalsFor(std::span<const PortalDesc> portals, std::span<const Vec3> vertices,
                                       double tolerance) {
    const auto polygon = [&](std::uint32_t i) {
        return vertices.subspan(portals[i].firstVertex, portals[i].vertexCount);
    };
    std::vector<PairProposal> proposals;
    const ByWay singles = singlesOf(portals);
    for (const auto& [way, there] : singles) {
        const auto back = singles.find({way.second, way.first});
        if (back == singles.end())
            continue;
        for (const std::uint32_t a : there)
            for (const std::uint32_t b : back->second) {
                if (a >= b) // each pair once; it is found from both ends
                    continue;
                const OpeningMatch match = matchOpenings(polygon(a), polygon(b), tolerance);
                if (match.kind != Kind::None)
                    proposals.push_back({match, a, b});
            }
    }
    sortBestFirst(proposals);
    return proposals;
}

} // namespace

Result<Pairing> pairReciprocals(std::span<PortalDesc> portals, std::span<const Vec3> vertices,
                                double tolerance) {
    if (!(tolerance >= 0.0 && std::isfinite(tolerance)))
        return fail(ErrorCode::BadArgument, "pairing of portals",
                    "the tolerance must be finite and not negative: " + std::to_string(tolerance));
    for (std::size_t i = 0; i < portals.size(); ++i)
        if (portals[i].firstVertex > vertices.size() ||
            portals[i].vertexCount > vertices.size() - portals[i].firstVertex)
            return fail(ErrorCode::BadArgument, "portal " + std::to_string(i),
                        "has vertices outside the array");
    Pairing pairing;
    for (const PairProposal& proposal : proposalsFor(portals, vertices, tolerance)) {
        PortalDesc &a = portals[proposal.a], &b = portals[proposal.b];
        if (a.reciprocal != kNone || b.reciprocal != kNone)
            continue;
        a.reciprocal = proposal.b;
        b.reciprocal = proposal.a;
        a.exact = b.exact = proposal.match.kind == Kind::Same;
        ++(a.exact ? pairing.exact : pairing.inexact);
    }
    for (const PortalDesc& portal : portals)
        pairing.single += portal.destination != kNone && portal.reciprocal == kNone ? 1 : 0;
    return pairing;
}

} // namespace limen::visibility
