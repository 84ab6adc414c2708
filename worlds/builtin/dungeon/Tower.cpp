#include "worlds/builtin/dungeon/Tower.h"

#include "worlds/builtin/dungeon/DungeonHub.h"
#include "worlds/builtin/dungeon/TowerStair.h"
#include "worlds/records/Seams.h"

#include <array>

namespace limen::worlds {

namespace {

constexpr double kTowerRoomHeight = 4.5;
constexpr double kInnerHalf = 1.75, kOuterHalf = 2.0625;
constexpr double kBase = -4.0; ///< lower end of the walls, in the ground
constexpr double kCeiling = 2.0 * kTowerStorey + kTowerRoomHeight;
constexpr double kParapetTop = kTowerRoof + 1.0;
constexpr double kParapet = 5.5, kParapetHalf = 2.25; ///< the parapet's outer face

/// Outward directions of the tower's four sides along the axes.
constexpr std::array<std::array<double, 2>, 4> kSides{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

/// An opening in a plane at `reach` metres from the middle.
struct TowerOpening {
    std::size_t side = 0;
    std::size_t room = 0;
    bool door = false;
    [[nodiscard]] Vec3 out() const { return {kSides[side][0], kSides[side][1], 0.0}; }
    [[nodiscard]] Outline at(double reach) const {
        const Vec3 way = out();
        const Vec3 across{std::abs(way.y), std::abs(way.x), 0.0};
        const Vec3 foot = way * reach + Vec3(0.0, 0.0, static_cast<double>(room) * kTowerStorey);
        if (door)
            return archOutline({foot, across, 0.75}, 1.75, 2.375);
        return archOutline({foot + Vec3(0.0, 0.0, 1.0), across, 0.25}, 1.5, 1.75);
    }
};

std::vector<TowerOpening> wallOpenings() {
    std::vector<TowerOpening> out{{0, 0, true}};
    for (std::size_t room = 0; room < 3; ++room)
        for (std::size_t side = room == 0 ? 1 : 0; side < 4; ++side)
            out.push_back({side, room, false});
    return out;
}

Outline hatchAt(double z) {
    return levelOutline(octagon(kHatch, kHatchHalf), z);
}

/// Faces of a wall around the tower, looking outwards, between two rings of corners.
std::vector<Face> wallBetween(const Outline& lower, const Outline& upper, Material material) {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const std::size_t j = (i + 1) % lower.size();
        faces.push_back(planarFace({lower[i], lower[j], upper[j], upper[i]}, material));
    }
    return faces;
}

Outline ringAt(double reach, double half, double z) {
    return levelOutline(octagon(reach, half), z);
}

/// Adds walls with their openings, reveals and portals, without gaps between them.
void addWalls(std::vector<Face>& faces) {
    const std::vector<TowerOpening> openings = wallOpenings();
    for (const Face& wall :
         wallBetween(ringAt(kTowerOuter, kOuterHalf, kBase), ringAt(kTowerOuter, kOuterHalf, kCeiling - 0.75),
                     Material::StoneWall)) {
        std::vector<Outline> own;
        for (const TowerOpening& opening : openings)
            if (glm::dot(faceNormal(wall), opening.out()) > 0.99)
                own.push_back(opening.at(kTowerOuter));
        for (Face& strip : faceWithout(wall, own))
            faces.push_back(std::move(strip));
    }
    for (const TowerOpening& opening : openings) {
        const Outline inner = opening.at(kTowerWall);
        const Outline outer = opening.at(kTowerOuter);
        Vec3 middle(0.0);
        for (std::size_t i = 0; i < inner.size(); ++i)
            middle += (inner[i] + outer[i]) / (2.0 * static_cast<double>(inner.size()));
        for (std::size_t i = 0; i < inner.size(); ++i) {
            const std::size_t j = (i + 1) % inner.size();
            Face reveal = planarFace({inner[i], inner[j], outer[j], outer[i]}, Material::StoneWall);
            if (glm::dot(faceNormal(reveal), middle - inner[i]) < 0.0)
                reveal = planarFace({inner[j], inner[i], outer[i], outer[j]}, Material::StoneWall);
            faces.push_back(std::move(reveal));
        }
        Face portal = portalFace(inner);
        faces.push_back(glm::dot(faceNormal(portal), opening.out()) < 0.0 ? flipped(std::move(portal))
                                                                          : std::move(portal));
    }
}

/// Adds the corbelled parapet, and the roof inside it with the trapdoor.
void addRoof(std::vector<Face>& faces) {
    const auto add = [&](std::vector<Face> more) {
        faces.insert(faces.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
    };
    add(wallBetween(ringAt(kTowerOuter, kOuterHalf, kCeiling - 0.75),
                    ringAt(kParapet, kParapetHalf, kCeiling - 0.25), Material::StoneWall));
    add(wallBetween(ringAt(kParapet, kParapetHalf, kCeiling - 0.25),
                    ringAt(kParapet, kParapetHalf, kParapetTop), Material::StoneWall));
    add(wallBetween(ringAt(kParapet, kParapetHalf, kParapetTop), ringAt(kTowerOuter, kOuterHalf, kParapetTop),
                    Material::Flagstones));
    add(wallBetween(ringAt(kTowerOuter, kOuterHalf, kParapetTop), ringAt(kTowerOuter, kOuterHalf, kTowerRoof),
                    Material::StoneWall));
    const Face roof = planarFace(ringAt(kTowerOuter, kOuterHalf, kTowerRoof), Material::Flagstones);
    add(faceWithout(roof, {hatchAt(kTowerRoof)}));
    Outline top = hatchAt(kTowerRoof);
    Outline ceiling = hatchAt(kCeiling);
    add(wallBetween(top, ceiling, Material::StoneWall)); // in downward order, so that they look inwards
    faces.push_back(portalFace(ceiling));
}

/// Adds two merlons on the parapet of each side.
void addMerlons(FaceMesh& mesh) {
    FaceMesh merlon;
    for (const double y : {-1.12, 1.12}) {
        // A merlon covers the edges of the parapet: a narrow ledge would show as a dashed line.
        merlon.box({kTowerOuter - 0.02, y - 0.55, kParapetTop - 0.1},
                   {kParapet + 0.02, y + 0.55, kParapetTop + 0.85}, Material::StoneWall);
        merlon.box({kTowerOuter - 0.08, y - 0.61, kParapetTop + 0.85},
                   {kParapet + 0.08, y + 0.61, kParapetTop + 0.95}, Material::Rock);
    }
    for (int k = 0; k < 8; ++k)
        mesh.append(merlon, {{}, 45.0 * k});
}

/// Adds a band of stone round the tower.
void addBand(FaceMesh& mesh, double z) {
    const double proud = kTowerOuter + 0.09;
    const double half = kOuterHalf + 0.0375;
    const Outline foot = ringAt(kTowerOuter - 0.05, kOuterHalf - 0.02, z);
    const Outline low = ringAt(proud, half, z);
    const Outline high = ringAt(proud, half, z + 0.25);
    const Outline back = ringAt(kTowerOuter - 0.05, kOuterHalf - 0.02, z + 0.25);
    for (const auto& [a, b] : {std::pair{&foot, &low}, std::pair{&low, &high}, std::pair{&high, &back}})
        for (Face& face : wallBetween(*a, *b, Material::Rock))
            mesh.add(std::move(face));
}

void addDoorSteps(FaceMesh& mesh) {
    const double foot = -kTowerSill - 0.6;
    mesh.box({-1.0, -kTowerOuter - 0.6, foot}, {1.0, -kTowerOuter + 0.02, -kTowerSill / 3.0},
             Material::Flagstones);
    mesh.box({-1.3, -kTowerOuter - 1.1, foot}, {1.3, -kTowerOuter - 0.6, -2.0 * kTowerSill / 3.0},
             Material::Flagstones);
}

FaceMesh exterior() {
    std::vector<Face> faces;
    addWalls(faces);
    addRoof(faces);
    closeSeams(faces);
    FaceMesh mesh;
    for (Face& face : faces)
        mesh.add(std::move(face));
    addMerlons(mesh);
    addBand(mesh, kTowerStorey - 0.25);
    addBand(mesh, 2.0 * kTowerStorey - 0.25);
    addDoorSteps(mesh);
    return mesh;
}

void furnishTower(CellComplex& complex, ModelWriter& writer, const DungeonProps& props) {
    const dat::RecordId stair = addWindingStair(writer);
    const dat::RecordId railing = addHatchRailing(writer);
    const dat::RecordId newel = addNewelEnd(writer);
    for (std::size_t room = 0; room < 3; ++room) {
        const Vec3 floor{0.0, 0.0, static_cast<double>(room) * kTowerStorey};
        const std::size_t cell = 2 * room;
        complex.furnish(cell, {stair, {floor, 0.0}});
        if (room > 0)
            complex.furnish(cell, {railing, {floor, 0.0}});
        for (const double side : {-1.0, 1.0})
            hangTorch(complex, cell, props, floor + Vec3(side * 1.1, kTowerWall, 1.9), {0.0, 1.0, 0.0});
        hangTorch(complex, cell, props, floor + Vec3(1.2, -kTowerWall, 1.9), {0.0, -1.0, 0.0});
    }
    complex.furnish(4, {newel, {{0.0, 0.0, 3.0 * kTowerStorey}, 0.0}});
    complex.furnish(0, {props.house.barrel, {{-3.1, 1.9, 0.0}, 0.0}});
    complex.furnish(0, {props.house.barrel, {{-3.6, 1.1, 0.0}, 70.0}});
    complex.furnish(0, {props.house.crate, {{-3.3, -1.7, 0.0}, 30.0}});
    complex.furnish(2, {props.house.bed, {{-3.2, 0.0, kTowerStorey}, 0.0}});
    complex.furnish(2, {props.house.chest, {{0.0, 3.7, kTowerStorey}, 0.0}});
    complex.furnish(4, {props.house.table, {{-3.1, 0.0, 2.0 * kTowerStorey}, 90.0}});
    complex.furnish(4, {props.house.stool, {{-2.3, 0.9, 2.0 * kTowerStorey}, 0.0}});
    complex.furnish(4, {props.house.crate, {{2.4, 2.6, 2.0 * kTowerStorey}, 45.0}});
}

} // namespace

BuildingPlan planTower(ModelWriter& writer, const DungeonProps& props) {
    CellComplex complex;
    const ShellMaterials stone{Material::Flagstones, Material::StoneWall, Material::OldPlanks};
    const ShellMaterials boards{Material::Planks, Material::StoneWall, Material::OldPlanks};
    for (std::size_t room = 0; room < 3; ++room) {
        const double z = static_cast<double>(room) * kTowerStorey;
        const std::size_t cell =
            complex.addSwept("tower.room", levelOutline(octagon(kTowerWall, kInnerHalf), z),
                             {0.0, 0.0, kTowerRoomHeight}, room == 0 ? stone : boards);
        if (room > 0)
            complex.join(cell - 1, cell, hatchAt(z));
        for (const TowerOpening& opening : wallOpenings())
            if (opening.room == room)
                complex.open(cell, opening.at(kTowerWall));
        if (room < 2) {
            const std::size_t hatch = complex.addSwept("tower.hatch", hatchAt(z + kTowerRoomHeight),
                                                       {0.0, 0.0, kTowerStorey - kTowerRoomHeight}, stone);
            complex.join(cell, hatch, hatchAt(z + kTowerRoomHeight));
        } else {
            complex.open(cell, hatchAt(kCeiling));
        }
    }
    furnishTower(complex, writer, props);
    BuildingPlan plan;
    plan.name = "tower";
    plan.exterior = exterior();
    plan.cells = complex.finish();
    return plan;
}

} // namespace limen::worlds
