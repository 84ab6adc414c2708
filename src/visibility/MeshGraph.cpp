#include "visibility/MeshGraph.h"

#include "geometry/Bounds.h"
#include "visibility/OpeningMatch.h"
#include "visibility/WeldedMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace limen::visibility {

namespace {

/// Metres. A corner this near to the line between its neighbours is none.
constexpr double kStraight = 1e-6;

using Kind = OpeningMatch::Kind;

/// An opening as one mesh has it.
struct Side {
    std::uint32_t mesh = 0, opening = 0;
    std::vector<Vec3> polygon;
    Aabb box;
    std::uint32_t partner = kNone; ///< into the array of sides
    Kind kind = Kind::None;
};

/// The one loop that the edges make; empty if they make none, or several.
std::vector<std::uint32_t> loopOf(std::span<const WeldedMesh::Edge> edges) {
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [from, to] : edges)
        if (!next.emplace(from, to).second)
            return {}; // two ways on
    std::vector<std::uint32_t> loop;
    std::uint32_t at = edges.empty() ? kNone : edges.front().first;
    for (auto found = next.find(at); found != next.end(); found = next.find(at)) {
        loop.push_back(at);
        at = found->second;
        next.erase(found);
    }
    return next.empty() && !edges.empty() && at == edges.front().first ? loop : std::vector<std::uint32_t>{};
}

void dropStraightCorners(std::vector<Vec3>& polygon) {
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
        const Vec3& before = polygon[(i + polygon.size() - 1) % polygon.size()];
        const Vec3 along = polygon[(i + 1) % polygon.size()] - before;
        const double length = glm::length(along);
        if (length > 0.0 && glm::length(glm::cross(along, polygon[i] - before)) <= kStraight * length)
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

Result<void> addSides(const WeldedMesh& welded, std::uint32_t mesh, std::vector<Side>& sides) {
    std::map<std::uint32_t, std::vector<WeldedMesh::Edge>> edgesOf; ///< by opening
    for (const MeshFace& face : welded.mesh().faces) {
        if (face.opening == kNone)
            continue;
        const auto edges = welded.edgesOf(face);
        auto& all = edgesOf[face.opening];
        all.insert(all.end(), edges.begin(), edges.end());
    }
    for (auto& [opening, edges] : edgesOf) {
        cancelOpposites(edges);
        const std::vector<std::uint32_t> loop = loopOf(edges);
        const auto refuse = [&, number = opening](const std::string& why) {
            return fail(ErrorCode::BadArgument,
                        "opening " + std::to_string(number) + " of space " + std::to_string(mesh), why);
        };
        if (loop.empty())
            return refuse("its faces have no single outline");
        Side side{mesh, opening, {}, {}, kNone, Kind::None};
        for (const std::uint32_t vertex : loop)
            side.polygon.push_back(welded.at(vertex));
        dropStraightCorners(side.polygon);
        if (const auto fault = faultOfOpening(side.polygon, GraphBuilder::kUneven))
            return refuse("its outline " + *fault);
        for (const Vec3& corner : side.polygon)
            side.box.include(corner);
        sides.push_back(std::move(side));
    }
    return {};
}

bool areNear(const Aabb& a, const Aabb& b, double tolerance) {
    for (int axis = 0; axis < 3; ++axis)
        if (a.min[axis] > b.max[axis] + tolerance || b.min[axis] > a.max[axis] + tolerance)
            return false;
    return true;
}

/// Makes partners: equal polygons first, then those that overlap most.
void pairSides(std::vector<Side>& sides, double tolerance) {
    std::vector<PairProposal> proposals;
    for (std::uint32_t a = 0; a < sides.size(); ++a) {
        for (std::uint32_t b = a + 1; b < sides.size(); ++b) {
            if (sides[a].mesh == sides[b].mesh || !areNear(sides[a].box, sides[b].box, tolerance))
                continue;
            const OpeningMatch match = matchOpenings(sides[a].polygon, sides[b].polygon, tolerance);
            if (match.kind != Kind::None)
                proposals.push_back({match, a, b});
        }
    }
    sortBestFirst(proposals);
    for (const PairProposal& proposal : proposals) {
        Side &a = sides[proposal.a], &b = sides[proposal.b];
        if (a.partner != kNone || b.partner != kNone)
            continue;
        a.partner = proposal.b;
        b.partner = proposal.a;
        a.kind = b.kind = proposal.match.kind;
    }
}

/// The openings of the builder, each once: a pair by its first side.
OpeningDesc openingOf(std::span<const Side> sides, const Side& side, std::uint32_t outside) {
    OpeningDesc desc;
    desc.from = side.mesh;
    desc.to = side.partner == kNone ? outside : sides[side.partner].mesh;
    desc.polygon = side.polygon;
    if (side.kind == Kind::Overlap)
        desc.backPolygon = sides[side.partner].polygon;
    return desc;
}

Result<std::vector<Side>> sidesOf(std::span<const SpaceMesh> meshes, double tolerance) {
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < meshes.size(); ++i) {
        const std::string name = "space " + std::to_string(i);
        if (Result<void> closed = checkClosed(meshes[i], tolerance, name); !closed)
            return Failure(closed.error());
        const Result<WeldedMesh> welded = WeldedMesh::build(meshes[i], tolerance, name);
        if (!welded)
            return Failure(welded.error());
        if (Result<void> added = addSides(*welded, i, sides); !added)
            return Failure(added.error());
    }
    return sides;
}

} // namespace

Result<MeshGraph> graphFromMeshes(std::span<const SpaceMesh> meshes, const MeshGraphOptions& options) {
    if (!(options.tolerance >= 0.0 && std::isfinite(options.tolerance)))
        return fail(ErrorCode::BadArgument, "graph of meshes",
                    "the tolerance must be finite and not negative: " + std::to_string(options.tolerance));
    Result<std::vector<Side>> sides = sidesOf(meshes, options.tolerance);
    if (!sides)
        return Failure(sides.error());
    pairSides(*sides, options.tolerance);
    GraphBuilder builder;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        builder.addSpace();
    MeshGraph made;
    if (options.hasOutside)
        made.outside = builder.addSpace();
    std::vector<std::uint32_t> numbers; ///< by side: the builder's opening
    for (std::uint32_t i = 0; i < sides->size(); ++i) {
        const std::uint32_t partner = (*sides)[i].partner;
        numbers.push_back(partner < i ? numbers[partner]
                                      : builder.addOpening(openingOf(*sides, (*sides)[i], made.outside)));
    }
    Result<BuiltGraph> built = builder.build();
    if (!built)
        return Failure(built.error());
    for (std::uint32_t i = 0; i < sides->size(); ++i) {
        const Side& side = (*sides)[i];
        const PortalPair& pair = built->openings[numbers[i]];
        MeshOpening& opening = made.openings.emplace_back();
        opening.mesh = side.mesh;
        opening.opening = side.opening;
        opening.portal = side.partner < i ? pair.back : pair.out;
        opening.destination = side.partner == kNone ? made.outside : (*sides)[side.partner].mesh;
        opening.exact = side.kind != Kind::Overlap;
    }
    made.graph = std::move(built->graph);
    return made;
}

} // namespace limen::visibility
