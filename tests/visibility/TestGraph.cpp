#include "visibility/TestGraph.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <numbers>

namespace limen::visibility {

std::uint32_t TestGraph::addSpace(std::uint32_t zone) {
    zones_.push_back(zone);
    return static_cast<std::uint32_t>(zones_.size() - 1);
}

std::uint32_t TestGraph::addSpace() {
    return addSpace(static_cast<std::uint32_t>(zones_.size()));
}

void TestGraph::link(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon) {
    linkInexact(from, to, polygon, {polygon.rbegin(), polygon.rend()});
    openings_[openings_.size() - 2].exact = openings_.back().exact = true;
}

void TestGraph::linkOneWay(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon) {
    openings_.push_back({from, to, -1, polygon, true});
}

void TestGraph::linkInexact(std::uint32_t from, std::uint32_t to, const std::vector<Vec3>& polygon,
                            const std::vector<Vec3>& back) {
    const int first = static_cast<int>(openings_.size());
    openings_.push_back({from, to, first + 1, polygon, false});
    openings_.push_back({to, from, first, back, false});
}

Graph TestGraph::build() const {
    std::vector<std::uint32_t> order(openings_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return openings_[a].space < openings_[b].space;
    });
    std::vector<std::uint32_t> placeOf(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        placeOf[order[i]] = i;
    std::vector<SpaceDesc> spaces(zones_.size());
    for (std::size_t i = 0; i < spaces.size(); ++i)
        spaces[i].zone = zones_[i];
    std::vector<PortalDesc> portals;
    std::vector<Vec3> vertices;
    for (const std::uint32_t i : order) {
        const Opening& o = openings_[i];
        SpaceDesc& space = spaces[o.space];
        if (space.portalCount++ == 0)
            space.firstPortal = static_cast<std::uint32_t>(portals.size());
        portals.push_back({o.space, o.destination,
                           o.pair < 0 ? kNone : placeOf[static_cast<std::size_t>(o.pair)],
                           static_cast<std::uint32_t>(vertices.size()),
                           static_cast<std::uint32_t>(o.polygon.size()), o.exact});
        vertices.insert(vertices.end(), o.polygon.begin(), o.polygon.end());
    }
    auto graph = Graph::build(spaces, portals, vertices);
    if (!graph) {
        std::cerr << graph.error().message() << '\n';
        std::abort();
    }
    return std::move(*graph);
}

std::vector<Vec3> uprightRectangle(const Vec3& centre, const Vec3& towardsViewer, double width,
                                   double height) {
    const Vec3 right = glm::cross(Vec3(0, 0, 1), glm::normalize(towardsViewer)) * (width / 2);
    const Vec3 up = Vec3(0, 0, height / 2);
    return {centre - right - up, centre + right - up, centre + right + up, centre - right + up};
}

View viewFrom(const Vec3& eye, double yaw, double pitch, std::uint32_t root) {
    const double a = yaw * std::numbers::pi / 180.0;
    const double b = pitch * std::numbers::pi / 180.0;
    View view;
    view.eye = eye;
    view.forward = {std::sin(a) * std::cos(b), std::cos(a) * std::cos(b), std::sin(b)};
    view.right = {std::cos(a), -std::sin(a), 0.0};
    view.up = glm::cross(view.right, view.forward);
    view.root = root;
    return view;
}

std::uint32_t ownerOf(const VisibleSet& set, const Vec3& direction) {
    std::uint32_t owner = 0;
    for (std::uint32_t i = 0; i < set.visits.size(); ++i) {
        const auto region = set.region(set.visits[i]);
        bool inside = true;
        for (std::size_t e = 0; e < region.size() && inside; ++e)
            inside = glm::dot(glm::cross(region[e], region[(e + 1) % region.size()]), direction) >= 0.0;
        owner = inside ? i : owner;
    }
    return owner;
}

std::vector<std::uint32_t> chainOf(const VisibleSet& set, std::uint32_t visit) {
    std::vector<std::uint32_t> chain;
    for (; visit != kNone; visit = set.visits[visit].parent)
        chain.insert(chain.begin(), set.visits[visit].space);
    return chain;
}

VisibleSet floodOnce(const Graph& graph, const View& view, const Limits& limits,
                     std::span<const std::uint8_t> closed) {
    FloodScratch scratch;
    VisibleSet set;
    if (const Result<void> flooded = flood(graph, closed, view, limits, scratch, set); !flooded) {
        std::cerr << flooded.error().message() << '\n';
        std::abort();
    }
    return set;
}

} // namespace limen::visibility
