#include "worlds/generate/Sites.h"

#include "worlds/generate/ComplexOpenings.h"
#include "worlds/shapes/Shell.h"

namespace limen::worlds {

namespace {

/// Plans cells as shells that are joined by openings.
class SitePlanner {
public:
    std::uint32_t addCell(Shell shell, const Vec3& eye) {
        shells_.push_back(std::move(shell));
        CellPlan cell;
        cell.eye = eye;
        plan_.cells.push_back(std::move(cell));
        return static_cast<std::uint32_t>(shells_.size() - 1);
    }

    void join(std::uint32_t a, std::uint32_t b, const Polygon& opening) {
        const auto portalA = static_cast<std::uint16_t>(plan_.cells[a].links.size());
        const auto portalB = static_cast<std::uint16_t>(plan_.cells[b].links.size());
        cut(a, opening, {b, portalB});
        cut(b, opening, {a, portalA});
    }

    /// Opens a cell to the outside, through the exterior shell with a wall at that place.
    void openOutside(std::uint32_t cell, const Polygon& opening, Shell& exterior) {
        plan_.exits.push_back({cell, static_cast<std::uint16_t>(plan_.cells[cell].links.size())});
        cut(cell, opening, {});
        exterior.openings.push_back(opening);
    }

    /// Requires: exteriors are added in the order in which their cells were opened.
    void addExterior(const Shell& shell) {
        for (Face& face : facesOf(shell, true))
            (face.portal ? exits_ : walls_).push_back(std::move(face));
    }
    void addOutside(Face face) { walls_.push_back(std::move(face)); }

    void addStatic(std::uint32_t cell, dat::RecordId model, const Placement& at) {
        plan_.cells[cell].statics.push_back({model, at});
    }

    BuildingPlan finish() {
        for (std::size_t c = 0; c < shells_.size(); ++c)
            plan_.cells[c].faces = facesOf(shells_[c]);
        for (std::vector<Face>* faces : {&walls_, &exits_})
            for (Face& face : *faces)
                plan_.exterior.add(std::move(face));
        return std::move(plan_);
    }

private:
    void cut(std::uint32_t cell, const Polygon& opening, CellLink portal) {
        shells_[cell].openings.push_back(opening);
        plan_.cells[cell].links.push_back(portal);
    }

