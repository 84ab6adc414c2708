#include "worlds/builtin/village/OutdoorProps.h"

#include "geometry/Angles.h"

#include <algorithm>

namespace limen::worlds {

namespace {

/// The mesh without the faces whose normal is closer to `away` than to a right angle with it.
FaceMesh without(const FaceMesh& mesh, const std::vector<Vec3>& away) {
    FaceMesh out;
    for (const Face& face : mesh.faces()) {
        const Vec3 normal = faceNormal(face);
        if (std::none_of(away.begin(), away.end(), [&](const Vec3& a) { return glm::dot(a, normal) > 0.7; }))
            out.add(face);
    }
    return out;
}

dat::RecordId addFence(ModelWriter& writer) {
    FaceMesh posts, rails;
    for (const double x : {0.0, 1.5})
        posts.beam({x - 0.06, -0.06, -0.6}, {x + 0.06, 0.06, 1.05}, Material::OldPlanks);
    rails.strut({0.0, 0.07, 0.42}, {3.0, 0.07, 0.46}, {0, 1, 0}, 0.05, 0.11, Material::OldPlanks);
    rails.strut({0.0, 0.07, 0.86}, {3.0, 0.07, 0.83}, {0, 1, 0}, 0.05, 0.11, Material::OldPlanks);
    FaceMesh mesh = posts, far = without(posts, {{0, 0, 1}, {0, 0, -1}});
    mesh.append(rails, {});
    far.append(without(rails, {{1, 0, 0}, {-1, 0, 0}, {0, 0, -1}}),
               {}); // no ends, and nothing seen from below
    const dat::RecordId id = writer.addMesh(mesh);
    writer.setLevels(id, 30.0, {{writer.addMesh(far, false)}});
    return writer.addSetup({{id, {}}});
}

dat::RecordId addWell(ModelWriter& writer) {
    constexpr int kSides = 10;
    constexpr double kOuter = 0.95;
    constexpr double kInner = 0.68;
    FaceMesh ring;
    const auto at = [](double radius, int k, double z) {
        const double a = kTurn * (k % kSides) / kSides;
        return Vec3(radius * std::cos(a), radius * std::sin(a), z);
    };
    for (int k = 0; k < kSides; ++k) {
        ring.polygon(
            {at(kOuter, k, -0.5), at(kOuter, k + 1, -0.5), at(kOuter, k + 1, 0.85), at(kOuter, k, 0.85)},
            Material::StoneWall);
        ring.polygon(
            {at(kInner, k + 1, -0.5), at(kInner, k, -0.5), at(kInner, k, 0.85), at(kInner, k + 1, 0.85)},
            Material::StoneWall);
        ring.polygon(
            {at(kOuter, k, 0.85), at(kOuter, k + 1, 0.85), at(kInner, k + 1, 0.85), at(kInner, k, 0.85)},
            Material::Flagstones);
    }
    std::vector<Vec3> water;
    for (int k = 0; k < kSides; ++k)
        water.push_back(at(kInner, k, 0.25));
    ring.polygon(std::move(water), Material::WaterDark);
    FaceMesh roof;
    for (const double x : {-0.82, 0.82})
        roof.beam({x - 0.06, -0.06, 0.4}, {x + 0.06, 0.06, 2.15}, Material::Beam);
    roof.beam({-1.0, -0.05, 2.10}, {1.0, 0.05, 2.20}, Material::Beam);
    roof.strut({-0.80, 0.0, 1.55}, {0.80, 0.0, 1.55}, {0, 0, 1}, 0.14, 0.14, Material::Oak);
    for (const double side : {-1.0, 1.0}) {
        roof.strut({0.0, side * 0.02, 2.32}, {0.0, side * 0.92, 1.78}, {1, 0, 0}, 2.2, 0.06,
                   Material::OldPlanks);
    }
    FaceMesh bucket;
    bucket.cylinder({.base = {0, 0, 0},
                     .lower = 0.13,
                     .upper = 0.17,
                     .height = 0.28,
                     .sides = 10,
                     .side = Material::BarrelStaves,
                     .cap = Material::WaterDark,
                     .wrapOnce = true});
    bucket.beam({-0.008, -0.008, 0.28}, {0.008, 0.008, 0.62}, Material::Linen);
    return writer.addSetup({{writer.addMesh(ring), {}},
                            {writer.addMesh(roof), {}},
                            {writer.addMesh(bucket), {{0.15, 0.0, 0.93}, 0.0}}});
}

dat::RecordId addWoodpile(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.card(
        {Vec3(-1.1, -0.35, 0.0), Vec3(1.1, -0.35, 0.0), Vec3(1.1, -0.35, 1.05), Vec3(-1.1, -0.35, 1.05)},
        Material::LogEnds, false);
    mesh.card({Vec3(1.1, 0.35, 0.0), Vec3(-1.1, 0.35, 0.0), Vec3(-1.1, 0.35, 1.05), Vec3(1.1, 0.35, 1.05)},
              Material::LogEnds, false);
    mesh.polygon({{1.1, -0.35, 0.0}, {1.1, 0.35, 0.0}, {1.1, 0.35, 1.05}, {1.1, -0.35, 1.05}},
                 Material::Bark);
    mesh.polygon({{-1.1, 0.35, 0.0}, {-1.1, -0.35, 0.0}, {-1.1, -0.35, 1.05}, {-1.1, 0.35, 1.05}},
                 Material::Bark);
    mesh.polygon({{-1.1, -0.35, 1.05}, {1.1, -0.35, 1.05}, {1.1, 0.35, 1.05}, {-1.1, 0.35, 1.05}},
                 Material::Bark);
    for (const double x : {-1.16, 1.16}) {
        mesh.beam({x - 0.05, -0.36, -0.4}, {x + 0.05, -0.26, 1.3}, Material::Beam);
        mesh.beam({x - 0.05, 0.26, -0.4}, {x + 0.05, 0.36, 1.3}, Material::Beam);
    }
    mesh.strut({0.0, -0.62, 1.22}, {0.0, 0.55, 1.42}, {1, 0, 0}, 2.7, 0.05, Material::OldPlanks);
    return writer.addSingle(mesh);
}

dat::RecordId addSignpost(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.07, -0.07, -0.6}, {0.07, 0.07, 2.4}, Material::Beam);
    mesh.beam({0.0, -0.10, 1.95}, {1.05, -0.06, 2.18}, Material::OldPlanks);
    mesh.beam({-0.95, -0.10, 1.62}, {0.10, -0.06, 1.85}, Material::OldPlanks);
    return writer.addSingle(mesh);
}

