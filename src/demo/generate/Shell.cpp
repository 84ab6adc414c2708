#include "demo/generate/Shell.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"

namespace limen::demo {

namespace {

bool liesIn(const Polygon& opening, const Polygon& wall) {
    const Plane plane = planeOf(wall);
    const auto inPlane = [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) < 1e-3; };
    return std::all_of(opening.begin(), opening.end(), inPlane) &&
           containsProjection(wall, plane.n, centroidOf(opening), 1e-6);
}

Face portalSeenFrom(Polygon opening, const Vec3& normal) {
    if (glm::dot(planeOf(opening).n, normal) < 0.0) {
        std::reverse(opening.begin(), opening.end());
    }
    return portalFace(std::move(opening));
}

} // namespace

Shell prismShell(std::span<const Vec3> footprint, double bottom, double top, Material walls) {
    Shell shell;
    Polygon floor, ceiling;
    for (std::size_t i = 0; i < footprint.size(); ++i) {
        const Vec3& a = footprint[i];
        const Vec3& b = footprint[(i + 1) % footprint.size()];
        floor.emplace_back(a.x, a.y, bottom);
        ceiling.emplace_back(a.x, a.y, top);
        shell.walls.push_back(
            {{{b.x, b.y, bottom}, {a.x, a.y, bottom}, {a.x, a.y, top}, {b.x, b.y, top}}, walls});
    }
    std::reverse(ceiling.begin(), ceiling.end());
    shell.walls.push_back({std::move(floor), Material::Flagstones});
    shell.walls.push_back({std::move(ceiling), Material::Beam});
    return shell;
}

Shell boxShell(const Vec3& min, const Vec3& max, Material walls) {
    const std::array<Vec3, 4> footprint{Vec3(min.x, min.y, 0), Vec3(max.x, min.y, 0), Vec3(max.x, max.y, 0),
                                        Vec3(min.x, max.y, 0)};
    return prismShell(footprint, min.z, max.z, walls);
}

Shell courtShell(const Vec3& min, const Vec3& max, const Rect& c, Material walls) {
    Shell shell;
    const auto add = [&](Side side, double at, const Rect& rect, Material material) {
        shell.walls.push_back({rectOnSide(side, at, rect), material});
    };
    add(Side::West, min.x, {min.y, min.z, max.y, max.z}, walls);
    add(Side::East, max.x, {min.y, min.z, max.y, max.z}, walls);
    add(Side::South, min.y, {min.x, min.z, max.x, max.z}, walls);
    add(Side::North, max.y, {min.x, min.z, c.u0, max.z}, walls);
    add(Side::North, max.y, {c.u1, min.z, max.x, max.z}, walls);
    add(Side::East, c.u0, {c.v0, min.z, max.y, max.z}, walls);
    add(Side::West, c.u1, {c.v0, min.z, max.y, max.z}, walls);
    add(Side::North, c.v0, {c.u0, min.z, c.u1, max.z}, walls);
    for (const Rect& rect : withoutHoles({min.x, min.y, max.x, max.y}, {c})) {
        add(Side::Floor, min.z, rect, Material::Flagstones);
        add(Side::Ceiling, max.z, rect, Material::Beam);
    }
    return shell;
}

std::vector<Face> facesOf(const Shell& shell, bool fromOutside) {
    std::vector<Face> faces;
    std::vector<Vec3> normals(shell.openings.size(), Vec3(0.0));
    for (const Shell::Wall& wall : shell.walls) {
        std::vector<Polygon> holes;
        for (std::size_t k = 0; k < shell.openings.size(); ++k) {
            if (liesIn(shell.openings[k], wall.points)) {
                holes.push_back(shell.openings[k]);
                normals[k] = planeOf(wall.points).n;
            }
        }
        for (Polygon& piece : withoutOpenings(wall.points, holes)) {
            Face face = planarFace(std::move(piece), wall.material);
            faces.push_back(fromOutside ? flipped(std::move(face)) : std::move(face));
        }
    }
    for (std::size_t k = 0; k < shell.openings.size(); ++k) {
        LIMEN_ASSERT(normals[k] != Vec3(0.0), "an opening lies in no wall");
        faces.push_back(portalSeenFrom(shell.openings[k], fromOutside ? -normals[k] : normals[k]));
    }
    return faces;
}

} // namespace limen::demo
