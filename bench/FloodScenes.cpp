#include "FloodScenes.h"

#include "core/Assert.h"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>

namespace limen::bench {

namespace {

constexpr double kRoom = 10.0;
constexpr double kDoorHeight = 3.0;

/// Collects the openings by space.
struct GridBuilder {
    std::vector<visibility::SpaceDesc> spaces;
    std::vector<visibility::PortalDesc> portals;
    std::vector<Vec3> vertices;

    void door(std::uint32_t from, std::uint32_t to, const Vec3& middle, const Vec3& inward, double width) {
        const Vec3 right = glm::cross(Vec3(0, 0, 1), inward) * (width / 2);
        const Vec3 up(0, 0, kDoorHeight);
        portals.push_back(
            {from, to, visibility::kNone, static_cast<std::uint32_t>(vertices.size()), 4, true});
        vertices.insert(vertices.end(),
                        {middle - right, middle + right, middle + right + up, middle - right + up});
        ++spaces[from].portalCount;
    }

    void pairUp() {
        for (std::uint32_t p = 0; p < portals.size(); ++p) {
            const visibility::SpaceDesc& other = spaces[portals[p].destination];
            for (std::uint32_t q = other.firstPortal; q < other.firstPortal + other.portalCount; ++q)
                if (portals[q].destination == portals[p].space)
                    portals[p].reciprocal = q;
        }
    }
};

std::vector<visibility::View> randomViews(int columns, int rows, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<visibility::View> views(1000);
    for (visibility::View& view : views) {
        const int column = static_cast<int>(unit(random) * columns);
        const int row = static_cast<int>(unit(random) * rows);
        view.eye = {(column + 0.05 + 0.9 * unit(random)) * kRoom, (row + 0.05 + 0.9 * unit(random)) * kRoom,
                    1.7};
        const double yaw = unit(random) * 2.0 * std::numbers::pi;
        view.forward = {std::sin(yaw), std::cos(yaw), 0.0};
        view.right = {std::cos(yaw), -std::sin(yaw), 0.0};
        view.up = {0, 0, 1};
        view.tanHalfX = 1.0;
        view.tanHalfY = std::tan(std::numbers::pi / 6.0);
        view.root = static_cast<std::uint32_t>(row * columns + column);
    }
    return views;
}

FloodScene grid(int columns, int rows, double door, std::uint32_t seed, bool merged) {
    GridBuilder builder;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto room = static_cast<std::uint32_t>(row * columns + column);
            builder.spaces.push_back(
                {static_cast<std::uint32_t>(builder.portals.size()), 0, merged ? 0 : room});
            const Vec3 middle((column + 0.5) * kRoom, (row + 0.5) * kRoom, 0.0);
            const auto wall = [&](int dx, int dy) {
                const int x = column + dx;
                const int y = row + dy;
                if (x >= 0 && y >= 0 && x < columns && y < rows) {
                    const Vec3 outward(dx, dy, 0);
                    builder.door(room, static_cast<std::uint32_t>(y * columns + x),
                                 middle + outward * (kRoom / 2), -outward, door);
                }
            };
            builder.spaces.resize(room + 1u);
            wall(-1, 0);
            wall(1, 0);
            wall(0, -1);
            wall(0, 1);
        }
    }
    builder.pairUp();
    auto graph = visibility::Graph::build(builder.spaces, builder.portals, builder.vertices);
    LIMEN_ASSERT(graph.has_value(), "the grid is a valid graph");
    return {
        fmt::format("{}x{} rooms, {:g} m doors{}", columns, rows, door, merged ? "" : ", every room a zone"),
        std::move(*graph), randomViews(columns, rows, seed)};
}

} // namespace

FloodScene roomGrid(int columns, int rows, double door, std::uint32_t seed) {
    return grid(columns, rows, door, seed, true);
}

FloodScene roomGridApart(int columns, int rows, double door, std::uint32_t seed) {
    return grid(columns, rows, door, seed, false);
}

} // namespace limen::bench
