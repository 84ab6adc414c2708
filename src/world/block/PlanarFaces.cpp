#include "world/block/PlanarFaces.h"

#include <algorithm>
#include <cmath>

namespace limen::world {

namespace {

/// An edge in one direction. Half-edges 2i and 2i + 1 are the two directions of edge i.
struct HalfEdge {
    std::uint32_t from = 0, to = 0;
    double angle = 0.0;
    std::uint32_t next = 0; ///< of the face to the left
};

std::vector<HalfEdge> halfEdgesOf(std::span<const Vec2> points,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> edges) {
    std::vector<HalfEdge> halves;
    const auto add = [&](std::uint32_t from, std::uint32_t to) {
        const Vec2 along = points[to] - points[from];
        halves.push_back({from, to, std::atan2(along.y, along.x), 0});
    };
    for (const auto& [from, to] : edges) {
        add(from, to);
        add(to, from);
    }
    return halves;
}

/// At its end each half-edge turns into the next outgoing one, clockwise from its own way back.
void connect(std::vector<HalfEdge>& halves, std::size_t pointCount) {
    std::vector<std::vector<std::uint32_t>> outgoing(pointCount);
    for (std::uint32_t h = 0; h < halves.size(); ++h)
        outgoing[halves[h].from].push_back(h);
    for (std::vector<std::uint32_t>& around : outgoing) {
        std::sort(around.begin(), around.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return halves[a].angle < halves[b].angle; });
        for (std::size_t i = 0; i < around.size(); ++i)
            halves[around[i] ^ 1u].next = around[(i == 0 ? around.size() : i) - 1];
    }
}

} // namespace

double signedArea(std::span<const Vec2> points, std::span<const std::uint32_t> loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = points[loop[i]] - points[loop[0]],
                   b = points[loop[(i + 1) % loop.size()]] - points[loop[0]];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

std::vector<std::vector<std::uint32_t>>
boundedFaces(std::span<const Vec2> points, std::span<const std::pair<std::uint32_t, std::uint32_t>> edges) {
    std::vector<HalfEdge> halves = halfEdgesOf(points, edges);
    connect(halves, points.size());
    std::vector<bool> done(halves.size(), false);
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t first = 0; first < halves.size(); ++first) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t h = first; !done[h]; h = halves[h].next) {
            done[h] = true;
            face.push_back(halves[h].from);
        }
        if (face.size() >= 3 && signedArea(points, face) > 0.0)
            faces.push_back(std::move(face));
    }
    return faces;
}

} // namespace limen::world
