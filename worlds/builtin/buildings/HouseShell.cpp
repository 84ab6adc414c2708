#include "worlds/builtin/buildings/HouseShell.h"

#include "worlds/builtin/buildings/HouseRoof.h"
#include "worlds/records/Seams.h"

namespace limen::worlds {

namespace {

constexpr double kPost = 0.17;   ///< width of a timber
constexpr double kProud = 0.045; ///< metres that timbers stand out from the plaster
constexpr double kBedded = 0.03; ///< metres that they extend into it
constexpr double kCornerPost = 0.2;
constexpr double kPlinthTop = 0.38;

constexpr std::array kWalls{Side::West, Side::East, Side::South, Side::North};

double outerPlane(const HouseShell& h, Side side) {
    switch (side) {
    case Side::West:
        return -h.halfWidth;
    case Side::East:
        return h.halfWidth;
    case Side::South:
        return 0.0;
    default:
        return h.depth;
    }
}
/// +1 if outside is towards larger coordinates.
double outward(Side side) {
    return side == Side::East || side == Side::North || side == Side::Ceiling ? 1.0 : -1.0;
}

/// The outward normal of a wall.
Vec3 outwardNormal(Side side) {
    return side == Side::West || side == Side::East ? Vec3(outward(side), 0.0, 0.0)
                                                    : Vec3(0.0, outward(side), 0.0);
}

std::pair<double, double> wallSpan(const HouseShell& h, Side side) {
    return side == Side::West || side == Side::East ? std::pair{0.0, h.depth}
                                                    : std::pair{-h.halfWidth, h.halfWidth};
}

/// The corners of a box on a wall: `r` on the wall, `from` to `to` metres outwards from the plane `at`.
std::pair<Vec3, Vec3> boxOnWall(Side side, double at, const Rect& r, double from, double to) {
    const double a = at + outward(side) * from;
    const double b = at + outward(side) * to;
    const double low = std::min(a, b);
    const double high = std::max(a, b);
    if (side == Side::West || side == Side::East)
        return {{low, r.u0, r.v0}, {high, r.u1, r.v1}};
    if (side == Side::South || side == Side::North)
        return {{r.u0, low, r.v0}, {r.u1, high, r.v1}};
    return {{r.u0, r.v0, low}, {r.u1, r.v1, high}};
}

/// `extra`: metres by which it is thicker at both faces. Timbers that cross differ in it, so that no two of
/// their faces are in one plane.
void addTimber(FaceMesh& mesh, const HouseShell& h, Side side, const Rect& r, double extra = 0.0) {
    const auto [min, max] = boxOnWall(side, outerPlane(h, side), r, -kBedded - extra, kProud + extra);
    mesh.beam(min, max, Material::Beam);
}

std::vector<Rect> holesOf(const HouseShell& h, Side side, double margin) {
    std::vector<Rect> out;
    for (const HouseShell::Hole& hole : h.holes) {
        if (hole.side == side) {
            out.push_back(
                {hole.rect.u0 - margin, hole.rect.v0 - margin, hole.rect.u1 + margin, hole.rect.v1 + margin});
        }
    }
    return out;
}

void addReveals(std::vector<Face>& faces, const HouseShell& h, const HouseShell::Hole& hole) {
    const std::vector<Vec3> inner = rectOnSide(hole.side, innerPlane(h, hole.side), hole.rect);
    const std::vector<Vec3> outer = rectOnSide(hole.side, outerPlane(h, hole.side), hole.rect);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        const Material material =
            i == 0 ? (hole.door && hole.rect.v0 == 0.0 ? Material::Flagstones : Material::Beam) : h.walls;
        faces.push_back(planarFace({inner[i], inner[j], outer[j], outer[i]}, material));
    }
    faces.push_back(flipped(portalFace(inner)));
}

/// The walls with their holes; watertight along wall, reveal and portal.
std::vector<Face> wallFaces(const HouseShell& h) {
    std::vector<Face> faces;
    for (const Side side : kWalls) {
        const auto [u0, u1] = wallSpan(h, side);
        for (const Rect& r : withoutHoles({u0, h.base, u1, h.top}, holesOf(h, side, 0.0)))
            faces.push_back(flipped(planarFace(rectOnSide(side, outerPlane(h, side), r), h.walls)));
    }
    const double ridge = h.top + h.pitch * h.depth / 2.0;
    for (const double x : {-h.halfWidth, h.halfWidth}) {
        std::vector<Vec3> gable{{x, 0.0, h.top}, {x, h.depth, h.top}, {x, h.depth / 2.0, ridge}};
        if (x < 0.0)
            std::swap(gable[0], gable[1]);
        faces.push_back(planarFace(std::move(gable), h.walls));
    }
    for (const HouseShell::Hole& hole : h.holes)
        addReveals(faces, h, hole);
    closeSeams(faces);
    return faces;
}

constexpr double kPlinthOut = 0.08; ///< metres that the plinth stands out from the wall

/// A point in front of a wall: `u` along it, `out` metres outwards from its outer plane, at height `z`.
Vec3 onWall(const HouseShell& h, Side side, double u, double out, double z) {
    const double at = outerPlane(h, side) + outward(side) * out;
    return side == Side::West || side == Side::East ? Vec3(at, u, z) : Vec3(u, at, z);
}

/// Adds a piece of the plinth, r.v0 to r.v1. Its top is a weathering, a slope of 45 degrees: a level ledge is thinner than a
/// pixel from afar and shows as a dashed line. `west`, `east`: that end is a corner of the house, mitred with the next wall.
void addPlinthPiece(FaceMesh& mesh, const HouseShell& h, Side side, const Rect& r, bool west, bool east) {
    constexpr double kEdge = 0.04; // metres: the front's upper edge is this much lower than r.v1
    const double rise = kPlinthOut + kBedded;
    struct Corner {
        double out, z;
    };
    const std::array<Corner, 4> profile{Corner{-kBedded, r.v0}, Corner{kPlinthOut, r.v0},
                                        Corner{kPlinthOut, r.v1 - kEdge},
                                        Corner{-kBedded, r.v1 - kEdge + rise}};
    std::vector<Vec3> from, to;
    for (const Corner& c : profile) {
        from.push_back(onWall(h, side, r.u0 - (west ? c.out : 0.0), c.out, c.z));
        to.push_back(onWall(h, side, r.u1 + (east ? c.out : 0.0), c.out, c.z));
    }
    const Vec3 inside = onWall(h, side, 0.5 * (r.u0 + r.u1), -1.0, r.v0);
    const auto add = [&](std::vector<Vec3> points) {
        Face face = planarFace(points, Material::StoneWall);
        const bool outwards = glm::dot(faceNormal(face), points[0] - inside) > 0.0;
        if (!outwards)
            std::reverse(points.begin(), points.end());
        mesh.add(outwards ? std::move(face) : planarFace(std::move(points), Material::StoneWall));
    };
    add({from[1], to[1], to[2], from[2]});
    add({from[2], to[2], to[3], from[3]});
    if (!west)
        add(from);
    if (!east)
        add(to);
}

/// Adds protruding stones at the foot of the walls, with gaps at doors.
void addPlinth(FaceMesh& mesh, const HouseShell& h) {
    for (const Side side : kWalls) {
        const auto [u0, u1] = wallSpan(h, side);
        for (const Rect& r : withoutHoles({u0, h.base, u1, kPlinthTop}, holesOf(h, side, 0.015))) {
            // Below a door's sill the stones support the steps. They end below the floor.
            const double top = r.v1 < kPlinthTop ? r.v1 - 0.09 : r.v1;
            addPlinthPiece(mesh, h, side, {r.u0, r.v0, r.u1, top}, r.u0 == u0, r.u1 == u1);
        }
    }
}

/// One storey of a wall's timbers.
struct Band {
    double from = 0.0, to = 0.0;
    bool sill = false; ///< begins with its own sill beam
};

std::vector<Band> bandsOf(const HouseShell& h) {
    if (h.upperFloor <= 0.0)
        return {{kPlinthTop, h.top, true}};
    return {{kPlinthTop, h.upperFloor, true}, {h.upperFloor, h.top, false}};
}

/// True if no opening of the band, widened by `margin`, overlaps u0..u1.
bool clearOf(const HouseShell& h, Side side, const Band& band, double margin, double u0, double u1) {
    const std::vector<Rect> holes = holesOf(h, side, margin);
    return std::none_of(holes.begin(), holes.end(), [&](const Rect& r) {
        return r.u0 < u1 && r.u1 > u0 && r.v0 < band.to && r.v1 > band.from;
    });
}

/// Adds a post at each corner of the house, visible from both sides. Sill beams and head plates end inside
/// it.
void addCornerPosts(FaceMesh& mesh, const HouseShell& h) {
    const double proud = kProud + 0.02;
    for (const double x : {-h.halfWidth - proud, h.halfWidth - kCornerPost}) {
        for (const double y : {-proud, h.depth - kCornerPost}) {
            mesh.beam({x, y, kPlinthTop - 0.01},
                      {x + kCornerPost + proud, y + kCornerPost + proud, h.top - 0.01}, Material::Beam);
        }
    }
}

/// Adds braces in the corner bays of a storey.
void addBraces(FaceMesh& mesh, const HouseShell& h, Side side, const Band& band, double bay) {
    const auto [u0, u1] = wallSpan(h, side);
    const double at = outerPlane(h, side) + outward(side) * 0.5 * (kProud - kBedded - 0.01);
    const double low = band.sill ? band.from + kPost : band.from;
    for (const bool left : {true, false}) {
        const double foot = left ? u0 + bay : u1 - bay;
        const double head = left ? u0 + 0.2 : u1 - 0.2;
        if (!clearOf(h, side, band, 0.1, std::min(foot, head), std::max(foot, head)))
            continue;
        const bool alongY = side == Side::West || side == Side::East;
        const Vec3 a = alongY ? Vec3(at, foot, low) : Vec3(foot, at, low);
        const Vec3 b = alongY ? Vec3(at, head, band.to - 0.4) : Vec3(head, at, band.to - 0.4);
        mesh.strut(a, b, alongY ? Vec3(1, 0, 0) : Vec3(0, 1, 0), kProud + kBedded - 0.02, 0.14,
                   Material::Beam);
    }
}

/// Adds sill beam, head plate, posts and braces of a storey, except across openings.
void addFraming(FaceMesh& mesh, const HouseShell& h, Side side, const Band& band) {
    const auto [u0, u1] = wallSpan(h, side);
    const double end = 0.5 * kCornerPost;
    const double low = band.sill ? band.from + kPost : band.from;
    if (band.sill) {
        for (const Rect& r : withoutHoles({u0 + end, band.from, u1 - end, low}, holesOf(h, side, 0.02)))
            if (r.v1 > band.from + 0.9 * kPost)
                addTimber(mesh, h, side, r);
    }
    addTimber(mesh, h, side, {u0 + end, band.to - 0.22, u1 - end, band.to}, 0.01);
    const int bays = static_cast<int>(std::lround((u1 - u0) / 1.35));
    for (int k = 1; k < bays; ++k) {
        const double u = u0 + (u1 - u0) * k / bays;
        if (clearOf(h, side, band, 0.16, u - kPost / 2, u + kPost / 2))
            addTimber(mesh, h, side, {u - kPost / 2, low, u + kPost / 2, band.to - 0.22}, -0.01);
    }
    addBraces(mesh, h, side, band, (u1 - u0) / bays);
}

void addGableFraming(FaceMesh& mesh, const HouseShell& h) {
    const double half = h.depth / 2.0;
    for (const double side : {-1.0, 1.0}) {
        const double x = side * (h.halfWidth + 0.5 * (kProud - kBedded));
        const Vec3 out{side, 0.0, 0.0};
        const auto strut = [&](const Vec2& a, const Vec2& b, double wide, double extra) {
            mesh.strut({x, a.x, a.y}, {x, b.x, b.y}, out, kProud + kBedded + 2.0 * extra, wide,
                       Material::Beam);
        };
        const double collar = h.top + h.pitch * half * 0.52;
        strut({half, h.top}, {half, h.top + h.pitch * half - 0.2}, 0.18, 0.0);
        strut({half * 0.52 + 0.05, collar}, {2.0 * half - half * 0.52 - 0.05, collar}, 0.18, 0.01);
        strut({half - 1.5, h.top}, {half - 1.5, collar}, 0.15, -0.01);
        strut({half + 1.5, h.top}, {half + 1.5, collar}, 0.15, -0.01);
        strut({half - 1.5, h.top + 0.1}, {half - 2.6, h.top + h.pitch * (half - 2.6) - 0.1}, 0.14, -0.02);
        strut({half + 1.5, h.top + 0.1}, {half + 2.6, h.top + h.pitch * (half - 2.6) - 0.1}, 0.14, -0.02);
    }
}

void addTimbers(FaceMesh& mesh, const HouseShell& h) {
    addCornerPosts(mesh, h);
    for (const Side side : kWalls)
        for (const Band& band : bandsOf(h))
            addFraming(mesh, h, side, band);
    addGableFraming(mesh, h);
}

/// Adds a cross of bars half way into a window's reveal.
void addWindowBars(FaceMesh& mesh, const HouseShell& h, const HouseShell::Hole& hole) {
    const Rect& r = hole.rect;
    const double middle = 0.5 * (r.u0 + r.u1);
    const double at = outerPlane(h, hole.side);
    const auto bar = [&](const Rect& rect, double from, double to) {
        const auto [min, max] = boxOnWall(hole.side, at, rect, from, to);
        mesh.beam(min, max, Material::Beam);
    };
    const double joint = 0.02; // the cross ends inside the frame
    bar({middle - 0.03, r.v0 + joint, middle + 0.03, r.v1 - joint}, -0.17, -0.11);
    const double rail = r.v0 + 0.58 * (r.v1 - r.v0);
    bar({r.u0 + joint, rail - 0.025, r.u1 - joint, rail + 0.025}, -0.165, -0.115);
    for (const double u : {r.u0, r.u1 - 0.05})
        bar({u, r.v0, u + 0.05, r.v1}, -0.18, -0.10);
    for (const double v : {r.v0, r.v1 - 0.05})
        bar({r.u0 + 0.05, v, r.u1 - 0.05, v + 0.05}, -0.18, -0.10);
}

void addDoorSteps(FaceMesh& mesh, const HouseShell& h, const HouseShell::Hole& hole) {
    const double middle = 0.5 * (hole.rect.u0 + hole.rect.u1);
    const double half = 0.5 * (hole.rect.u1 - hole.rect.u0);
    const double at = outerPlane(h, hole.side);
    const double foot = h.ground - 0.5;
    const double rise = -h.ground;
    const auto slab = [&](double wide, double from, double to, double top) {
        const auto [min, max] =
            boxOnWall(hole.side, at, {middle - half - wide, foot, middle + half + wide, top}, from, to);
        mesh.box(min, max, Material::Flagstones);
    };
    slab(0.22, -0.02, 0.55, -rise / 3.0);
    slab(0.38, 0.55, 0.95, -2.0 * rise / 3.0);
}

} // namespace

