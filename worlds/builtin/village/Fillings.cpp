#include "worlds/builtin/village/Fillings.h"

#include "core/Assert.h"
#include "geometry/Plane.h"
#include "worlds/builtin/buildings/Cottages.h"
#include "worlds/builtin/buildings/Inn.h"
#include "worlds/builtin/buildings/MeetingHall.h"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>

namespace limen::worlds {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kLeafThick = 0.05; ///< thickness of a leaf, metres
constexpr double kSwing = 95.0;     ///< degrees

/// An upright rectangular opening seen from its cell; coordinates of the building.
struct OpeningView {
    Vec3 left{0.0}, right{0.0}; ///< lower corners, seen from inside
    Vec3 inward{0.0};           ///< unit, level
    double height = 0.0;
};

struct DoorSpec {
    const char* name = "";
    const Placement* building = nullptr;
    dat::RecordId cell = 0;
    std::uint32_t to = dat::kOutdoors; ///< the cell behind it; outside: the door, not a window
    bool hingeOnTheRight = false;      ///< seen from inside the cell
    bool intoCell = true;
    bool twoLeaves = false;
    double open = 0.0;
};

/// A leaf of boards and iron bands, from the hinge at the origin along +x. Its faces look along y.
FaceMesh leafMesh(double width, double height) {
    FaceMesh mesh;
    const double from = -kLeafThick / 2.0;
    const int boards = std::max(3, static_cast<int>(std::lround(width / 0.22)));
    for (int k = 0; k < boards; ++k) {
        const double half = kLeafThick / 2.0 - (k % 2 == 0 ? 0.0 : 0.004);
        mesh.beam({from + width * k / boards, -half, 0.0}, {from + width * (k + 1) / boards, half, height},
                  Material::OldPlanks);
    }
    for (const double z : {0.22, height - 0.32}) {
        mesh.box({from + 0.01, -kLeafThick / 2 - 0.006, z},
                 {from + 0.82 * width, kLeafThick / 2 + 0.006, z + 0.06}, Material::Iron);
    }
    const double x = from + width - 0.09;
    mesh.box({x - 0.02, -kLeafThick / 2 - 0.008, 0.98}, {x + 0.02, kLeafThick / 2 + 0.008, 1.12},
             Material::Iron);
    for (const double side : {-1.0, 1.0}) {
        const double near = side * (kLeafThick / 2 + 0.012);
        const double far = side * (kLeafThick / 2 + 0.023);
        mesh.beam({x - 0.10, std::min(near, far), 1.045}, {x + 0.012, std::max(near, far), 1.07},
                  Material::Iron);
    }
    mesh.box({x - 0.012, -kLeafThick / 2 - 0.018, 1.048}, {x + 0.008, kLeafThick / 2 + 0.018, 1.066},
             Material::Iron);
    return mesh;
}

class FillingList {
public:
    explicit FillingList(ModelWriter& writer) : writer_(writer) {}

    void door(const DoorSpec& spec);
    /// Adds a pane for every window to the outside.
    void panes(const char* name, const Placement& building, const std::vector<dat::RecordId>& cells);
    Json take() { return std::move(list_); }

private:
    const dat::EnvCell& cellOf(dat::RecordId id) const {
        const auto& cells = writer_.records().envCells;
        const auto found =
            std::find_if(cells.begin(), cells.end(), [id](const dat::EnvCell& c) { return c.id == id; });
        LIMEN_ASSERT(found != cells.end(), "no such cell");
        return *found;
    }
    const dat::CellStruct& shapeOf(const dat::EnvCell& cell) const {
        const auto& list = writer_.records().environments;
        const auto found = std::find_if(list.begin(), list.end(),
                                        [&](const auto& e) { return (e.id & 0xFFFF) == cell.environment; });
        LIMEN_ASSERT(found != list.end(), "no such environment");
        return found->cells.at(cell.cellStructure).second;
    }
    OpeningView viewOf(const dat::EnvCell& cell, std::size_t portal) const;
    bool isWindow(const dat::EnvCell& cell, std::size_t portal) const;
    std::size_t findPortal(const DoorSpec& spec) const;
    dat::RecordId leafModel(double width, double height);
    dat::RecordId paneModel(double width, double height);
    static Json entry(const std::string& name, dat::RecordId cell, std::size_t portal, bool opaque,
                      double open);
    static Json leaf(dat::RecordId model, const Placement& building, const Vec3& hinge, const Vec3& along,
                     double swing);

