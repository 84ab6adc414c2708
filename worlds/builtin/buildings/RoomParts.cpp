#include "worlds/builtin/buildings/RoomParts.h"

#include "worlds/builtin/buildings/HouseShell.h"

namespace limen::worlds {

dat::RecordId addTrim(ModelWriter& writer, const std::vector<WallOpening>& openings, double floor) {
    FaceMesh mesh;
    for (const auto& [opening, at] : openings) {
        const bool window = opening.rect.v0 > floor + 0.3;
        addFrame(mesh, opening.side, at, opening.rect, 0.11, 0.035, window);
    }
    return writer.addSetup({{writer.addMesh(mesh), {}}});
}

CellPlan doorway(const char* name, const Vec3& min, const Vec3& max, Axis axis, Material walls,
                 Material floor) {
    const RoomSpec room{
        .name = name, .min = min, .max = max, .floor = floor, .walls = walls, .ceiling = Material::Beam};
    switch (axis) {
    case Axis::X: {
        const Rect rect{min.y, min.z, max.y, max.z};
        return roomWithOpenings(room, {{Side::West, rect}, {Side::East, rect}});
    }
    case Axis::Y: {
        const Rect rect{min.x, min.z, max.x, max.z};
        return roomWithOpenings(room, {{Side::South, rect}, {Side::North, rect}});
    }
    case Axis::Z: {
        const Rect rect{min.x, min.y, max.x, max.y};
        return roomWithOpenings(room, {{Side::Floor, rect}, {Side::Ceiling, rect}});
    }
    }
    return {};
}

} // namespace limen::worlds
