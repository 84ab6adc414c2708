#include "output/report/GraphLayout.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace limen::output {
namespace {

// The force model of Fruchterman and Reingold (1991), with forces only between nodes in neighbouring cells
// of a grid, which their paper proposes for large graphs.
constexpr double kIdeal = 1.0;    ///< length of an edge
constexpr double kCutOff = 3.0;   ///< nodes farther apart do not push each other
constexpr double kGravity = 0.02; ///< towards the centre; keeps separate parts together
constexpr double kNearest = 0.45; ///< the distance that the last pass keeps between nodes

/// Positions scaled to an area of one square unit a node, with equal positions spread on a spiral.
std::vector<Vec2> startingPositions(std::span<const Vec2> start) {
    Vec2 low(1e300), high(-1e300);
    for (const Vec2& p : start)
        low = glm::min(low, p), high = glm::max(high, p);
    const double side = std::sqrt(static_cast<double>(start.size())) * kIdeal;
    const double extent = std::max({high.x - low.x, high.y - low.y, 1e-9});
    std::vector<Vec2> positions;
    for (std::size_t i = 0; i < start.size(); ++i) {
        const double angle = 2.399963229728653 * static_cast<double>(i); // the golden angle
        const double radius =
            0.2 + 0.3 * side * std::sqrt(static_cast<double>(i) / static_cast<double>(start.size()));
        positions.push_back((start[i] - (low + high) * 0.5) * (side / extent) +
                            Vec2(std::cos(angle), std::sin(angle)) * radius * 0.5);
    }
    return positions;
}

/// Calls `visit(i, j)` for each pair of nodes in the same or neighbouring cells of a grid, i < j.
template <class Visit>
void forNearPairs(const std::vector<Vec2>& positions, double cell, Visit&& visit) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::uint32_t>> cells;
    const auto keyOf = [cell](const Vec2& p) {
        return std::pair(static_cast<std::int64_t>(std::floor(p.x / cell)),
                         static_cast<std::int64_t>(std::floor(p.y / cell)));
    };
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        cells[keyOf(positions[i])].push_back(i);
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        const auto [x, y] = keyOf(positions[i]);
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                if (const auto found = cells.find({x + dx, y + dy}); found != cells.end())
                    for (const std::uint32_t j : found->second)
                        if (i < j)
                            visit(i, j);
    }
}

} // namespace

std::vector<Vec2> layOutGraph(std::span<const Vec2> start,
                              std::span<const std::pair<std::uint32_t, std::uint32_t>> edges) {
    if (start.empty())
        return {};
    std::vector<Vec2> positions = startingPositions(start), forces(start.size());
    const int steps = start.size() <= 500 ? 300 : 100;
    for (int step = 0; step < steps; ++step) {
        std::fill(forces.begin(), forces.end(), Vec2(0.0));
        forNearPairs(positions, kCutOff, [&](std::uint32_t i, std::uint32_t j) {
            const Vec2 away = positions[i] - positions[j];
            const double square = std::max(glm::dot(away, away), 1e-4);
            if (square < kCutOff * kCutOff) {
                forces[i] += away * (kIdeal * kIdeal / square);
                forces[j] -= away * (kIdeal * kIdeal / square);
            }
        });
        for (const auto& [a, b] : edges) {
            LIMEN_ASSERT(a < start.size() && b < start.size(), "an edge joins nodes");
            const Vec2 between = positions[b] - positions[a];
            const Vec2 pull = between * (glm::length(between) / kIdeal);
            forces[a] += pull;
            forces[b] -= pull;
        }
        const double most = kIdeal * 0.5 * (1.0 - static_cast<double>(step) / steps); // cools down
        for (std::size_t i = 0; i < positions.size(); ++i) {
            const Vec2 force = forces[i] - positions[i] * kGravity;
            const double length = glm::length(force);
            if (length > 1e-12)
                positions[i] += force * (std::min(length * 0.1, most) / length);
        }
    }
    for (int pass = 0; pass < 30; ++pass)
        forNearPairs(positions, kNearest, [&](std::uint32_t i, std::uint32_t j) {
            Vec2 away = positions[i] - positions[j];
            const double distance = glm::length(away);
            if (distance >= kNearest)
                return;
            away = distance > 1e-9 ? away / distance : Vec2(1.0, 0.0);
            positions[i] += away * ((kNearest - distance) * 0.5);
            positions[j] -= away * ((kNearest - distance) * 0.5);
        });
    Vec2 middle(0.0);
    for (const Vec2& p : positions)
        middle += p / static_cast<double>(positions.size());
    for (Vec2& p : positions)
        p -= middle;
    return positions;
}

} // namespace limen::output
