#include "worlds/builtin/buildings/Furniture.h"

namespace limen::worlds {

namespace {

constexpr std::uint32_t kCandleLight = 0xFFFFC070;
constexpr std::uint32_t kFireLight = 0xFFFF9040;

/// A Setup of a top and four legs as parts.
dat::RecordId onLegs(ModelWriter& writer, const FaceMesh& top, double x, double y, double height,
                     double thick) {
    FaceMesh leg;
    leg.beam({-thick / 2, -thick / 2, 0.0}, {thick / 2, thick / 2, height}, Material::Oak);
    const dat::RecordId legId = writer.addMesh(leg);
    std::vector<SetupPart> parts{{writer.addMesh(top), {}}};
    for (const double sx : {-1.0, 1.0})
        for (const double sy : {-1.0, 1.0})
            parts.push_back({legId, {{sx * x, sy * y, 0.0}, 0.0}});
    return writer.addSetup(parts);
}

dat::RecordId addTable(ModelWriter& writer) {
    FaceMesh top;
    for (int k = 0; k < 4; ++k) {
        const double y = -0.42 + 0.21 * k;
        top.beam({-0.85, y + 0.004, 0.71}, {0.85, y + 0.206, 0.76}, Material::Oak);
    }
    top.beam({-0.72, -0.34, 0.60}, {0.72, -0.31, 0.71}, Material::Oak);
    top.beam({-0.72, 0.31, 0.60}, {0.72, 0.34, 0.71}, Material::Oak);
    top.beam({-0.75, -0.31, 0.60}, {-0.72, 0.31, 0.71}, Material::Oak);
    top.beam({0.72, -0.31, 0.60}, {0.75, 0.31, 0.71}, Material::Oak);
    return onLegs(writer, top, 0.73, 0.33, 0.72, 0.08); // the legs end inside the boards
}

dat::RecordId addChair(ModelWriter& writer) {
    FaceMesh seat;
    seat.beam({-0.22, -0.22, 0.42}, {0.22, 0.22, 0.46}, Material::Oak);
    for (const double x : {-0.19, 0.19})
        seat.strut({x, 0.20, 0.46}, {x, 0.27, 1.02}, {1, 0, 0}, 0.045, 0.045, Material::Oak);
    seat.beam({-0.21, 0.235, 0.86}, {0.21, 0.265, 1.00}, Material::Oak);
    seat.beam({-0.17, 0.215, 0.62}, {0.17, 0.24, 0.70}, Material::Oak);
    return onLegs(writer, seat, 0.19, 0.19, 0.42, 0.045);
}

dat::RecordId addStool(ModelWriter& writer) {
    FaceMesh seat;
    seat.cylinder({.base = {0, 0, 0.40}, .lower = 0.19, .upper = 0.20, .height = 0.05, .sides = 12});
    return onLegs(writer, seat, 0.11, 0.11, 0.40, 0.045);
}

dat::RecordId addBench(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.75, -0.16, 0.41}, {0.75, 0.16, 0.46}, Material::OldPlanks);
    for (const double x : {-0.58, 0.58})
        mesh.beam({x - 0.03, -0.14, 0.0}, {x + 0.03, 0.14, 0.41}, Material::OldPlanks);
    mesh.beam({-0.55, -0.02, 0.14}, {0.55, 0.02, 0.20}, Material::OldPlanks);
    return writer.addSingle(mesh);
}

dat::RecordId addBed(ModelWriter& writer) {
    FaceMesh frame;
    for (const double x : {-0.55, 0.55}) {
        frame.beam({x - 0.04, -1.05, 0.0}, {x + 0.04, -0.97, 0.75}, Material::Oak);
        frame.beam({x - 0.04, 0.97, 0.0}, {x + 0.04, 1.05, 1.15}, Material::Oak);
        frame.beam({x - 0.025, -0.97, 0.26}, {x + 0.025, 0.97, 0.42}, Material::Oak);
    }
    frame.beam({-0.51, 0.99, 0.35}, {0.51, 1.03, 1.05}, Material::Oak);
    frame.beam({-0.51, -1.03, 0.26}, {0.51, -0.99, 0.62}, Material::Oak);
    FaceMesh bedding;
    bedding.box({-0.52, -0.97, 0.30}, {0.52, 0.97, 0.52}, Material::Linen);
    bedding.box({-0.56, -0.98, 0.36}, {0.56, 0.42, 0.565}, Material::Blanket);
    bedding.box({-0.36, 0.55, 0.52}, {0.36, 0.92, 0.66}, Material::Linen);
    return writer.addSetup({{writer.addMesh(frame), {}}, {writer.addMesh(bedding), {}}});
}

