#include "worlds/builtin/dungeon/TowerStair.h"

#include <cmath>
#include <numbers>

namespace limen::worlds {

namespace {

constexpr int kStairsPerTurn = 24;
constexpr double kRise = kTowerStorey / kStairsPerTurn;
constexpr double kNewel = 0.18, kTreadEnd = 1.62;

} // namespace

double stairAngle(double z) {
    return 2.0 * std::numbers::pi * z / kTowerStorey;
}

dat::RecordId addWindingStair(ModelWriter& writer) {
    const auto at = [](double radius, int step, double z) {
        const double a = 2.0 * std::numbers::pi * step / kStairsPerTurn;
        return Vec3(radius * std::cos(a), radius * std::sin(a), z);
    };
    FaceMesh mesh;
    for (int k = 0; k < kStairsPerTurn; ++k) {
        // The last step is the landing, 1 cm below the next floor.
        const double top = k + 1 < kStairsPerTurn ? kRise * (k + 1) : kTowerStorey - 0.01;
        const double low = std::max(top - 1.35 * kRise, 0.01); // above the plane of the opening below
        const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, Material material) {
            mesh.polygon({a, b, c, d}, material);
        };
        const double in = kNewel - 0.03;
        quad(at(in, k, top), at(kTreadEnd, k, top), at(kTreadEnd, k + 1, top), at(in, k + 1, top),
             Material::Flagstones);
        quad(at(in, k + 1, low), at(kTreadEnd, k + 1, low), at(kTreadEnd, k, low), at(in, k, low),
             Material::StoneWall);
        quad(at(in, k, low), at(kTreadEnd, k, low), at(kTreadEnd, k, top), at(in, k, top),
             Material::StoneWall);
        quad(at(kTreadEnd, k + 1, low), at(in, k + 1, low), at(in, k + 1, top), at(kTreadEnd, k + 1, top),
             Material::StoneWall);
        quad(at(kTreadEnd, k, low), at(kTreadEnd, k + 1, low), at(kTreadEnd, k + 1, top),
             at(kTreadEnd, k, top), Material::StoneWall);
        if (k > 1 && k + 2 < kStairsPerTurn) {
            const Vec3 rail = at(kTreadEnd - 0.06, k, top + 0.85);
            const Vec3 next = at(kTreadEnd - 0.06, k + 1, top + kRise + 0.85);
            mesh.strut(rail, next, {0, 0, 1}, 0.035, 0.035, Material::Iron);
            mesh.strut(at(kTreadEnd - 0.06, k, top - 0.05), rail, at(1.0, k, 0.0), 0.02, 0.02,
                       Material::Iron);
        }
    }
    mesh.cylinder({.base = {0, 0, 0},
                   .lower = kNewel,
                   .upper = kNewel,
                   .height = kTowerStorey,
                   .sides = 12,
                   .side = Material::StoneWall,
                   .caps = false});
    return writer.addSetup({{writer.addMesh(mesh), {}}});
}

dat::RecordId addHatchRailing(ModelWriter& writer) {
    const std::vector<Vec2> corners = octagon(kHatch + 0.08, kHatchHalf + 0.03);
    FaceMesh mesh;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vec3 a(corners[i], 0.0);
        const Vec3 b(corners[(i + 1) % corners.size()], 0.0);
        const double thick =
            i % 2 == 0
                ? 0.05
                : 0.06; // rails meet at the corners; different sizes keep their faces in different planes
        mesh.strut(a + Vec3(0, 0, 0.9), b + Vec3(0, 0, 0.9), {0, 0, 1}, thick, 0.06, Material::Oak);
        for (int k = 0; k < 5; ++k) {
            const Vec3 foot = a + (b - a) * (k / 5.0);
            const double half = k == 0 ? 0.035 : 0.018;
            mesh.beam(foot - Vec3(half, half, 0.0), foot + Vec3(half, half, k == 0 ? 0.95 : 0.88),
                      Material::Oak);
        }
    }
    return writer.addSetup({{writer.addMesh(mesh), {}}});
}

dat::RecordId addNewelEnd(ModelWriter& writer) {
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, 0},
                   .lower = kNewel,
                   .upper = kNewel,
                   .height = 0.6,
                   .sides = 12,
                   .side = Material::StoneWall,
                   .cap = Material::Flagstones});
    mesh.faces().pop_back(); // the lower cap is never visible
    return writer.addSetup({{writer.addMesh(mesh), {}}});
}

} // namespace limen::worlds
