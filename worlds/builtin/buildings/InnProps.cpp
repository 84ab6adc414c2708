#include "worlds/builtin/buildings/InnProps.h"

#include "worlds/builtin/buildings/Inn.h"

namespace limen::worlds {

namespace {

dat::RecordId addBar(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-1.80, -0.36, 1.04}, {1.80, 0.30, 1.10}, Material::Oak);
    mesh.beam({-1.74, -0.24, 0.0}, {1.74, -0.18, 1.04}, Material::OldPlanks);
    for (const double x : {-1.735, -0.58, 0.52, 1.675})
        mesh.beam({x, -0.28, 0.004}, {x + 0.06, -0.235, 1.036}, Material::Beam);
    for (const double x : {-1.72, 1.64})
        mesh.beam({x, -0.18, 0.0}, {x + 0.08, 0.26, 1.04}, Material::OldPlanks);
    mesh.beam({-1.64, -0.18, 0.48}, {1.64, 0.22, 0.52}, Material::OldPlanks);
    FaceMesh jug;
    jug.cylinder({.base = {0, 0, 0},
                  .lower = 0.05,
                  .upper = 0.042,
                  .height = 0.13,
                  .sides = 10,
                  .side = Material::Oak,
                  .cap = Material::WaterDark});
    jug.strut({0.05, 0.0, 0.03}, {0.05, 0.0, 0.11}, {0, 1, 0}, 0.02, 0.02, Material::Iron);
    const dat::RecordId mug = writer.addMesh(jug);
    return writer.addSetup({{writer.addMesh(mesh), {}},
                            {mug, {{-0.9, -0.12, 1.10}, 20.0}},
                            {mug, {{-0.66, -0.02, 1.10}, 80.0}},
                            {mug, {{0.72, -0.14, 1.10}, 200.0}},
                            {mug, {{1.3, 0.08, 1.10}, 130.0}}});
}

dat::RecordId addRoundTable(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, 0.70},
                   .lower = 0.52,
                   .upper = 0.55,
                   .height = 0.06,
                   .sides = 16,
                   .cap = Material::Oak});
    mesh.cylinder({.base = {0, 0, 0.04}, .lower = 0.09, .upper = 0.07, .height = 0.67, .sides = 10});
    mesh.beam({-0.34, -0.05, 0.0}, {0.34, 0.05, 0.07}, Material::Oak);
    mesh.beam({-0.05, -0.34, 0.004}, {0.05, 0.34, 0.065}, Material::Oak);
    return writer.addSingle(mesh);
}

/// A flight of stairs down to the south from the origin, kUpper high, with a platform to the north of its
/// head.
dat::RecordId addFlight(ModelWriter& writer) {
    constexpr int kRisers = 16;
    const double rise = inn::kUpper / kRisers;
    const double run = inn::kStairsHead - inn::kStairsFoot;
    const double tread = run / (kRisers - 1);
    FaceMesh mesh;
    constexpr double kHalf = 0.595;
    for (int k = 1; k <= kRisers; ++k) {
        const double top = -rise * k;
        const double y = -tread * (k - 1);
        const double foot = k == kRisers ? top + 0.003 : top;
        const double above = k == 1 ? -0.06 : top + rise - 0.05;
        mesh.beam({-kHalf + 0.02, y, foot}, {kHalf - 0.02, y + 0.02, above}, Material::OldPlanks);
        if (k < kRisers)
            mesh.beam({-kHalf, y - tread - 0.02, top - 0.05}, {kHalf, y + 0.03, top}, Material::Planks);
    }
    for (const double x : {-kHalf + 0.03, kHalf - 0.03}) {
        mesh.strut({x, -0.12, -0.30}, {x, -run, -rise * (kRisers - 1) - 0.08}, {1, 0, 0}, 0.05, 0.20,
                   Material::Beam);
    }
    mesh.beam({-kHalf, -0.02, -0.06}, {kHalf, 0.895, 0.0}, Material::Planks);
    mesh.beam({-kHalf + 0.01, 0.03, -0.22}, {kHalf - 0.01, 0.13, -0.06}, Material::Beam);
    for (const double x : {-kHalf + 0.01, kHalf - 0.11})
        mesh.beam({x, 0.035, -inn::kUpper}, {x + 0.10, 0.125, -0.22}, Material::Beam);
    return writer.addSingle(mesh);
}