dat::RecordId addChest(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.5, -0.27, 0.04}, {0.5, 0.27, 0.42}, Material::OldPlanks);
    mesh.beam({-0.53, -0.30, 0.42}, {0.53, 0.30, 0.52}, Material::Oak);
    for (const double x : {-0.36, 0.36})
        mesh.box({x - 0.03, -0.31, 0.02}, {x + 0.03, 0.31, 0.53}, Material::Iron);
    mesh.box({-0.06, -0.325, 0.36}, {0.06, -0.27, 0.47}, Material::Iron);
    return writer.addSingle(mesh);
}

dat::RecordId addShelf(ModelWriter& writer) {
    FaceMesh mesh;
    for (const double x : {-0.6, 0.57})
        mesh.beam({x, -0.32, 0.0}, {x + 0.03, 0.0, 1.95}, Material::Oak);
    for (const double z : {0.08, 0.55, 1.02, 1.49, 1.92})
        mesh.beam({-0.57, -0.31, z}, {0.57, -0.02, z + 0.03}, Material::Oak);
    mesh.beam({-0.57, -0.02, 0.0}, {0.57, 0.0, 1.95}, Material::OldPlanks);
    for (const double z : {0.58, 1.05}) {
        mesh.card({Vec3(-0.52, -0.24, z), Vec3(0.28, -0.24, z), Vec3(0.28, -0.24, z + 0.33),
                   Vec3(-0.52, -0.24, z + 0.33)},
                  Material::Books, false);
        mesh.box({-0.52, -0.235, z}, {0.28, -0.03, z + 0.27}, Material::Linen);
    }
    mesh.cylinder({.base = {0.42, -0.16, 1.05},
                   .lower = 0.07,
                   .upper = 0.09,
                   .height = 0.16,
                   .sides = 10,
                   .side = Material::Brick,
                   .cap = Material::Brick});
    mesh.cylinder({.base = {-0.3, -0.16, 1.52},
                   .lower = 0.10,
                   .upper = 0.06,
                   .height = 0.24,
                   .sides = 10,
                   .side = Material::Brick,
                   .cap = Material::Iron});
    mesh.cylinder({.base = {0.1, -0.16, 1.52},
                   .lower = 0.08,
                   .upper = 0.10,
                   .height = 0.12,
                   .sides = 10,
                   .side = Material::Brick,
                   .cap = Material::Iron});
    mesh.box({-0.4, -0.26, 0.11}, {0.2, -0.04, 0.36}, Material::OldPlanks);
    return writer.addSingle(mesh);
}

dat::RecordId addFireplace(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-1.05, -0.62, 0.0}, {-0.62, 0.0, 1.25}, Material::StoneWall);
    mesh.box({0.62, -0.62, 0.0}, {1.05, 0.0, 1.25}, Material::StoneWall);
    mesh.beam({-1.12, -0.68, 1.25}, {1.12, 0.0, 1.45}, Material::Beam);
    mesh.box({-0.85, -0.52, 1.45}, {0.85, 0.0, 2.5}, Material::StoneWall);
    mesh.polygon({{-0.62, -0.03, 0.0}, {0.62, -0.03, 0.0}, {0.62, -0.03, 1.25}, {-0.62, -0.03, 1.25}},
                 Material::Brick);
    mesh.box({-1.15, -1.05, 0.0}, {1.15, -0.62, 0.05}, Material::Flagstones);
    mesh.box({-0.62, -0.62, 0.0}, {0.62, -0.03, 0.05}, Material::Brick);
    for (const double x : {-0.28, 0.28})
        mesh.box({x - 0.02, -0.46, 0.05}, {x + 0.02, -0.12, 0.12}, Material::Iron);
    mesh.box({-0.34, -0.42, 0.06}, {0.34, -0.14, 0.10}, Material::Embers);
    mesh.strut({-0.42, -0.30, 0.17}, {0.42, -0.26, 0.17}, {0, 1, 0}, 0.11, 0.11, Material::Bark);
    mesh.strut({-0.36, -0.20, 0.16}, {0.38, -0.36, 0.24}, {0, 1, 0}, 0.10, 0.10, Material::Bark);
    FaceMesh flames;
    for (const double x : {-0.16, 0.0, 0.17}) {
        const double high = x == 0.0 ? 0.52 : 0.36;
        const double y = -0.27 + 0.15 * x;
        flames.card({Vec3(x - 0.15, y, 0.15), Vec3(x + 0.15, y, 0.15), Vec3(x + 0.15, y, 0.15 + high),
                     Vec3(x - 0.15, y, 0.15 + high)},
                    Material::Flame, true);
        flames.card({Vec3(x, -0.40, 0.15), Vec3(x, -0.14, 0.15), Vec3(x, -0.14, 0.12 + high),
                     Vec3(x, -0.40, 0.12 + high)},
                    Material::Flame, true);
    }
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(flames, false), {}}},
                           {{{0.0, -0.75, 0.55}, kFireLight, 0.55, 6.5}});
}

