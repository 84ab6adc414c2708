// The visibility library alone: no dat file, no OpenGL. Three rooms in an L and a yard, joined by three
// openings. Prints each visit: its space and its region of the screen, for an eye given on the command line.
//
//     flood [x y yaw]    metres, degrees clockwise from north; default: an eye in the hall that looks north

#include "visibility/Flood.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace vis = limen::visibility;
using limen::Vec3;

namespace {

const char* const kNames[] = {"yard", "hall", "parlour", "closet"};

/// A floor plan: every space is an axis-aligned rectangle, every opening an upright one 2 m high.
struct House {
    std::vector<vis::SpaceDesc> spaces;
    std::vector<vis::PortalDesc> portals;
    std::vector<Vec3> vertices;

    /// Adds an opening from `from` to `to`. a and b are its lower corners; seen from inside `from`, a is on
    /// the left.
    void opening(std::uint32_t from, std::uint32_t to, std::uint32_t back, Vec3 a, Vec3 b) {
        const Vec3 up(0, 0, 2);
        portals.push_back({from, to, back, static_cast<std::uint32_t>(vertices.size()), 4, true});
        vertices.insert(vertices.end(), {a, b, b + up, a + up}); // counter-clockwise seen from `from`
    }
};

House build() {
    House h;
    // Portals are grouped by space; each stores the index of its reciprocal. No two spaces share a zone.
    h.spaces = {{0, 1, 0}, {1, 2, 1}, {3, 2, 2}, {5, 1, 3}};
    h.opening(0, 1, 1, {1, 0, 0}, {3, 0, 0}); // yard → hall, through the front door in y = 0
    h.opening(1, 0, 0, {3, 0, 0}, {1, 0, 0});
    h.opening(1, 2, 3, {1, 5, 0}, {3, 5, 0}); // hall → parlour, in y = 5
    h.opening(2, 1, 2, {3, 5, 0}, {1, 5, 0});
    h.opening(2, 3, 5, {4, 9, 0}, {4, 6, 0}); // parlour → closet, in x = 4
    h.opening(3, 2, 4, {4, 6, 0}, {4, 9, 0});
    return h;
}

vis::View look(double x, double y, double yawDegrees) {
    const double yaw = yawDegrees * std::numbers::pi / 180.0;
    vis::View view;
    view.eye = {x, y, 1.6};
    view.forward = {std::sin(yaw), std::cos(yaw), 0};
    view.right = {std::cos(yaw), -std::sin(yaw), 0};
    view.root = y < 0 ? 0 : y < 5 ? 1 : x < 4 ? 2 : 3;
    return view;
}

} // namespace

int main(int argc, char** argv) {
    const House house = build();
    const auto graph = vis::Graph::build(house.spaces, house.portals, house.vertices);
    if (!graph) {
        std::fprintf(stderr, "%s\n", graph.error().message().c_str());
        return 2;
    }
    const bool given = argc == 4;
    const vis::View view =
        given ? look(std::atof(argv[1]), std::atof(argv[2]), std::atof(argv[3])) : look(2, 2, 20);
    vis::FloodScratch scratch;
    vis::VisibleSet seen;
    if (const auto flooded = vis::flood(*graph, {}, view, {}, scratch, seen); !flooded) {
        std::fprintf(stderr, "%s\n", flooded.error().message().c_str());
        return 2;
    }
    for (const vis::Visit& visit : seen.visits) {
        std::printf("%*s%s:", static_cast<int>(2 * visit.depth), "", kNames[visit.space]);
        for (const Vec3& corner : seen.region(visit))
            std::printf(" (%.2f, %.2f)", corner.x / corner.z, corner.y / corner.z);
        std::printf("\n");
    }
    return 0;
}
