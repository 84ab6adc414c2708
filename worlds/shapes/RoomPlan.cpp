#include "worlds/shapes/RoomPlan.h"

#include "worlds/records/Seams.h"

#include <array>

namespace limen::worlds {

CellPlan roomWithOpenings(const RoomSpec& room, const std::vector<Opening>& openings) {
    struct Plane {
        Side side;
        double at;
        Rect rect;
        Material material;
    };
    const Vec3& a = room.min;
    const Vec3& b = room.max;
    const std::array<Plane, 6> sides{{{Side::West, a.x, {a.y, a.z, b.y, b.z}, room.walls},
                                      {Side::East, b.x, {a.y, a.z, b.y, b.z}, room.walls},
                                      {Side::South, a.y, {a.x, a.z, b.x, b.z}, room.walls},
                                      {Side::North, b.y, {a.x, a.z, b.x, b.z}, room.walls},
                                      {Side::Floor, a.z, {a.x, a.y, b.x, b.y}, room.floor},
                                      {Side::Ceiling, b.z, {a.x, a.y, b.x, b.y}, room.ceiling}}};
    CellPlan cell;
    cell.name = room.name;
    for (const Plane& plane : sides) {
        std::vector<Rect> holes;
        for (const Opening& opening : openings)
            if (opening.side == plane.side)
                holes.push_back(opening.rect);
        for (const Rect& rect : withoutHoles(plane.rect, holes))
            cell.faces.push_back(planarFace(rectOnSide(plane.side, plane.at, rect), plane.material));
    }
    for (const Opening& opening : openings) {
        const auto side = static_cast<std::size_t>(opening.side);
        cell.faces.push_back(portalFace(rectOnSide(opening.side, sides[side].at, opening.rect)));
    }
    closeSeams(cell.faces);
    return cell;
}

} // namespace limen::worlds