    using Size = std::pair<long, long>; ///< millimetres
    static Size sizeOf(double width, double height) {
        return {std::lround(width * 1000.0), std::lround(height * 1000.0)};
    }

    ModelWriter& writer_;
    Json list_ = Json::array();
    std::map<Size, dat::RecordId> leaves_, panes_;
};

double cellFloor(const dat::CellStruct& shape) {
    double low = 1e300;
    for (const auto& [key, vertex] : shape.vertexArray.vertices)
        low = std::min(low, static_cast<double>(vertex.position.z));
    return low;
}

OpeningView FillingList::viewOf(const dat::EnvCell& cell, std::size_t portal) const {
    const dat::CellStruct& shape = shapeOf(cell);
    std::vector<Vec3> points;
    for (const auto& [id, polygon] : shape.polygons) {
        if (id == cell.portals.at(portal).polygonId)
            for (const std::uint16_t key : polygon.vertexKeys)
                points.emplace_back(shape.vertexArray.vertices.at(key).second.position);
    }
    OpeningView view;
    view.inward = planeOf(points).n;
    LIMEN_ASSERT(std::abs(view.inward.z) < 1e-6, "fillings stand upright");
    const Vec3 right = glm::cross(-view.inward, Vec3(0, 0, 1));
    const auto reach = [&](const Vec3& direction) {
        double most = -1e300;
        for (const Vec3& p : points)
            most = std::max(most, glm::dot(p, direction));
        return most;
    };
    const double bottom = -reach({0, 0, -1});
    const Vec3 inPlane = view.inward * glm::dot(points[0], view.inward) + Vec3(0, 0, bottom);
    view.left = inPlane - right * reach(-right);
    view.right = inPlane + right * reach(right);
    view.height = reach({0, 0, 1}) - bottom;
    return view;
}

bool FillingList::isWindow(const dat::EnvCell& cell, std::size_t portal) const {
    return cell.portals[portal].otherCellId == dat::kOutdoors &&
           viewOf(cell, portal).left.z > cellFloor(shapeOf(cell)) + 0.3;
}

std::size_t FillingList::findPortal(const DoorSpec& spec) const {
    const dat::EnvCell& cell = cellOf(spec.cell);
    for (std::size_t k = 0; k < cell.portals.size(); ++k)
        if (cell.portals[k].otherCellId == (spec.to & 0xFFFF) && !isWindow(cell, k))
            return k;
    LIMEN_ASSERT(false, "the door's opening does not exist");
    return 0;
}

dat::RecordId FillingList::leafModel(double width, double height) {
    dat::RecordId& id = leaves_[sizeOf(width, height)];
    if (id == 0)
        id = writer_.addSetup({{writer_.addMesh(leafMesh(width, height)), {}}});
    return id;
}

dat::RecordId FillingList::paneModel(double width, double height) {
    dat::RecordId& id = panes_[sizeOf(width, height)];
    if (id == 0) {
        Face pane =
            planarFace({{0, 0, 0}, {width, 0, 0}, {width, 0, height}, {0, 0, height}}, Material::Glass);
        pane.twoSided = true;
        FaceMesh mesh;
        mesh.add(std::move(pane));
        id = writer_.addMesh(mesh, false);
    }
    return id;
}

double rounded(double v) {
    return std::round(v * 65536.0) / 65536.0;
}

Json FillingList::entry(const std::string& name, dat::RecordId cell, std::size_t portal, bool opaque,
                        double open) {
    Json json;
    json["name"] = name;
    json["cell"] = fmt::format("0x{:08X}", cell);
    json["portal"] = portal;
    json["opaque"] = opaque;
    json["open"] = open;
    json["leaves"] = Json::array();
    return json;
}

Json FillingList::leaf(dat::RecordId model, const Placement& building, const Vec3& hinge, const Vec3& along,
                       double swing) {
    const Vec3 at = globalOf(building, hinge);
    const Vec3 ahead = place({Vec3(0.0), building.turn}, along);
    // Yaw turns +y (0 is north); the leaf is along +x.
    const double yaw = std::fmod(720.0 - std::atan2(ahead.y, ahead.x) * 180.0 / std::numbers::pi, 360.0);
    Json json;
    json["model"] = fmt::format("0x{:08X}", model);
    json["position"] = {rounded(at.x), rounded(at.y), rounded(at.z)};
    json["yaw"] = std::round(yaw * 1024.0) / 1024.0;
    json["swing"] = swing;
    return json;
}

void FillingList::door(const DoorSpec& spec) {
    const std::size_t portal = findPortal(spec);
    const OpeningView view = viewOf(cellOf(spec.cell), portal);
    const double width = glm::length(view.right - view.left) / (spec.twoLeaves ? 2.0 : 1.0);
    const dat::RecordId model = leafModel(width, view.height);
    Json json = entry(spec.name, spec.cell, portal, true, spec.open);
    const auto add = [&](bool right) {
        const Vec3& hinge = right ? view.right : view.left;
        const Vec3 along = glm::normalize((right ? view.left : view.right) - hinge);
        // A left leaf that opens into the cell turns clockwise seen from above.
        const double swing = (right == spec.intoCell ? -1.0 : 1.0) * kSwing;
        json["leaves"].push_back(
            leaf(model, *spec.building, hinge + along * (kLeafThick / 2.0), along, swing));
    };
    if (spec.twoLeaves) {
        add(false);
        add(true);
    } else {
        add(spec.hingeOnTheRight);
    }
    list_.push_back(std::move(json));
}

void FillingList::panes(const char* name, const Placement& building,
                        const std::vector<dat::RecordId>& cells) {
    int count = 0;
    for (const dat::RecordId id : cells) {
        for (std::size_t k = 0; k < cellOf(id).portals.size(); ++k) {
            if (!isWindow(cellOf(id), k))
                continue;
            const OpeningView view = viewOf(cellOf(id), k);
            const Vec3 across = view.right - view.left;
            Json json = entry(fmt::format("{}.window.{}", name, ++count), id, k, false, 0.0);
            json["leaves"].push_back(leaf(paneModel(glm::length(across), view.height), building, view.left,
                                          glm::normalize(across), 0.0));
            list_.push_back(std::move(json));
        }
    }
}

} // namespace

