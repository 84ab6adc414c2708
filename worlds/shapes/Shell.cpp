#include "worlds/shapes/Shell.h"

#include "core/Assert.h"
#include "geometry/ConvexPolygon.h"
#include "geometry/Segment.h"

namespace limen::worlds {

namespace {

bool liesIn(const Polygon& opening, const Polygon& wall) {
    const Plane plane = planeOf(wall);
    const auto inPlane = [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) < 1e-3; };
    return std::all_of(opening.begin(), opening.end(), inPlane) &&
           containsProjection(wall, plane.n, centroidOf(opening), 1e-6);
}

Face portalSeenFrom(Polygon opening, const Vec3& normal) {
    if (glm::dot(planeOf(opening).n, normal) < 0.0)
        std::reverse(opening.begin(), opening.end());
    return portalFace(std::move(opening));
}

/// The openings of each wall. Also yields the wall's normal for each opening; zero if it is in no wall.
std::vector<std::vector<std::size_t>> openingsByWall(const Shell& shell, std::vector<Vec3>& normals) {
    normals.assign(shell.openings.size(), Vec3(0.0));
    std::vector<std::vector<std::size_t>> out;
    for (const Shell::Wall& wall : shell.walls) {
        std::vector<std::size_t> own;
        for (std::size_t k = 0; k < shell.openings.size(); ++k) {
            if (liesIn(shell.openings[k], wall.points)) {
                own.push_back(k);
                normals[k] = planeOf(wall.points).n;
            }
        }
        out.push_back(std::move(own));
    }
    return out;
}

/// The walls cut along the edges of their openings; `start` is the index of the first edge.
std::vector<Shell::Wall> piecesOf(const Shell& shell, const std::vector<std::vector<std::size_t>>& byWall,
                                  std::size_t start) {
    std::vector<Shell::Wall> pieces;
    for (std::size_t w = 0; w < shell.walls.size(); ++w) {
        std::vector<Polygon> holes;
        for (const std::size_t k : byWall[w]) {
            Polygon hole = shell.openings[k];
            std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(start % hole.size()),
                        hole.end());
            holes.push_back(std::move(hole));
        }
        for (Polygon& piece : withoutOpenings(shell.walls[w].points, holes))
            pieces.push_back({std::move(piece), shell.walls[w].material});
    }
    return pieces;
}

/// Metres. Corners nearer than kSame are the same corner, or are on the edge. Corners nearer than kClear may
/// be merged by rounding and welding.
constexpr double kSame = 1e-5, kClear = 0.001;
constexpr std::size_t kWaysToCut = 12;

/// The smallest distance of a corner from another corner or edge that it is not on.
double clearanceOf(const std::vector<Shell::Wall>& pieces) {
    std::vector<Vec3> corners;
    for (const Shell::Wall& piece : pieces) {
        for (const Vec3& p : piece.points)
            if (std::none_of(corners.begin(), corners.end(),
                             [&](const Vec3& q) { return glm::length(p - q) < 1e-9; }))
                corners.push_back(p);
    }
    double least = 1e300;
    const auto consider = [&](double distance) {
        if (distance > kSame)
            least = std::min(least, distance);
    };
    for (const Vec3& p : corners) {
        for (const Shell::Wall& piece : pieces) {
            for (std::size_t i = 0; i < piece.points.size(); ++i) {
                const Vec3& a = piece.points[i];
                const Vec3& b = piece.points[(i + 1) % piece.points.size()];
                consider(glm::length(p - a));
                consider(distanceToSegment(p, a, b).distance);
            }
        }
    }
    return least;
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
    std::vector<Vec3> normals;
    const std::vector<std::vector<std::size_t>> byWall = openingsByWall(shell, normals);
    std::vector<Shell::Wall> best;
    double widest = -1.0;
    for (std::size_t start = 0; start < kWaysToCut && widest < kClear; ++start) {
        std::vector<Shell::Wall> pieces = piecesOf(shell, byWall, start);
        const double clear = clearanceOf(pieces);
        if (clear > widest) {
            widest = clear;
            best = std::move(pieces);
        }
    }
    std::vector<Face> faces;
    for (Shell::Wall& piece : best) {
        Face face = planarFace(std::move(piece.points), piece.material);
        faces.push_back(fromOutside ? flipped(std::move(face)) : std::move(face));
    }
    for (std::size_t k = 0; k < shell.openings.size(); ++k) {
        LIMEN_ASSERT(normals[k] != Vec3(0.0), "an opening is in no wall");
        faces.push_back(portalSeenFrom(shell.openings[k], fromOutside ? -normals[k] : normals[k]));
    }
    return faces;
}

} // namespace limen::worlds