dat::RecordId addYardBench(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.85, -0.18, 0.40}, {0.85, 0.18, 0.46}, Material::OldPlanks);
    for (const double x : {-0.62, 0.62})
        mesh.box({x - 0.12, -0.15, -0.2}, {x + 0.12, 0.15, 0.40}, Material::StoneWall);
    return writer.addSingle(mesh);
}

dat::RecordId addTrough(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.beam({-0.9, -0.32, -0.1}, {0.9, -0.24, 0.5}, Material::OldPlanks);
    mesh.beam({-0.9, 0.24, -0.1}, {0.9, 0.32, 0.5}, Material::OldPlanks);
    mesh.beam({-0.9, -0.24, -0.1}, {-0.82, 0.24, 0.5}, Material::OldPlanks);
    mesh.beam({0.82, -0.24, -0.1}, {0.9, 0.24, 0.5}, Material::OldPlanks);
    mesh.polygon({{-0.82, -0.24, 0.40}, {0.82, -0.24, 0.40}, {0.82, 0.24, 0.40}, {-0.82, 0.24, 0.40}},
                 Material::WaterDark);
    return writer.addSingle(mesh);
}

dat::RecordId addLampPost(ModelWriter& writer) {
    FaceMesh post;
    post.beam({-0.06, -0.06, -0.6}, {0.06, 0.06, 2.5}, Material::Beam);
    post.beam({-0.04, -0.62, 2.36}, {0.04, 0.0, 2.44}, Material::Beam);
    post.strut({0.0, -0.04, 2.0}, {0.0, -0.42, 2.36}, {1, 0, 0}, 0.05, 0.06, Material::Beam);
    post.box({-0.10, -0.66, 1.84}, {0.10, -0.46, 1.87}, Material::Iron);
    post.cylinder({.base = {0, -0.56, 2.12},
                   .lower = 0.14,
                   .upper = 0.03,
                   .height = 0.10,
                   .sides = 8,
                   .side = Material::Iron,
                   .cap = Material::Iron});
    post.beam({-0.007, -0.567, 2.2}, {0.007, -0.553, 2.37}, Material::Iron);
    FaceMesh glass;
    glass.box({-0.075, -0.635, 1.88}, {0.075, -0.485, 2.11}, Material::LampGlass);
    return writer.addSetup({{writer.addMesh(post), {}}, {writer.addMesh(glass, false), {}}},
                           {{{0.0, -0.56, 1.7}, 0xFFFFC070, 0.6, 8.0}});
}

} // namespace

OutdoorProps addOutdoorProps(ModelWriter& writer) {
    OutdoorProps p;
    p.fence = addFence(writer);
    p.well = addWell(writer);
    p.woodpile = addWoodpile(writer);
    p.signpost = addSignpost(writer);
    p.bench = addYardBench(writer);
    p.trough = addTrough(writer);
    p.lampPost = addLampPost(writer);
    return p;
}

} // namespace limen::worlds
