#include "worlds/builtin/buildings/HouseRoof.h"

namespace limen::worlds {

namespace {

constexpr double kOverhang = 0.55; ///< metres beyond the wall, horizontally
constexpr double kGableOverhang = 0.42;
constexpr double kRoofThick = 0.42;

/// One slope's outline from the eave to the ridge: points (y, z) with normals. The other slope is its mirror
/// image.
struct OutlinePoint {
    Vec2 point, normal;
};

std::vector<OutlinePoint> slopeOutline(const RoofSpec& r) {
    const double half = r.depth / 2.0;
    const double under = r.top - kOverhang * r.pitch; // underside at the eave
    const Vec2 up = glm::normalize(Vec2(-r.pitch, 1.0));
    const Vec2 ridge{half, r.top + half * r.pitch + kRoofThick * 1.15};
    const Vec2 lip{-kOverhang - 0.06, under + kRoofThick * 1.12};
    std::vector<OutlinePoint> out{{{-kOverhang, under}, glm::normalize(Vec2(-0.5, -1.0))},
                                  {{-kOverhang - 0.16, under + 0.17}, {-1.0, 0.0}},
                                  {lip, glm::normalize(Vec2(-0.8, 0.9))}};
    for (int k = 1; k <= 5; ++k) {
        const double t = k / 5.0;
        // The slope sags a little, as old thatch does.
        const Vec2 p = lip + (ridge - lip) * t - up * (0.10 * std::sin(t * 3.14159265));
        const Vec2 n = glm::normalize(up + glm::normalize(ridge - lip) * (0.05 * std::cos(t * 3.14159265)));
        out.push_back({p, n});
    }
    return out;
}

Face slopeStrip(const RoofSpec& r, const OutlinePoint& a, const OutlinePoint& b, double along, bool south) {
    const double x = r.halfWidth + kGableOverhang;
    const auto at = [&](double px, const OutlinePoint& o) {
        return Vec3(px, south ? o.point.x : r.depth - o.point.x, o.point.y);
    };
    const auto normal = [&](const OutlinePoint& o) {
        return Vec3(0.0, south ? o.normal.x : -o.normal.x, o.normal.y);
    };
    const double tile = metresPerTile(Material::Thatch);
    const double next = along + glm::length(b.point - a.point);
    Face face;
    face.material = Material::Thatch;
    face.points = {at(-x, a), at(x, a), at(x, b), at(-x, b)};
    face.normals = {normal(a), normal(a), normal(b), normal(b)};
    face.uvs = {{-x / tile, -along / tile},
                {x / tile, -along / tile},
                {x / tile, -next / tile},
                {-x / tile, -next / tile}};
    return south ? face : flipped(face);
}

void addSlope(FaceMesh& mesh, const RoofSpec& r, bool south) {
    const std::vector<OutlinePoint> outline = slopeOutline(r);
    double along = 0.0;
    for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        Face strip = slopeStrip(r, outline[i], outline[i + 1], along, south);
        if (!south)
            for (Vec3& n : strip.normals)
                n = -n; // they were mirrored already, so flipped() turned them inwards
        mesh.add(std::move(strip));
        along += glm::length(outline[i + 1].point - outline[i].point);
    }
    const double x = r.halfWidth + kGableOverhang;
    const auto y = [&](double v) { return south ? v : r.depth - v; };
    const double half = r.depth / 2.0;
    const Vec2 eave = outline.front().point;
    Face under = planarFace({{-x, y(half), r.top + half * r.pitch},
                             {x, y(half), r.top + half * r.pitch},
                             {x, y(eave.x), eave.y},
                             {-x, y(eave.x), eave.y}},
                            Material::OldPlanks);
    mesh.add(south ? std::move(under) : flipped(std::move(under)));
    // The thickness at the gable ends, in pieces from the underside up to the outline.
    for (const double side : {-1.0, 1.0}) {
        for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
            const auto below = [&](const OutlinePoint& o) {
                const double v = std::max(o.point.x, eave.x);
                return Vec3(side * x, y(v), r.top + v * r.pitch);
            };
            const auto onTop = [&](const OutlinePoint& o) { return Vec3(side * x, y(o.point.x), o.point.y); };
            std::vector<Vec3> piece{below(outline[i]), below(outline[i + 1]), onTop(outline[i + 1]),
                                    onTop(outline[i])};
            if (glm::length(piece[0] - piece[1]) < 1e-6)
                piece.erase(piece.begin());
            if ((side > 0.0) != south)
                std::reverse(piece.begin(), piece.end());
            mesh.polygon(std::move(piece), Material::Thatch);
        }
    }
}

/// Adds rolls of straw along the ridge, one below the other.
void addRidge(FaceMesh& mesh, const RoofSpec& r) {
    const double x = r.halfWidth + kGableOverhang + 0.03;
    const double half = r.depth / 2.0;
    const double ridge = r.top + half * r.pitch + kRoofThick * 1.15;
    const Vec2 down = glm::normalize(Vec2(1.0, -r.pitch));
    const Vec2 up{-down.y, down.x};
    for (const double side : {-1.0, 1.0}) {
        const auto at = [&](double px, const Vec2& p) { return Vec3(px, half + side * p.x, ridge + p.y); };
        const Vec2 crest{0.0, 0.16};
        const Vec2 edge = down * 0.95 + up * 0.07;
        const Vec2 foot = down * 0.97 - up * 0.08;
        const auto quad = [&](const Vec2& a, const Vec2& b) {
            Face face = planarFace({at(-x, b), at(x, b), at(x, a), at(-x, a)}, Material::Thatch);
            mesh.add(side < 0.0 ? std::move(face) : flipped(std::move(face)));
        };
        quad(crest, edge);
        quad(edge, foot);
        for (const double end : {-1.0, 1.0}) {
            std::vector<Vec3> piece{at(end * x, {0.0, -0.1}), at(end * x, foot), at(end * x, edge),
                                    at(end * x, crest)};
            if (end * side < 0.0)
                std::reverse(piece.begin(), piece.end());
            mesh.polygon(std::move(piece), Material::Thatch);
        }
    }
}

} // namespace

void addThatchedRoof(FaceMesh& mesh, const RoofSpec& roof) {
    addSlope(mesh, roof, true);
    addSlope(mesh, roof, false);
    addRidge(mesh, roof);
}

void addChimney(FaceMesh& mesh, const Vec3& foot, double top) {
    const Vec3 wide(0.52, 0.45, 0.0);
    mesh.box(foot - wide, Vec3(foot.x, foot.y, top - 0.25) + wide, Material::StoneWall);
    mesh.box(Vec3(foot.x, foot.y, top - 0.25) - wide * 1.17, Vec3(foot.x, foot.y, top - 0.1) + wide * 1.17,
             Material::StoneWall);
    mesh.box(Vec3(foot.x, foot.y, top - 0.1) - wide * 1.04, Vec3(foot.x, foot.y, top) + wide * 1.04,
             Material::StoneWall);
    mesh.cylinder({.base = {foot.x, foot.y, top},
                   .lower = 0.19,
                   .upper = 0.15,
                   .height = 0.4,
                   .sides = 10,
                   .side = Material::Brick,
                   .cap = Material::Rock});
}

} // namespace limen::worlds
