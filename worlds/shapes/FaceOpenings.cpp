#include "worlds/shapes/CellComplex.h"

#include "geometry/Plane.h"

#include <algorithm>
#include <cmath>

namespace limen::worlds {

namespace {

/// Metres. Points nearer than this to a face's plane are in it.
constexpr double kInFacePlane = 1e-6;

/// Converts between points of a plane and two coordinates in it.
class FlatView {
public:
    explicit FlatView(const std::vector<Vec3>& points) : plane_(planeOf(points)), origin_(points[0]) {
        level_ = std::abs(plane_.n.z) > 0.5;
        alongX_ = std::abs(plane_.n.y) > 0.5;
    }
    [[nodiscard]] Vec2 flat(const Vec3& p) const {
        return level_ ? Vec2(p.x, p.y) : alongX_ ? Vec2(p.x, p.z) : Vec2(p.y, p.z);
    }
    [[nodiscard]] Vec3 lifted(const Vec2& p) const {
        const Vec3& n = plane_.n;
        if (level_)
            return {p.x, p.y, origin_.z - (n.x * (p.x - origin_.x) + n.y * (p.y - origin_.y)) / n.z};
        if (alongX_)
            return {p.x, origin_.y - (n.x * (p.x - origin_.x) + n.z * (p.y - origin_.z)) / n.y, p.y};
        return {origin_.x - (n.y * (p.x - origin_.y) + n.z * (p.y - origin_.z)) / n.x, p.x, p.y};
    }
    [[nodiscard]] const Vec3& normal() const { return plane_.n; }

private:
    Plane plane_;
    Vec3 origin_;
    bool level_ = false, alongX_ = false;
};

using Flat = std::vector<Vec2>;

struct Span {
    double low = 0.0, high = 0.0;
};
/// The part of the upright line at u that is inside a convex polygon. Requires: u is within its extent.
Span spanAt(const Flat& polygon, double u) {
    Span span{1e300, -1e300};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[(i + 1) % polygon.size()];
        const auto include = [&](double v) {
            span.low = std::min(span.low, v);
            span.high = std::max(span.high, v);
        };
        if (a.x == u)
            include(a.y);
        if ((a.x < u && b.x > u) || (a.x > u && b.x < u))
            include(a.y + (b.y - a.y) * ((u - a.x) / (b.x - a.x)));
    }
    return span;
}

bool spans(const Flat& polygon, double from, double to) {
    const auto [low, high] = std::minmax_element(polygon.begin(), polygon.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    return low->x <= from && high->x >= to;
}

std::vector<double> cutsOf(const Flat& whole, const std::vector<Flat>& holes) {
    std::vector<double> cuts;
    for (const Vec2& p : whole)
        cuts.push_back(p.x);
    const auto [first, last] = std::minmax_element(cuts.begin(), cuts.end());
    const double from = *first;
    const double to = *last;
    for (const Flat& hole : holes) {
        for (const Vec2& p : hole)
            if (p.x > from && p.x < to)
                cuts.push_back(p.x);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

/// Metres. Two borders nearer than this to each other are on the same edge.
constexpr double kNoHeight = 1e-9;

/// Adds the strip between `a` and `b`, from the lower border's heights up to the upper one's, unless it has
/// no area.
void addStrip(std::vector<Flat>& out, double a, double b, const Vec2& low, const Vec2& high) {
    Flat piece{{a, low.x}, {b, low.y}};
    if (high.y > low.y + kNoHeight)
        piece.emplace_back(b, high.y);
    if (high.x > low.x + kNoHeight)
        piece.emplace_back(a, high.x);
    if (piece.size() > 2)
        out.push_back(std::move(piece));
}

std::vector<Flat> stripsWithout(const Flat& whole, const std::vector<Flat>& holes) {
    std::vector<Flat> out;
    const std::vector<double> cuts = cutsOf(whole, holes);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double a = cuts[i];
        const double b = cuts[i + 1];
        std::vector<std::pair<Span, Span>> taken;
        for (const Flat& hole : holes)
            if (spans(hole, a, b))
                taken.emplace_back(spanAt(hole, a), spanAt(hole, b));
        std::sort(taken.begin(), taken.end(), [](const auto& p, const auto& q) {
            return p.first.low + p.second.low < q.first.low + q.second.low;
        });
        const Span left = spanAt(whole, a);
        const Span right = spanAt(whole, b);
        Vec2 low{left.low, right.low};
        for (const auto& [l, r] : taken) {
            addStrip(out, a, b, low, {l.low, r.low});
            low = {l.high, r.high};
        }
        addStrip(out, a, b, low, {left.high, right.high});
    }
    return out;
}

} // namespace

std::vector<Face> faceWithout(const Face& face, const std::vector<Outline>& openings) {
    if (openings.empty())
        return {face};
    const FlatView view(face.points);
    const auto flatten = [&](const Outline& outline) {
        Flat out;
        for (const Vec3& p : outline)
            out.push_back(view.flat(p));
        return out;
    };
    std::vector<Flat> holes;
    for (const Outline& opening : openings)
        holes.push_back(flatten(opening));
    std::vector<Face> out;
    for (const Flat& piece : stripsWithout(flatten(face.points), holes)) {
        std::vector<Vec3> points;
        for (const Vec2& p : piece)
            points.push_back(view.lifted(p));
        Face strip = planarFace(points, face.material);
        if (glm::dot(faceNormal(strip), view.normal()) < 0.0) {
            std::reverse(points.begin(), points.end());
            strip = planarFace(std::move(points), face.material);
        }
        out.push_back(std::move(strip));
    }
    return out;
}

bool liesIn(const Outline& outline, const Face& face) {
    const Plane plane = planeOf(face.points);
    return std::all_of(outline.begin(), outline.end(),
                       [&](const Vec3& p) { return std::abs(plane.signedDistance(p)) < kInFacePlane; });
}

} // namespace limen::worlds
