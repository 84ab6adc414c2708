// The visibility library alone: no dat file, no OpenGL. Three rooms in an L and a yard, joined by three
// openings. Prints each visit: its space, its region of the screen and its scissor rectangle, for an eye given on the
// command line.
//
//     flood [x y yaw]    metres, degrees clockwise from north; default: an eye in the hall that looks north

#include <limen/visibility/Flood.h>
#include <limen/visibility/GraphBuilder.h>
#include <limen/visibility/RegionPixels.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace vis = limen::visibility;
using limen::Vec3;

namespace {

const char* const kNames[] = {"yard", "hall", "parlour", "closet"};

/// An upright opening 2 m high. a and b are its lower corners; as seen from inside `from`, a is on the left.
vis::OpeningDesc opening(std::uint32_t from, std::uint32_t to, Vec3 a, Vec3 b) {
    const Vec3 up(0, 0, 2);
    return {.from = from, .to = to, .polygon = {a, b, b + up, a + up}}; // counter-clockwise seen from `from`
}

limen::Result<vis::BuiltGraph> buildHouse() {
    vis::GraphBuilder house;
    const std::uint32_t yard = house.addSpace(), hall = house.addSpace();
    const std::uint32_t parlour = house.addSpace(), closet = house.addSpace();
    house.addOpening(opening(yard, hall, {1, 0, 0}, {3, 0, 0}));      // the front door, in y = 0
    house.addOpening(opening(hall, parlour, {1, 5, 0}, {3, 5, 0}));   // in y = 5
    house.addOpening(opening(parlour, closet, {4, 9, 0}, {4, 6, 0})); // in x = 4
    return house.build();
}

limen::Result<vis::View> look(double x, double y, double yawDegrees) {
    const double yaw = yawDegrees * std::numbers::pi / 180.0;
    const Vec3 eye(x, y, 1.6);
    return vis::viewOf({.eye = eye,
                        .target = eye + Vec3(std::sin(yaw), std::cos(yaw), 0),
                        .heightDegrees = 90,
                        .aspect = 1,
                        .root = y < 0   ? 0u
                                : y < 5 ? 1u
                                : x < 4 ? 2u
                                        : 3u});
}

int report(const limen::Error& error) {
    std::fprintf(stderr, "%s\n", error.message().c_str());
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    const auto house = buildHouse();
    if (!house)
        return report(house.error());
    const bool given = argc == 4;
    const auto view =
        given ? look(std::atof(argv[1]), std::atof(argv[2]), std::atof(argv[3])) : look(2, 2, 20);
    if (!view)
        return report(view.error());
    vis::FloodScratch scratch; // keep both from frame to frame
    vis::VisibleSet seen;
    if (const auto flooded = vis::flood(house->graph, {}, *view, {}, scratch, seen); !flooded)
        return report(flooded.error());
    for (const vis::Visit& visit : seen.visits) {
        std::printf("%*s%s:", static_cast<int>(2 * visit.depth), "", kNames[visit.space]);
        for (const Vec3& corner : seen.region(visit))
            std::printf(" (%.2f, %.2f)", corner.x / corner.z, corner.y / corner.z);
        const vis::PixelRect box = vis::scissorOf(seen.region(visit), 1000, 1000);
        std::printf(", scissor %u %u %u %u of 1000 x 1000\n", box.x, box.y, box.width, box.height);
    }
    return 0;
}
