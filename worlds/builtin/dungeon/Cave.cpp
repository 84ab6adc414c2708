#include "worlds/builtin/dungeon/Cave.h"

#include "worlds/builtin/dungeon/DungeonHub.h"
#include "worlds/pictures/Noise.h"
#include "worlds/records/Seams.h"

namespace limen::worlds {

namespace {

using RockRing = std::vector<Vec3>;

constexpr double kLipRough = 0.2; ///< metres; the rough of the ring at the opening is less
constexpr double kHalfMouth = 1.5;

/// A point of a ring's lower half, lowered to `z` and moved out to its middle's width: rock that narrows downwards would show
/// its dark underside. The middle of the floor stays in the middle.
Vec3 underground(const Vec3& rock, double halfWidth, double z) {
    const double half = std::abs(rock.x);
    const double wide = half > 0.4 * halfWidth ? std::max(half, halfWidth + 0.3) : half;
    return {std::copysign(wide, rock.x), rock.y, std::min(rock.z, z)};
}

/// A ring of rock points around the mouth: its corners and the middles of its sides, moved outwards by `out`
/// metres, at depth `y`, with random offsets of up to `rough`.
RockRing rockRing(std::uint32_t number, double out, double y, double rough) {
    const Outline mouth = tunnelOutline(0.0, 0.0, 0.0);
    const Vec3 middle{0.0, 0.0, 1.2};
    RockRing ring;
    for (std::size_t i = 0; i < mouth.size(); ++i) {
        const Vec3& a = mouth[i];
        const Vec3& b = mouth[(i + 1) % mouth.size()];
        for (const Vec3& p : {a, 0.5 * (a + b)}) {
            const auto k = static_cast<std::uint32_t>(ring.size());
            const auto shake = [&](std::uint32_t axis) {
                return rough * (2.0 * random01(number, k, 6100 + axis) - 1.0);
            };
            const Vec3 away = glm::normalize(p - middle);
            Vec3 rock = p + away * (out + shake(0)) + Vec3(0.3 * shake(1), y + shake(2), 0.0);
            if (rough > kLipRough && p.z < 0.9)
                rock = underground(rock, kHalfMouth + out, p.z > 0.25 ? -0.5 : -1.8);
            ring.push_back(rock);
        }
    }
    return ring;
}

/// A triangle of rock. Its picture is projected along the axis that it faces most, so that it continues
/// across edges.
Face rockFace(const std::array<Vec3, 3>& points) {
    Face face = planarFace({points.begin(), points.end()}, Material::Rock);
    const Vec3 n = glm::abs(faceNormal(face));
    const double scale = 1.0 / metresPerTile(Material::Rock);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3& p = points[i];
        face.uvs[i] = scale * (n.z > n.x && n.z > n.y ? Vec2(p.x, -p.y)
                               : n.y > n.x            ? Vec2(p.x, -p.z)
                                                      : Vec2(p.y, -p.z));
    }
    return face;
}

/// The outcrop: from the opening to its front, over its back and down into the hill, where the mesh is open.
FaceMesh outcrop() {
    const Outline mouth = tunnelOutline(0.0, 0.0, 0.0);
    const std::vector<RockRing> rings{rockRing(1, 0.30, -1.3, 0.12), rockRing(2, 1.5, -1.1, 0.35),
                                      rockRing(3, 3.0, 0.6, 0.5),    rockRing(4, 4.2, 3.4, 0.6),
                                      rockRing(5, 4.4, 7.5, 0.6),    rockRing(6, 2.0, 13.0, 0.4)};
    std::vector<Face> faces;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        faces.push_back(rockFace({a, b, c}));
    };
    const RockRing& lip = rings.front();
    for (std::size_t i = 0; i < mouth.size(); ++i) {
        const Vec3& a = mouth[i];
        const Vec3& b = mouth[(i + 1) % mouth.size()];
        const Vec3& from = lip[2 * i];
        const Vec3& middle = lip[2 * i + 1];
        const Vec3& to = lip[(2 * i + 2) % lip.size()];
        add(from, middle, a);
        add(middle, b, a);
        add(middle, to, b);
    }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
        for (std::size_t i = 0; i < lip.size(); ++i) {
            const std::size_t j = (i + 1) % lip.size();
            add(rings[r + 1][i], rings[r + 1][j], rings[r][i]);
            add(rings[r + 1][j], rings[r][j], rings[r][i]);
        }
    }
    Face opening = portalFace(mouth);
    faces.push_back(faceNormal(opening).y > 0.0 ? flipped(std::move(opening)) : std::move(opening));
    closeSeams(faces);
    FaceMesh mesh;
    for (Face& face : faces)
        mesh.add(std::move(face));
    return mesh;
}

void furnishChamber(CellComplex& complex, const DungeonProps& props, std::size_t chamber) {
    const Vec3 middle{kChamberX, kChamberY, kChamberFloor};
    complex.furnish(chamber, {props.brazier, {middle + Vec3(3.6, 1.5, 0.0), 0.0}});
    complex.furnish(chamber, {props.house.crate, {middle + Vec3(-4.3, 2.0, 0.0), 20.0}});
    complex.furnish(chamber, {props.house.crate, {middle + Vec3(-4.4, 0.9, 0.0), -8.0}});
    complex.furnish(chamber, {props.house.barrel, {middle + Vec3(-3.5, 3.2, 0.0), 0.0}});
    complex.furnish(chamber, {props.house.sacks, {middle + Vec3(-4.3, -1.6, 0.0), 100.0}});
}

} // namespace

CavePlan planCave(ModelWriter& writer, const DungeonProps& props) {
    CavePlan plan;
    CellComplex complex;
    const Outline mouth = tunnelOutline(0.0, 0.0, 0.0);
    const Outline bend = tunnelOutline(0.5, 6.0, -1.0);
    const Outline in = tunnelOutline(kChamberX, kChamberY - 6.0, kChamberFloor);
    const Outline out = tunnelOutline(kChamberX, kChamberY + 6.0, kChamberFloor);
    const std::size_t first = complex.addSwept("cave.mouth", mouth, {0.5, 6.0, -1.0}, kBareRock);
    complex.open(first, mouth);
    const std::size_t second = complex.addSwept("cave.bend", bend, {-1.5, 8.0, -3.0}, kBareRock);
    complex.join(first, second, bend);
    Outline floor = levelOutline(octagon(6.0, 2.5), kChamberFloor);
    for (Vec3& p : floor)
        p += Vec3(kChamberX, kChamberY, 0.0);
    plan.chamber = complex.addSwept("cave.chamber", floor, {0.0, 0.0, 5.5}, kBareRock);
    complex.join(second, plan.chamber, in);
    const std::size_t tunnel = complex.addRun("cave.tunnel", out, {0.25, 6.5, -3.0}, 4, kBareRock);
    complex.join(plan.chamber, tunnel, out);
    furnishChamber(complex, props, plan.chamber);
    plan.parts = addDungeonCells(complex, writer, props, tunnel + 3);
    plan.building.name = "cave";
    plan.building.exterior = outcrop();
    plan.building.cells = complex.finish();
    return plan;
}

} // namespace limen::worlds