Json buildDoors(ModelWriter& writer, const VillageMap& map) {
    const auto home = [&](CottageCell c) { return map.cottageCells.at(static_cast<std::size_t>(c)); };
    const auto theirs = [&](NeighbourCell c) { return map.neighbourCells.at(static_cast<std::size_t>(c)); };
    const auto inn = [&](InnCell c) { return map.innCells.at(static_cast<std::size_t>(c)); };
    FillingList list(writer);
    // The cottages' doors are open, so that one can see through the house.
    list.door(
        {.name = "cottage.front", .building = &map.cottage, .cell = home(CottageCell::Front), .open = 1.0});
    list.door({.name = "neighbour.front",
               .building = &map.neighbour,
               .cell = theirs(NeighbourCell::Room),
               .open = 1.0});
    const auto innDoor = [&](DoorSpec spec, InnCell cell) {
        spec.building = &map.inn;
        spec.cell = inn(cell);
        list.door(spec);
    };
    innDoor({.name = "inn.front", .hingeOnTheRight = true, .open = 1.0}, InnCell::Hall);
    innDoor({.name = "inn.kitchen", .to = inn(InnCell::KitchenDoor), .open = 0.0}, InnCell::Hall);
    innDoor({.name = "inn.parlour", .to = inn(InnCell::ParlourDoor), .open = 1.0}, InnCell::Parlour);
    innDoor({.name = "inn.back", .hingeOnTheRight = true, .open = 0.0}, InnCell::Passage);
    innDoor({.name = "inn.balcony", .hingeOnTheRight = true, .open = 1.0}, InnCell::Landing);
    innDoor({.name = "inn.west", .to = inn(InnCell::WestRoomDoor), .open = 0.0}, InnCell::WestRoom);
    innDoor({.name = "inn.north", .to = inn(InnCell::NorthRoomDoor), .open = 0.4}, InnCell::NorthRoom);
    innDoor({.name = "inn.east", .to = inn(InnCell::EastRoomDoor), .hingeOnTheRight = true, .open = 1.0},
            InnCell::EastRoom);
    innDoor({.name = "inn.cellar", .to = inn(InnCell::BasementDoor), .open = 1.0}, InnCell::Basement);
    list.door({.name = "meetinghall.front",
               .building = &map.hall,
               .cell = map.hallCells.at(static_cast<std::size_t>(HallCell::Nave)),
               .twoLeaves = true,
               .open = 1.0});
    list.panes("cottage", map.cottage, map.cottageCells);
    list.panes("neighbour", map.neighbour, map.neighbourCells);
    list.panes("inn", map.inn, map.innCells);
    list.panes("meetinghall", map.hall, map.hallCells);
    return list.take();
}

} // namespace limen::worlds
