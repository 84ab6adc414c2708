#include "worlds/shapes/ArchWall.h"

#include "worlds/records/Seams.h"

#include <algorithm>
#include <cmath>

namespace limen::worlds {

namespace {

/// The height of a polyline (left to right) at u. Requires: u is within its extent.
double heightAt(const std::vector<Vec2>& line, double u) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (u >= line[i].x && u <= line[i + 1].x) {
            const double t = (u - line[i].x) / (line[i + 1].x - line[i].x);
            return line[i].y + (line[i + 1].y - line[i].y) * t;
        }
    }
    return line.back().y;
}

/// Corners are counter-clockwise in (y, z) with y to the right, as seen from inside a room with a west wall.
Face onWall(Side side, double at, const std::vector<Vec2>& corners, Material material) {
    std::vector<Vec3> points;
    for (const Vec2& c : corners)
        points.emplace_back(at, c.x, c.y);
    if (side == Side::East)
        std::reverse(points.begin(), points.end());
    return planarFace(std::move(points), material);
}

/// Rounds like all points of walls, so that adjacent walls have the same coordinates.
double onArchGrid(double v) {
    return std::round(v * 8192.0) / 8192.0;
}

} // namespace

HoleTop rectangleTop(const Rect& rect) {
    return {{rect.u0, rect.v1}, {rect.u1, rect.v1}};
}

HoleTop archTop(double middle, double radius, double springing, int segments) {
    HoleTop top;
    for (int k = 0; k <= segments; ++k) {
        const double a = 3.14159265358979323846 * (1.0 - static_cast<double>(k) / segments);
        top.emplace_back(onArchGrid(middle + radius * std::cos(a)),
                         onArchGrid(springing + radius * std::sin(a)));
    }
    return top;
}

std::vector<Face> wallFaces(const ArchWall& wall) {
    std::vector<double> cuts;
    for (const auto* line : {&wall.outline, &wall.hole})
        for (const Vec2& p : *line)
            cuts.push_back(p.x);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    std::vector<Face> faces;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double a = cuts[i];
        const double b = cuts[i + 1];
        const double middle = 0.5 * (a + b);
        const bool open = !wall.hole.empty() && middle > wall.hole.front().x && middle < wall.hole.back().x;
        const double lowA = open ? heightAt(wall.hole, a) : wall.foot;
        const double lowB = open ? heightAt(wall.hole, b) : wall.foot;
        faces.push_back(
            onWall(wall.side, wall.at,
                   {{a, lowA}, {b, lowB}, {b, heightAt(wall.outline, b)}, {a, heightAt(wall.outline, a)}},
                   wall.material));
    }
    return faces;
}

Face holePortal(const ArchWall& wall) {
    std::vector<Vec2> corners{{wall.hole.front().x, wall.foot}, {wall.hole.back().x, wall.foot}};
    corners.insert(corners.end(), wall.hole.rbegin(), wall.hole.rend());
    return portalFace(onWall(wall.side, wall.at, corners, wall.material).points);
}

CellPlan archedPassage(const char* name, double from, double to, double foot, const HoleTop& hole,
                       Material walls, Material floor) {
    CellPlan cell;
    cell.name = name;
    std::vector<Vec2> border{{hole.back().x, foot}}; // up the right side, over the top, down the left side
    border.insert(border.end(), hole.rbegin(), hole.rend());
    border.emplace_back(hole.front().x, foot);
    for (std::size_t i = 0; i < border.size(); ++i) {
        const Vec2& a = border[i];
        const Vec2& b = border[(i + 1) % border.size()];
        const bool ground = i + 1 == border.size();
        cell.faces.push_back(planarFace({{from, b.x, b.y}, {from, a.x, a.y}, {to, a.x, a.y}, {to, b.x, b.y}},
                                        ground ? floor : walls));
    }
    cell.faces.push_back(holePortal({Side::West, from, foot, {}, hole, walls}));
    cell.faces.push_back(holePortal({Side::East, to, foot, {}, hole, walls}));
    closeSeams(cell.faces);
    return cell;
}

} // namespace limen::worlds