dat::RecordId addRack(ModelWriter& writer) {
    FaceMesh frame;
    for (const double x : {-1.25, 0.0, 1.25}) {
        frame.beam({x - 0.05, -0.75, 0.0}, {x + 0.05, -0.65, 1.55}, Material::Beam);
        frame.beam({x - 0.05, -0.15, 0.0}, {x + 0.05, -0.05, 1.55}, Material::Beam);
    }
    for (const double z : {0.14, 0.88})
        for (const double y : {-0.68, -0.14})
            frame.beam({-1.36, y, z}, {1.36, y + 0.06, z + 0.09}, Material::OldPlanks);
    FaceMesh cask; // on its side, along y
    cask.cylinder({.base = {0, 0, -0.36},
                   .lower = 0.25,
                   .upper = 0.29,
                   .height = 0.36,
                   .sides = 14,
                   .side = Material::BarrelStaves,
                   .cap = Material::OldPlanks,
                   .wrapOnce = true});
    cask.faces().erase(cask.faces().begin() + 14);
    FaceMesh other;
    other.cylinder({.base = {0, 0, 0},
                    .lower = 0.29,
                    .upper = 0.25,
                    .height = 0.36,
                    .sides = 14,
                    .side = Material::BarrelStaves,
                    .cap = Material::OldPlanks,
                    .wrapOnce = true});
    other.faces().pop_back();
    cask.append(other, {});
    for (Face& face : cask.faces()) {
        for (auto* list : {&face.points, &face.normals})
            for (Vec3& p : *list)
                p = {p.x, -p.z, p.y};
    }
    cask.beam({-0.02, -0.46, -0.14}, {0.02, -0.355, -0.10}, Material::Oak);
    const dat::RecordId id = writer.addMesh(cask);
    std::vector<SetupPart> parts{{writer.addMesh(frame), {}}};
    for (const double x : {-0.92, -0.32, 0.32, 0.92}) {
        parts.push_back({id, {{x, -0.40, 0.515}, 0.0}});
        parts.push_back({id, {{x, -0.40, 1.255}, 0.0}});
    }
    return writer.addSetup(parts);
}

dat::RecordId addPost(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.box({-0.16, -0.16, 0.0}, {0.16, 0.16, 0.22}, Material::StoneWall);
    mesh.beam({-0.10, -0.10, 0.22}, {0.10, 0.10, inn::kHeight - 0.19}, Material::Beam);
    mesh.beam({-0.62, -0.09, inn::kHeight - 0.19}, {0.62, 0.09, inn::kHeight - 0.002}, Material::Beam);
    for (const double side : {-1.0, 1.0})
        mesh.strut({side * 0.06, 0.0, 2.05}, {side * 0.50, 0.0, 2.62}, {0, 1, 0}, 0.11, 0.10, Material::Beam);
    return writer.addSingle(mesh);
}

} // namespace

InnProps addInnProps(ModelWriter& writer) {
    InnProps p;
    p.bar = addBar(writer);
    p.roundTable = addRoundTable(writer);
    FaceMesh low;
    low.box({-0.85, -0.52, 2.5}, {0.85, 0.0, inn::kHeight - 0.003}, Material::StoneWall);
    p.breast = writer.addSingle(low);
    FaceMesh high;
    high.box({-0.80, -0.48, 0.003}, {0.80, 0.0, inn::kTop - inn::kUpper - 0.003}, Material::StoneWall);
    p.upperBreast = writer.addSingle(high);
    p.stairs = addFlight(writer);
    p.rack = addRack(writer);
    p.post = addPost(writer);
    return p;
}