double innerPlane(const HouseShell& h, Side side) {
    return outerPlane(h, side) - outward(side) * h.wall;
}

double chimneyTop(const HouseShell& h) {
    return h.top + h.pitch * h.depth / 2.0 + 1.1;
}

void addFrame(FaceMesh& mesh, Side side, double at, const Rect& r, double width, double out, bool sill) {
    // The timber extends over the opening's border. If it were flush with the reveals, their faces would
    // fight for depth; a strip of bare wall between them would show as a bright line.
    const double gap = -0.003;
    const auto bar = [&](const Rect& rect, double depth) {
        const auto [min, max] = boxOnWall(side, at, rect, std::min(0.0, -depth), std::max(0.0, -depth));
        FaceMesh whole;
        whole.beam(min, max, Material::Beam);
        const Vec3 back = outwardNormal(side) * (depth > 0.0 ? 1.0 : -1.0);
        for (Face& face : whole.faces()) {
            // No face at the back: it would be in the plane of the wall and of the portal beside it.
            if (glm::dot(faceNormal(face), back) < 0.5)
                mesh.add(std::move(face));
        }
    };
    bar({r.u0 - width, r.v0, r.u0 - gap, r.v1 + gap}, out);
    bar({r.u1 + gap, r.v0, r.u1 + width, r.v1 + gap}, out);
    bar({r.u0 - width - 0.05, r.v1 + gap, r.u1 + width + 0.05, r.v1 + width + 0.03}, out * 1.25);
    if (sill)
        bar({r.u0 - width - 0.04, r.v0 - 0.09, r.u1 + width + 0.04, r.v0 - gap}, out * 2.0);
}

FaceMesh buildHouseShell(const HouseShell& h) {
    FaceMesh mesh;
    for (Face& face : wallFaces(h))
        mesh.add(std::move(face));
    addPlinth(mesh, h);
    if (h.timbered)
        addTimbers(mesh, h);
    for (const HouseShell::Hole& hole : h.holes) {
        addFrame(mesh, hole.side, outerPlane(h, hole.side), hole.rect, 0.15, -0.06, !hole.door);
        if (!hole.door)
            addWindowBars(mesh, h, hole);
        else if (hole.rect.v0 == 0.0)
            addDoorSteps(mesh, h, hole);
    }
    addThatchedRoof(mesh, {h.halfWidth, h.depth, h.top, h.pitch});
    if (h.chimney)
        addChimney(mesh, {h.chimneyX, h.chimneyY, h.top}, chimneyTop(h));
    return mesh;
}

} // namespace limen::worlds
