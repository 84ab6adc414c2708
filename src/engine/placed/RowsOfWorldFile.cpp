#include "engine/placed/RowsOfWorldFile.h"

#include "core/Assert.h"
#include "world/Lookup.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace limen::engine {
namespace {

using placements::Template;
using placements::TemplateType;

/// A place on a route: position, compass direction and cell of the leg's first point.
struct RoutePlace {
    Vec3 position{0.0};
    double yaw = 0.0;
    dat::RecordId cell = 0;
};

/// The place at a number of metres along a route.
RoutePlace placeOn(const world::RouteEntry& route, double metres) {
    std::vector<world::RouteEntry::Point> points = route.points;
    if (route.loop)
        points.push_back(route.points.front());
    else
        points.insert(points.end(), route.points.rbegin() + 1, route.points.rend());
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += glm::length(points[i].position - points[i - 1].position);
    double along = length > 0.0 ? std::fmod(metres, length) : 0.0;
    along += along < 0.0 ? length : 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 way = points[i].position - points[i - 1].position;
        const double leg = glm::length(way);
        if (along <= leg || i + 1 == points.size())
            return {points[i - 1].position + way * (leg > 0.0 ? std::min(along / leg, 1.0) : 0.0),
                    std::atan2(way.x, way.y) * 180.0 / std::numbers::pi, points[i - 1].cell};
        along -= leg;
    }
    return {};
}

/// Adds rows with ascending numbers.
class RowMaker {
public:
    explicit RowMaker(placements::Content& content) : content_(content) {}

    Template& addTemplate(const std::string& name, TemplateType type) {
        const std::uint32_t id = nextTemplate_++;
        Template& of = content_.templates[id];
        of.id = id;
        of.className = fmt::format("limen-{}-{}", id, name);
        of.type = static_cast<std::int32_t>(type);
        of.name = name;
        return of;
    }

    /// `yaw`: compass direction, degrees.
    void place(const Template& of, const Vec3& position, double yaw, dat::RecordId cell) {
        const dat::BlockCoord block = cell != 0 ? dat::blockOf(cell) : world::blockAt(position);
        const std::uint32_t landblock =
            static_cast<std::uint32_t>(block.x) << 8 | static_cast<std::uint32_t>(block.y);
        const Vec3 local = position - Vec3(block.x * world::kBlockSize, block.y * world::kBlockSize, 0.0);
        const double half = -yaw * std::numbers::pi / 360.0;
        placements::Landblock& rows = content_.landblocks[landblock];
        const std::uint32_t guid =
            0x70000000u | landblock << 12 | static_cast<std::uint32_t>(rows.placements.size());
        rows.placements.push_back(
            {guid,
             of.id,
             {cell != 0 ? cell : landblock << 16,
              {static_cast<float>(local.x), static_cast<float>(local.y), static_cast<float>(local.z)},
              {static_cast<float>(std::cos(half)), 0.0f, 0.0f, static_cast<float>(std::sin(half))}},
             false});
    }

private:
    placements::Content& content_;
    std::uint32_t nextTemplate_ = 1;
};

bool hasMotion(const world::DoorEntry& door) {
    return door.opaque && !door.leaves.empty() &&
           std::all_of(door.leaves.begin(), door.leaves.end(),
                       [](const world::LeafEntry& leaf) { return leaf.motionTable != 0; });
}

void addDoor(const world::DoorEntry& door, RowMaker& rows) {
    for (const world::LeafEntry& leaf : door.leaves) {
        Template& of = rows.addTemplate(door.name, TemplateType::Door);
        of.setup = leaf.model;
        of.motionTable = leaf.motionTable;
        of.defaultOpen = door.open > 0.0;
        rows.place(of, leaf.position, leaf.yaw, door.cell);
    }
}

void addPerson(const world::VillagerEntry& person, const world::RouteEntry& route, RowMaker& rows) {
    std::vector<placements::CreatedItem> items;
    for (const world::ClothingEntry& garment : person.clothing) {
        Template& item = rows.addTemplate(person.name + " garment", TemplateType::Generic);
        item.clothingBase = garment.table;
        if (garment.palette != 0)
            item.paletteTemplate = static_cast<std::int32_t>(garment.palette);
        items.push_back(
            {placements::CreatedItem::kWield, item.id, 0, static_cast<float>(garment.shades.front())});
    }
    Template& of = rows.addTemplate(person.name, TemplateType::Creature);
    of.setup = person.model;
    of.paletteBase = person.basePalette;
    of.items = std::move(items);
    const RoutePlace at = placeOn(route, person.start);
    rows.place(of, at.position, at.yaw, at.cell);
}

} // namespace

WorldFileRows rowsOf(const world::WorldFile& file) {
    WorldFileRows rows;
    RowMaker maker(rows.content);
    for (const world::DoorEntry& door : file.moving.doors) {
        if (!hasMotion(door)) {
            ++rows.left;
            continue;
        }
        addDoor(door, maker);
        ++rows.doors;
    }
    for (const world::VillagerEntry& person : file.moving.villagers) {
        const auto route = std::find_if(file.moving.routes.begin(), file.moving.routes.end(),
                                        [&](const world::RouteEntry& r) { return r.name == person.route; });
        if (route == file.moving.routes.end() || route->points.size() < 2) {
            ++rows.left;
            continue;
        }
        addPerson(person, *route, maker);
        ++rows.people;
    }
    rows.left += file.moving.emitters.size();
    return rows;
}

} // namespace limen::engine
