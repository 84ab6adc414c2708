#include "world/block/OpeningOverlay.h"

#include "world/block/PlanarFaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace limen::world {
namespace {

using Loop = OpeningOverlay::Loop;

/// Metres. Edges that miss each other by no more than this meet in one vertex.
constexpr double kMeet = 1e-7;
/// The most that a vertex moves from the crossing, as a share of the way to the next vertex of its edge.
constexpr double kMostShift = 0.25;
/// Square metres. The parts of an outline together have its area, up to this rounding.
constexpr double kAreaRounding = 1e-9;

double orient(const Vec2& a, const Vec2& b, const Vec2& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

/// Whether a loop winds around a point. Ref: Hormann, Agathos (2001).
bool windsAround(std::span<const Vec2> points, std::span<const std::uint32_t> loop, const Vec2& p) {
    int winding = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
        if ((a.y <= p.y) != (b.y <= p.y) && (orient(a, b, p) > 0.0) == (a.y <= p.y))
            winding += a.y <= p.y ? 1 : -1;
    }
    return winding != 0;
}

/// Two edges, one of each outline, that cross on the plane.
struct EdgeCrossing {
    std::array<std::size_t, 2> edge{};
    std::array<double, 2> at{};        ///< share of the edge
    std::array<bool, 2> runsInwards{}; ///< the edge runs into the other outline here
    double gap = 0.0;                  ///< metres in space
    std::array<Vec3, 2> vertex{};      ///< of each edge; equal if the edges meet in space
    std::uint32_t number = 0;          ///< of the one vertex on the plane
};

/// The plane graph of two outlines. Vertices are numbered; those of equal position are one.
class OutlineGraph {
public:
    OutlineGraph(std::span<const Vec3> first, std::span<const Vec3> second, const Vec3& normal)
        : origin_(first[0]) {
        const Vec3 helper = std::abs(normal.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
        u_ = glm::normalize(glm::cross(helper, normal));
        v_ = glm::cross(normal, u_);
        for (const Vec3& p : first)
            outline_[0].push_back(known(p));
        for (const Vec3& p : second)
            outline_[1].push_back(known(p));
    }

    std::optional<OpeningOverlay> run() {
        findCrossings();
        placeVertices();
        const bool isApart = crossings_.empty() && !sharesVertices();
        if (!addChain(0) || !addChain(1) || (isApart && !addBridges()))
            return std::nullopt;
        OpeningOverlay parts;
        if (!sortFaces(parts) || parts.common.empty())
            return std::nullopt;
        return parts;
    }

private:
    /// Of an edge between two vertices, the smaller first: the way that each outline runs along it.
    using Ways = std::array<int, 2>;
    using Key = std::pair<std::uint32_t, std::uint32_t>;

    static Key keyOf(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

    std::uint32_t add(const Vec3& p) {
        vertices_.push_back(p);
        flat_.emplace_back(glm::dot(p - origin_, u_), glm::dot(p - origin_, v_));
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    std::uint32_t known(const Vec3& p) {
        const auto at = std::find(vertices_.begin(), vertices_.end(), p);
        return at == vertices_.end() ? add(p) : static_cast<std::uint32_t>(at - vertices_.begin());
    }

    [[nodiscard]] Key edgeOf(std::size_t side, std::size_t i) const {
        const std::vector<std::uint32_t>& outline = outline_[side];
        return {outline[i], outline[(i + 1) % outline.size()]};
    }

    [[nodiscard]] bool sharesVertices() const {
        return std::any_of(outline_[1].begin(), outline_[1].end(), [&](std::uint32_t v) {
            return std::find(outline_[0].begin(), outline_[0].end(), v) != outline_[0].end();
        });
    }

    void findCrossings() {
        for (std::size_t i = 0; i < outline_[0].size(); ++i)
            for (std::size_t j = 0; j < outline_[1].size(); ++j)
                cross(i, j);
    }

    /// A vertex on the other edge counts as inside, for both outlines alike.
    void cross(std::size_t i, std::size_t j) {
        const auto [a, b] = edgeOf(0, i);
        const auto [c, d] = edgeOf(1, j);
        if (a == c || a == d || b == c || b == d)
            return;
        const double sideA = orient(flat_[c], flat_[d], flat_[a]),
                     sideB = orient(flat_[c], flat_[d], flat_[b]),
                     sideC = orient(flat_[a], flat_[b], flat_[c]),
                     sideD = orient(flat_[a], flat_[b], flat_[d]);
        if ((sideA >= 0.0) == (sideB >= 0.0) || (sideC >= 0.0) == (sideD >= 0.0))
            return;
        EdgeCrossing found;
        found.edge = {i, j};
        found.at = {sideA / (sideA - sideB), sideC / (sideC - sideD)};
        found.runsInwards = {sideB >= 0.0, sideD >= 0.0};
        found.gap = glm::length(pointOn(0, i, found.at[0]) - pointOn(1, j, found.at[1]));
        crossings_.push_back(found);
    }

    [[nodiscard]] Vec3 pointOn(std::size_t side, std::size_t edge, double at) const {
        const auto [from, to] = edgeOf(side, edge);
        return vertices_[from] + (vertices_[to] - vertices_[from]) * at;
    }

    /// The share of the edge at which a crossing's vertex is.
    [[nodiscard]] double shifted(std::size_t side, const EdgeCrossing& crossing) const {
        const auto [from, to] = edgeOf(side, crossing.edge[side]);
        const double at = crossing.at[side];
        double next = crossing.runsInwards[side] ? 1.0 : 0.0;
        for (const EdgeCrossing& other : crossings_)
            if (other.edge[side] == crossing.edge[side] &&
                (crossing.runsInwards[side] ? other.at[side] > at : other.at[side] < at) &&
                std::abs(other.at[side] - at) < std::abs(next - at))
                next = other.at[side];
        const double wanted = crossing.gap / 2.0 / glm::length(vertices_[to] - vertices_[from]);
        const double by = std::min(wanted, kMostShift * std::abs(next - at));
        return crossing.runsInwards[side] ? at + by : at - by;
    }

    /// On the plane a crossing is one vertex.
    void placeVertices() {
        for (EdgeCrossing& crossing : crossings_) {
            const std::array<Vec3, 2> on{pointOn(0, crossing.edge[0], crossing.at[0]),
                                         pointOn(1, crossing.edge[1], crossing.at[1])};
            const Vec3 middle = (on[0] + on[1]) * 0.5;
            for (std::size_t side = 0; side < 2; ++side)
                crossing.vertex[side] = crossing.gap <= kMeet
                                            ? middle
                                            : pointOn(side, crossing.edge[side], shifted(side, crossing));
        }
        for (EdgeCrossing& crossing : crossings_)
            crossing.number = add(pointOn(0, crossing.edge[0], crossing.at[0]));
    }

    /// The outline with the vertices of its crossings; false if it runs along an edge twice.
    bool addChain(std::size_t side) {
        for (std::size_t i = 0; i < outline_[side].size(); ++i) {
            std::vector<const EdgeCrossing*> on;
            for (const EdgeCrossing& crossing : crossings_)
                if (crossing.edge[side] == i)
                    on.push_back(&crossing);
            std::sort(on.begin(), on.end(),
                      [&](const auto* a, const auto* b) { return a->at[side] < b->at[side]; });
            chain_[side].push_back(outline_[side][i]);
            for (const EdgeCrossing* crossing : on)
                chain_[side].push_back(crossing->number);
        }
        for (std::size_t i = 0; i < chain_[side].size(); ++i) {
            const std::uint32_t from = chain_[side][i], to = chain_[side][(i + 1) % chain_[side].size()];
            int& way = ways_[keyOf(from, to)][side];
            if (way != 0 || from == to)
                return false;
            way = from < to ? 1 : -1;
        }
        return true;
    }

    [[nodiscard]] bool crossesAnEdge(const Key& bridge) const {
        return std::any_of(ways_.begin(), ways_.end(), [&](const auto& entry) {
            const auto [a, b] = entry.first;
            const auto [c, d] = bridge;
            if (a == c || a == d || b == c || b == d)
                return false;
            return (orient(flat_[a], flat_[b], flat_[c]) >= 0.0) !=
                       (orient(flat_[a], flat_[b], flat_[d]) >= 0.0) &&
                   (orient(flat_[c], flat_[d], flat_[a]) >= 0.0) !=
                       (orient(flat_[c], flat_[d], flat_[b]) >= 0.0);
        });
    }

    /// Two edges between an outline and the one inside it, so that the part between them consists of simple polygons.
    bool addBridges() {
        std::vector<std::pair<double, Key>> bridges;
        for (const std::uint32_t a : outline_[0])
            for (const std::uint32_t b : outline_[1])
                bridges.push_back({glm::length(flat_[a] - flat_[b]), {a, b}});
        std::sort(bridges.begin(), bridges.end());
        std::vector<Key> taken;
        for (const auto& [length, bridge] : bridges) {
            const auto touches = [&ends = bridge](const Key& other) {
                return other.first == ends.first || other.second == ends.second;
            };
            if (taken.size() == 2 || std::any_of(taken.begin(), taken.end(), touches) ||
                crossesAnEdge(bridge))
                continue;
            ways_[keyOf(bridge.first, bridge.second)] = {};
            taken.push_back(bridge);
        }
        return taken.size() == 2;
    }

    /// Whether a face is inside an outline: by the way that the outline runs along the face's edges.
    [[nodiscard]] bool isInsideOf(std::size_t side, std::span<const std::uint32_t> face) const {
        Vec2 on(0.0);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t from = face[i], to = face[(i + 1) % face.size()];
            const Ways& ways = ways_.at(keyOf(from, to));
            if (ways[side] != 0)
                return (ways[side] > 0) == (from < to);
            if (ways[1 - side] != 0)
                on = (flat_[from] + flat_[to]) * 0.5;
        }
        return windsAround(flat_, chain_[side], on);
    }

    /// A face in space. At a crossing it has the vertices of the edge by which it arrives and of the other, by which it leaves.
    [[nodiscard]] Loop inSpace(std::span<const std::uint32_t> face) const {
        Loop loop;
        for (std::size_t i = 0; i < face.size(); ++i) {
            if (face[i] < firstCrossing()) {
                loop.push_back(vertices_[face[i]]);
                continue;
            }
            const EdgeCrossing& crossing = crossings_[face[i] - firstCrossing()];
            const std::uint32_t before = face[i == 0 ? face.size() - 1 : i - 1];
            const std::size_t arrives = ways_.at(keyOf(before, face[i]))[0] != 0 ? 0 : 1;
            loop.push_back(crossing.vertex[arrives]);
            if (crossing.gap > kMeet)
                loop.push_back(crossing.vertex[1 - arrives]);
        }
        return loop;
    }

    [[nodiscard]] std::size_t firstCrossing() const { return vertices_.size() - crossings_.size(); }

    bool sortFaces(OpeningOverlay& parts) const {
        std::vector<Key> edges;
        for (const auto& entry : ways_)
            edges.push_back(entry.first);
        std::array<double, 2> area{};
        for (const std::vector<std::uint32_t>& face : boundedFaces(flat_, edges)) {
            const std::array<bool, 2> inside{isInsideOf(0, face), isInsideOf(1, face)};
            for (std::size_t side = 0; side < 2; ++side)
                area[side] += inside[side] ? signedArea(flat_, face) : 0.0;
            if (!inside[0] && !inside[1])
                continue;
            (inside[0] && inside[1] ? parts.common
             : inside[0]            ? parts.first
                                    : parts.second)
                .push_back(inSpace(face));
        }
        return std::abs(area[0] - signedArea(flat_, chain_[0])) <= kAreaRounding &&
               std::abs(area[1] - signedArea(flat_, chain_[1])) <= kAreaRounding;
    }

    Vec3 origin_, u_{0.0}, v_{0.0};
    std::vector<Vec3> vertices_;
    std::vector<Vec2> flat_;
    std::array<std::vector<std::uint32_t>, 2> outline_, chain_; ///< chain: with the vertices of crossings
    std::vector<EdgeCrossing> crossings_;
    std::map<Key, Ways> ways_; ///< all edges
};

} // namespace

std::optional<OpeningOverlay> overlayOpenings(std::span<const Vec3> first, std::span<const Vec3> second,
                                              const Vec3& normal) {
    if (first.size() < 3 || second.size() < 3)
        return std::nullopt;
    return OutlineGraph(first, second, normal).run();
}

} // namespace limen::world