void addBalcony(FaceMesh& mesh, double ground) {
    constexpr double kHalf = 2.2;
    constexpr double kOut = -1.75;
    const double floor = inn::kBalcony;
    for (int k = 0; k < 8; ++k) {
        const double y = kOut + 0.21 * k;
        mesh.beam({-kHalf, y + 0.004, floor - 0.05}, {kHalf, y + 0.206, floor}, Material::Planks);
    }
    mesh.beam({-kHalf + 0.05, kOut + 0.03, floor - 0.22}, {kHalf - 0.05, kOut + 0.17, floor - 0.05},
              Material::Beam);
    for (const double x : {-1.45, 0.0, 1.45})
        mesh.beam({x - 0.06, kOut + 0.17, floor - 0.18}, {x + 0.06, -0.06, floor - 0.05}, Material::Beam);
    for (const double x : {-kHalf + 0.14, kHalf - 0.14}) {
        mesh.beam({x - 0.08, kOut + 0.02, ground - 0.5}, {x + 0.08, kOut + 0.18, floor - 0.22},
                  Material::Beam);
        mesh.beam({x - 0.07, kOut + 0.17, floor - 0.19}, {x + 0.07, -0.06, floor - 0.05}, Material::Beam);
        const double in = x < 0.0 ? 1.0 : -1.0;
        mesh.strut({x + in * 0.06, kOut + 0.10, floor - 0.95}, {x + in * 0.70, kOut + 0.10, floor - 0.24},
                   {0, 1, 0}, 0.11, 0.10, Material::Beam);
        mesh.strut({x, kOut + 0.16, floor - 0.95}, {x, kOut + 0.78, floor - 0.22}, {1, 0, 0}, 0.10, 0.10,
                   Material::Beam);
    }
    // A railing along the front, and back to the wall on both sides.
    const double top = floor + 0.92;
    mesh.beam({-kHalf, kOut + 0.02, top}, {kHalf, kOut + 0.14, top + 0.07}, Material::Oak);
    for (const double x : {-kHalf + 0.01, kHalf - 0.11}) {
        mesh.beam({x, kOut + 0.14, top}, {x + 0.10, -0.06, top + 0.065}, Material::Oak);
        for (int k = 0; k < 4; ++k) {
            const double y = kOut + 0.45 + 0.36 * k;
            mesh.beam({x + 0.03, y - 0.02, floor}, {x + 0.07, y + 0.02, top}, Material::Oak);
        }
    }
    for (int k = 0; k <= 12; ++k) {
        const double x = -kHalf + 0.06 + (2.0 * kHalf - 0.12) * k / 12.0;
        const double half = k == 0 || k == 6 || k == 12 ? 0.045 : 0.022;
        mesh.beam({x - half, kOut + 0.08 - half, floor}, {x + half, kOut + 0.08 + half, top}, Material::Oak);
    }
    // The sign at the balcony's corner.
    mesh.beam({kHalf - 0.05, kOut + 0.06, floor - 0.16}, {kHalf + 0.95, kOut + 0.12, floor - 0.08},
              Material::Beam);
    for (const double x : {kHalf + 0.2, kHalf + 0.75}) {
        mesh.beam({x - 0.008, kOut + 0.082, floor - 0.36}, {x + 0.008, kOut + 0.098, floor - 0.16},
                  Material::Iron);
    }
    mesh.beam({kHalf + 0.10, kOut + 0.07, floor - 0.92}, {kHalf + 0.85, kOut + 0.11, floor - 0.36},
              Material::Oak);
    mesh.card({Vec3(kHalf + 0.18, kOut + 0.064, floor - 0.86), Vec3(kHalf + 0.77, kOut + 0.064, floor - 0.86),
               Vec3(kHalf + 0.77, kOut + 0.064, floor - 0.42),
               Vec3(kHalf + 0.18, kOut + 0.064, floor - 0.42)},
              Material::BarrelStaves, false);
}

} // namespace limen::worlds
