#include "worlds/builtin/dungeon/DungeonProps.h"

namespace limen::worlds {

namespace {

constexpr std::uint32_t kTorchLight = 0xFFFFA850;
constexpr std::uint32_t kEmberLight = 0xFFFF9040;

/// Adds two crossing pictures of a flame.
void addFlame(FaceMesh& mesh, const Vec3& foot, double half, double high) {
    const Vec3 up{0.0, 0.0, high};
    for (const Vec3& side : {Vec3(half, 0.0, 0.0), Vec3(0.0, half, 0.0)})
        mesh.card({foot - side, foot + side, foot + side + up, foot - side + up}, Material::Flame, true);
}

dat::RecordId addTorch(ModelWriter& writer) {
    const Vec3 bowl{0.0, -kTorchFlameOut, kTorchFlameUp};
    FaceMesh mesh;
    mesh.beam({-0.05, -0.03, -0.16}, {0.05, 0.0, 0.12}, Material::Iron);
    mesh.strut({0.0, -0.02, 0.0}, {0.0, bowl.y, 0.06}, {1, 0, 0}, 0.03, 0.03, Material::Iron);
    mesh.cylinder({.base = {bowl.x, bowl.y, -0.30},
                   .lower = 0.022,
                   .upper = 0.04,
                   .height = 0.52,
                   .sides = 8,
                   .side = Material::Oak,
                   .cap = Material::Oak});
    mesh.cylinder({.base = {bowl.x, bowl.y, 0.20},
                   .lower = 0.055,
                   .upper = 0.075,
                   .height = 0.12,
                   .sides = 8,
                   .side = Material::Iron,
                   .cap = Material::Embers});
    FaceMesh flame;
    addFlame(flame, bowl - Vec3(0.0, 0.0, 0.03), 0.13, 0.40);
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(flame, false), {}}},
                           {{bowl + Vec3(0.0, -0.15, 0.25), kTorchLight, 0.55, 10.0}});
}

dat::RecordId addBrazier(ModelWriter& writer) {
    FaceMesh mesh;
    for (int k = 0; k < 3; ++k) {
        const double a = 2.0943951023931953 * k + 0.3;
        const Vec3 out{std::cos(a), std::sin(a), 0.0};
        mesh.strut(out * 0.42, out * 0.22 + Vec3(0, 0, 0.62), {-out.y, out.x, 0.0}, 0.05, 0.05,
                   Material::Iron);
    }
    mesh.cylinder({.base = {0, 0, 0.55},
                   .lower = 0.24,
                   .upper = 0.46,
                   .height = 0.34,
                   .sides = 12,
                   .side = Material::Iron,
                   .cap = Material::Embers});
    FaceMesh flames;
    for (const Vec3& foot : {Vec3(0.0, 0.0, 0.80), Vec3(0.19, 0.08, 0.82), Vec3(-0.16, 0.13, 0.82)})
        addFlame(flames, foot, 0.22, foot.x == 0.0 ? 0.78 : 0.5);
    return writer.addSetup({{writer.addMesh(mesh), {}}, {writer.addMesh(flames, false), {}}},
                           {{{0.0, 0.0, 1.7}, kEmberLight, 0.75, 14.0}});
}

dat::RecordId addStele(ModelWriter& writer) {
    FaceMesh mesh;
    const std::array<Vec3, 4> rings{Vec3(0.85, 0.5, -1.0), Vec3(0.8, 0.45, 1.6), Vec3(0.62, 0.36, 4.1),
                                    Vec3(0.3, 0.2, 5.0)};
    const auto corner = [&](std::size_t ring, int k) {
        const Vec3& r = rings[ring];
        const double lean = 0.04 * r.z;
        return Vec3((k == 0 || k == 3 ? -r.x : r.x) + lean, k < 2 ? -r.y : r.y, r.z);
    };
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
        for (int k = 0; k < 4; ++k) {
            const int next = (k + 1) % 4;
            mesh.polygon({corner(ring, k), corner(ring, next), corner(ring + 1, next), corner(ring + 1, k)},
                         Material::Rock);
        }
    }
    mesh.polygon({corner(3, 0), corner(3, 1), corner(3, 2), corner(3, 3)}, Material::Rock);
    return writer.addSingle(mesh);
}

dat::RecordId addMast(ModelWriter& writer) {
    constexpr double kTop = 13.0;
    FaceMesh mesh;
    mesh.cylinder({.base = {0, 0, -1.0}, .lower = 0.14, .upper = 0.06, .height = kTop + 1.0, .sides = 10});
    mesh.cylinder({.base = {0, 0, kTop},
                   .lower = 0.10,
                   .upper = 0.0,
                   .height = 0.35,
                   .sides = 8,
                   .side = Material::Iron,
                   .cap = Material::Iron});
    mesh.box({-0.45, -0.45, -0.6}, {0.45, 0.45, 0.5}, Material::StoneWall);
    mesh.beam({-0.2, -0.03, 12.30}, {1.75, 0.03, 12.36}, Material::Oak);
    mesh.card({Vec3(0.15, 0.0, 8.6), Vec3(1.65, 0.0, 8.6), Vec3(1.65, 0.0, 12.30), Vec3(0.15, 0.0, 12.30)},
              Material::Blanket, true);
    return writer.addSingle(mesh);
}

} // namespace

DungeonProps addDungeonProps(ModelWriter& writer, const Furniture& house) {
    DungeonProps props;
    props.torch = addTorch(writer);
    props.brazier = addBrazier(writer);
    props.stele = addStele(writer);
    props.mast = addMast(writer);
    props.house = house;
    return props;
}

dat::RecordId addColumn(ModelWriter& writer, double height, double radius) {
    const double wide = radius * 1.35;
    FaceMesh mesh;
    mesh.box({-wide, -wide, 0.0}, {wide, wide, 0.35}, Material::Flagstones);
    mesh.cylinder({.base = {0, 0, 0.35},
                   .lower = radius,
                   .upper = radius * 0.9,
                   .height = height - 0.75,
                   .sides = 14,
                   .side = Material::StoneWall,
                   .caps = false});
    mesh.box({-wide, -wide, height - 0.4}, {wide, wide, height - 0.003}, Material::Flagstones);
    return writer.addSingle(mesh);
}

dat::RecordId addIronRailing(ModelWriter& writer, double length) {
    FaceMesh mesh;
    const int bars = std::max(2, static_cast<int>(length / 0.25) + 1);
    for (int k = 0; k < bars; ++k) {
        const double y = 0.03 + (length - 0.06) * k / (bars - 1);
        mesh.beam({-0.015, y - 0.015, 0.0}, {0.015, y + 0.015, 0.87}, Material::Iron);
    }
    mesh.beam({-0.03, 0.0, 0.87}, {0.03, length, 0.91}, Material::Iron);
    return writer.addSingle(mesh);
}

} // namespace limen::worlds