dat::RecordId addBarrel(ModelWriter& writer) {
    FaceMesh mesh;
    const std::array<Vec2, 5> rings{Vec2{0.29, 0.0}, Vec2{0.345, 0.24}, Vec2{0.365, 0.45}, Vec2{0.345, 0.66},
                                    Vec2{0.29, 0.90}};
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        FaceMesh ring;
        ring.cylinder({.base = {0, 0, rings[k].y},
                       .lower = rings[k].x,
                       .upper = rings[k + 1].x,
                       .height = rings[k + 1].y - rings[k].y,
                       .sides = 14,
                       .side = Material::BarrelStaves,
                       .wrapOnce = true,
                       .caps = false});
        for (Face& face : ring.faces()) {
            for (std::size_t i = 0; i < face.uvs.size(); ++i)
                face.uvs[i].y = 1.0 - face.points[i].z / 0.90;
            mesh.add(std::move(face));
        }
    }
    FaceMesh lid;
    lid.cylinder({.base = {0, 0, 0.0},
                  .lower = 0.28,
                  .upper = 0.28,
                  .height = 0.87,
                  .sides = 14,
                  .side = Material::Oak,
                  .cap = Material::OldPlanks});
    mesh.add(lid.faces()[lid.faces().size() - 2]);
    return writer.addSingle(mesh);
}

dat::RecordId addCrate(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.36, -0.28, 0.03}, {0.36, 0.28, 0.55}, Material::OldPlanks);
    for (const double x : {-0.38, 0.31})
        for (const double y : {-0.30, 0.23})
            mesh.beam({x, y, 0.0}, {x + 0.07, y + 0.07, 0.58}, Material::Oak);
    for (const double z : {0.02, 0.50}) {
        mesh.beam({-0.31, -0.295, z}, {0.31, -0.265, z + 0.07}, Material::Oak);
        mesh.beam({-0.31, 0.265, z}, {0.31, 0.295, z + 0.07}, Material::Oak);
    }
    return writer.addSingle(mesh);
}

dat::RecordId addSacks(ModelWriter& writer) {
    FaceMesh sack;
    const std::array<Vec2, 5> rings{Vec2{0.24, 0.0}, Vec2{0.30, 0.18}, Vec2{0.26, 0.42}, Vec2{0.10, 0.56},
                                    Vec2{0.15, 0.64}};
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        sack.cylinder({.base = {0, 0, rings[k].y},
                       .lower = rings[k].x,
                       .upper = rings[k + 1].x,
                       .height = rings[k + 1].y - rings[k].y,
                       .sides = 10,
                       .side = Material::Sacking,
                       .cap = Material::Sacking,
                       .caps = k + 2 == rings.size()});
    }
    const dat::RecordId id = writer.addMesh(sack);
    return writer.addSetup(
        {{id, {{-0.3, 0.0, 0.0}, 15.0}}, {id, {{0.28, 0.06, 0.0}, 80.0}}, {id, {{0.0, -0.45, 0.0}, 140.0}}});
}

void addFlameCards(FaceMesh& mesh, const Vec3& foot, double size) {
    const double w = 0.35 * size;
    mesh.card(
        {foot + Vec3(-w, 0, 0), foot + Vec3(w, 0, 0), foot + Vec3(w, 0, size), foot + Vec3(-w, 0, size)},
        Material::Flame, true);
    mesh.card(
        {foot + Vec3(0, -w, 0), foot + Vec3(0, w, 0), foot + Vec3(0, w, size), foot + Vec3(0, -w, size)},
        Material::Flame, true);
}

dat::RecordId addCandle(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, 0},
                   .lower = 0.075,
                   .upper = 0.065,
                   .height = 0.02,
                   .sides = 10,
                   .side = Material::Iron,
                   .cap = Material::Iron});
    mesh.cylinder({.base = {0, 0, 0.02},
                   .lower = 0.024,
                   .upper = 0.022,
                   .height = 0.15,
                   .sides = 8,
                   .side = Material::Wax,
                   .cap = Material::Wax});
    FaceMesh flame;
    addFlameCards(flame, {0, 0, 0.17}, 0.09);
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(flame, false), {}}},
                           {{{0, 0, 0.32}, kCandleLight, 0.32, 5.0}});
}