    BuildingPlan plan_;
    std::vector<Shell> shells_;
    std::vector<Face> walls_, exits_;
};

/// The parts of a shell that are visible from outside.
Shell withoutFloor(Shell shell) {
    std::erase_if(shell.walls, [](const Shell::Wall& wall) { return wall.material == Material::Flagstones; });
    return shell;
}

Polygon rectangle(Side side, double at, const Rect& rect) {
    return rectOnSide(side, at, rect);
}

constexpr double kFoot = -1.5; ///< lower end of walls, below the ground

} // namespace

BuildingPlan planVault(const Props& props, Random& random) {
    SitePlanner site;
    constexpr double kHallTop = -2.5, kHallFloor = -5.5;
    const std::uint32_t hall = site.addCell(
        boxShell({-22, -2.5, kHallFloor}, {22, 5.5, kHallTop}, Material::Rock), {0.5, 1.0, kHallFloor + 1.6});
    for (const Vec2& middle : {Vec2(-19, 0), Vec2(19, 3)}) {
        const Vec3 low(middle.x - 2.5, middle.y - 2.25, 0.0), high(middle.x + 2.5, middle.y + 2.25, 2.75);
        const std::uint32_t hut =
            site.addCell(boxShell(low, high, Material::InnerPlaster), {middle.x, middle.y - 1.25, 1.6});
        const Rect hatch{middle.x - 0.75, middle.y - 0.5, middle.x + 0.75, middle.y + 1.0};
        const std::uint32_t shaft =
            site.addCell(boxShell({hatch.u0, hatch.v0, kHallTop}, {hatch.u1, hatch.v1, 0.0}, Material::Brick),
                         {middle.x, middle.y + 0.25, -1.0});
        site.join(hut, shaft, rectangle(Side::Floor, 0.0, hatch));
        site.join(shaft, hall, rectangle(Side::Floor, kHallTop, hatch));
        Shell exterior =
            withoutFloor(boxShell({low.x, low.y, kFoot}, {high.x, high.y, 2.75}, Material::OldPlanks));
        const double x = middle.x + random.between(-0.5, 0.5);
        site.openOutside(hut, rectangle(Side::South, low.y, {x - 0.625, 0.0, x + 0.625, 2.125}), exterior);
        if (random.chance(0.7))
            site.openOutside(hut, rectangle(Side::North, high.y, {x - 0.5, 0.875, x + 0.5, 1.875}), exterior);
        site.addExterior(exterior);
    }
    site.addStatic(hall, props.lamp, {{4.0, 2.0, kHallFloor}, 0.0});
    site.addStatic(hall, props.pillar, {{-6.0, 1.0, kHallFloor}, 0.0});
    // The pole is higher than the hall: its upper end is in the shaft to the hut.
    site.addStatic(hall, props.pole, {{-19.0, 0.25, kHallTop}, 0.0});
    return site.finish();
}

BuildingPlan planTunnel(const Props& props, Random& random) {
    SitePlanner site;
    constexpr double kMouth = 27.0, kRoom = 9.0, kHalf = 1.5, kTop = 3.0;
    const std::uint32_t room =
        site.addCell(boxShell({-kRoom, -4, 0}, {kRoom, 4, 4.5}, Material::StoneWall), {-1.0, -2.5, 1.6});
    for (const double end : {-1.0, 1.0}) {
        const double inner = end * kRoom, outer = end * kMouth, back = end * 19.0;
        const Side outward = end < 0 ? Side::West : Side::East;
        const Rect opening{-kHalf, 0.0, kHalf, kTop};
        const std::uint32_t arm =
            site.addCell(boxShell({std::min(inner, outer), -kHalf, 0}, {std::max(inner, outer), kHalf, kTop},
                                  Material::Rock),
                         {0.5 * (inner + outer), 0.25, 1.6});
        site.join(room, arm, rectangle(outward, inner, opening));
        Shell facade = boxShell({std::min(back, outer), -2.75, kFoot}, {std::max(back, outer), 2.75, 4.0},
                                Material::StoneWall);
        site.openOutside(arm, rectangle(outward, outer, opening), facade);
        site.addExterior(facade);
    }
    site.addStatic(room, props.lamp, {{random.between(-5, 5), 3.0, 0.0}, 0.0});
    site.addStatic(room, props.screen, {{3.0, -1.0, 0.0}, random.between(0, 90)});
    site.addStatic(room, props.pane, {{8.5, 0.0, 1.5}, 90.0});
    return site.finish();
}

BuildingPlan planTower(const Props& props, Random& random) {
    SitePlanner site;
    constexpr int kSides = 8, kStoreys = 5, kBelow = 2;
    constexpr double kRadius = 3.5, kTowerStorey = 3.0;
    const auto ring = [](double radius, double z) {
        Polygon out;
        for (int k = 0; k < kSides; ++k) {
            const double a = 3.14159265358979323846 * (2 * k + 1) / kSides;
            out.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
        }
        return out;
    };
    const Polygon footprint = ring(kRadius, 0.0);
    const double foot = -kBelow * kTowerStorey, top = (kStoreys - kBelow) * kTowerStorey;
    const bool openTop = random.chance(0.5);
    Shell exterior = withoutFloor(prismShell(footprint, foot - 0.5, top, Material::StoneWall));
    for (int s = 0; s < kStoreys; ++s) {
        const double floor = foot + s * kTowerStorey;
        const Shell shell =
            prismShell(footprint, floor, floor + kTowerStorey, s < kBelow ? Material::Rock : Material::Brick);
        const auto cell = site.addCell(shell, {2.0, 0.5, floor + 1.6});
        if (s > 0) {
            const bool whole = random.chance(0.2);
            site.join(static_cast<std::uint32_t>(s - 1), cell, ring(whole ? kRadius : 1.25, floor));
            site.addStatic(cell, props.pole, {{1.25, 0.0, floor}, 0.0});
        }
        for (std::size_t k = 0; k < kSides && s >= kBelow; ++k) {
            const Polygon& wall = shell.walls[k].points;
            if (s == kBelow && k == 0) {
                const Vec3 a = wall[1], b = wall[0], up(0, 0, 2.125);
                const Vec3 left = glm::mix(a, b, 0.25), right = glm::mix(a, b, 0.75);
                site.openOutside(cell, {left, right, right + up, left + up}, exterior);
            } else if (random.chance(0.3)) {
                site.openOutside(cell, roundOpening(wall, random), exterior);
            }
        }
        if (s == kStoreys - 1 && openTop)
            site.openOutside(cell, ring(kRadius, top), exterior);
        if (random.chance(0.4))
            site.addStatic(cell, props.lamp, {{-2.0, -0.5, floor}, 0.0});
    }
    site.addExterior(exterior);
    for (int k = 0; k < kSides && !openTop; ++k) {
        const Polygon eaves = ring(kRadius, top);
        site.addOutside(planarFace(facing({eaves[static_cast<std::size_t>(k)],
                                           eaves[static_cast<std::size_t>((k + 1) % kSides)],
                                           {0, 0, top + 4.0}},
                                          {0, 0, top + 40.0}),
                                   Material::Thatch));
    }
    return site.finish();
}

BuildingPlan planCourt(const Props& props, Random& random) {
    SitePlanner site;
    const Vec3 low(-8, -6, 0), high(8, 6, 3);
    const Rect court{-3, -1, 3, 6};
    Shell exterior = withoutFloor(courtShell({low.x, low.y, kFoot}, high, court, Material::Plaster));
    const std::uint32_t room =
        site.addCell(courtShell(low, high, court, Material::InnerPlaster), {0.5, -3.5, 1.6});
    const double y = 2.0 + random.between(0.0, 2.0);
    site.openOutside(room, rectangle(Side::East, court.u0, {y, 0.875, y + 1.25, 2.125}), exterior);
    site.openOutside(room, rectangle(Side::West, court.u1, {y, 0.875, y + 1.25, 2.125}), exterior);
    site.openOutside(room, rectangle(Side::North, court.v0, {-0.625, 0.0, 0.625, 2.25}), exterior);
    site.openOutside(room, rectangle(Side::South, low.y, {-0.625, 0.0, 0.625, 2.25}), exterior);
    if (random.chance(0.5))
        site.openOutside(room, rectangle(Side::West, low.x, {y, 0.875, y + 1.25, 2.125}), exterior);
    site.addExterior(exterior);
    site.addStatic(room, props.pillar, {{-5.5, -3.5, 0.0}, 0.0});
    site.addStatic(room, props.lamp, {{6.0, 3.0, 0.0}, 0.0});
    site.addStatic(room, props.rod, {{court.u0, y + 0.625, 1.25}, 0.0});
    return site.finish();
}

} // namespace limen::worlds