dat::RecordId addLantern(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.006, -0.006, -0.22}, {0.006, 0.006, 0.0}, Material::Iron);
    mesh.cylinder({.base = {0, 0, -0.30},
                   .lower = 0.13,
                   .upper = 0.03,
                   .height = 0.09,
                   .sides = 8,
                   .side = Material::Iron,
                   .cap = Material::Iron});
    mesh.box({-0.10, -0.10, -0.58}, {0.10, 0.10, -0.55}, Material::Iron);
    for (const double x : {-0.095, 0.075})
        for (const double y : {-0.095, 0.075})
            mesh.beam({x, y, -0.55}, {x + 0.02, y + 0.02, -0.30}, Material::Iron);
    mesh.cylinder({.base = {0, 0, -0.55},
                   .lower = 0.025,
                   .upper = 0.022,
                   .height = 0.10,
                   .sides = 8,
                   .side = Material::Wax,
                   .cap = Material::Wax});
    FaceMesh glass;
    addFlameCards(glass, {0, 0, -0.45}, 0.10);
    glass.box({-0.078, -0.078, -0.545}, {0.078, 0.078, -0.31}, Material::LampGlass);
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(glass, false), {}}},
                           {{{0, 0, -0.72}, kCandleLight, 0.48, 8.5}});
}

dat::RecordId addRug(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-1.1, -0.75, 0.0}, {1.1, 0.75, 0.01}, Material::Linen);
    mesh.card(
        {Vec3(-1.1, -0.75, 0.014), Vec3(1.1, -0.75, 0.014), Vec3(1.1, 0.75, 0.014), Vec3(-1.1, 0.75, 0.014)},
        Material::Rug, false);
    return writer.addSingle(mesh);
}

} // namespace

Furniture addFurniture(ModelWriter& writer) {
    Furniture f;
    f.table = addTable(writer);
    f.chair = addChair(writer);
    f.stool = addStool(writer);
    f.bench = addBench(writer);
    f.bed = addBed(writer);
    f.chest = addChest(writer);
    f.shelf = addShelf(writer);
    f.fireplace = addFireplace(writer);
    f.rug = addRug(writer);
    f.barrel = addBarrel(writer);
    f.crate = addCrate(writer);
    f.sacks = addSacks(writer);
    f.candle = addCandle(writer);
    f.lantern = addLantern(writer);
    FaceMesh jug;
    jug.cylinder({.base = {0, 0, 0},
                  .lower = 0.06,
                  .upper = 0.085,
                  .height = 0.10,
                  .sides = 10,
                  .side = Material::Brick,
                  .caps = false});
    jug.cylinder({.base = {0, 0, 0.10},
                  .lower = 0.085,
                  .upper = 0.05,
                  .height = 0.12,
                  .sides = 10,
                  .side = Material::Brick,
                  .cap = Material::Iron});
    f.jug = writer.addSingle(jug);
    FaceMesh bowl;
    bowl.cylinder({.base = {0, 0, 0},
                   .lower = 0.05,
                   .upper = 0.12,
                   .height = 0.06,
                   .sides = 12,
                   .side = Material::Oak,
                   .cap = Material::Linen});
    f.bowl = writer.addSingle(bowl);
    return f;
}

dat::RecordId addJoists(ModelWriter& writer, double across, double along, double spacing) {
    FaceMesh mesh;
    const int count = std::max(1, static_cast<int>(along / spacing));
    for (int k = 0; k < count; ++k) {
        const double y = along * ((k + 0.5) / count - 0.5);
        mesh.beam({-across / 2 + 0.01, y - 0.07, -0.17}, {across / 2 - 0.01, y + 0.07, -0.002},
                  Material::Beam);
    }
    return writer.addSingle(mesh);
}

dat::RecordId addStairs(ModelWriter& writer, const StairSpec& s) {
    FaceMesh mesh;
    const double half = s.width / 2 - 0.005;
    for (int k = 1; k < s.risers; ++k) {
        const double top = -s.rise * k;
        const double y = s.tread * (k - 1);
        mesh.beam({-half, y - 0.02, top - 0.05}, {half, y + s.tread, top}, Material::Planks);
        mesh.beam({-half + 0.02, y, top - s.rise}, {half - 0.02, y + 0.025, top - 0.05}, Material::OldPlanks);
    }
    const double run = s.tread * (s.risers - 1);
    const double drop = s.rise * (s.risers - 1);
    for (const double x : {-half + 0.03, half - 0.03})
        mesh.strut({x, 0.12, -0.30}, {x, run, -drop - 0.08}, {1, 0, 0}, 0.05, 0.20, Material::Beam);
    return writer.addSingle(mesh);
}

dat::RecordId addRailing(ModelWriter& writer, double length) {
    FaceMesh mesh;
    const int posts = std::max(2, static_cast<int>(length / 0.5) + 1);
    for (int k = 0; k < posts; ++k) {
        const double y = 0.04 + (length - 0.08) * k / (posts - 1);
        const double half = k == 0 || k + 1 == posts ? 0.045 : 0.022;
        mesh.beam({-half, y - half, 0.0}, {half, y + half, 0.90}, Material::Oak);
    }
    mesh.beam({-0.05, 0.0, 0.90}, {0.05, length, 0.96}, Material::Oak);
    return writer.addSingle(mesh);
}

} // namespace limen::worlds
