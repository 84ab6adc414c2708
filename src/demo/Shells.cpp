#include "demo/Shells.h"

#include "core/Assert.h"
#include "geometry/Plane.h"

#include <algorithm>
#include <cmath>

namespace limen::demo {

namespace {

constexpr double kPi = 3.14159265358979323846;
/// Metres: corners are planned on a grid of 2^-10 m or coarser.
constexpr double kPlanGrid = 1.0 / 1024.0;
constexpr double kInPlane = 1e-6;

double onGrid(double v) {
    return std::round(v / kPlanGrid) * kPlanGrid;
}

/// Two coordinates of a plane, and the way back.
class FlatView {
public:
    explicit FlatView(const std::vector<Vec3>& points) : plane_(planeOf(points)), origin_(points[0]) {
        level_ = std::abs(plane_.n.z) > 0.5;
        alongX_ = std::abs(plane_.n.y) > 0.5;
    }
    [[nodiscard]] bool holds(const Outline& outline) const {
        return std::all_of(outline.begin(), outline.end(),
                           [&](const Vec3& p) { return std::abs(plane_.signedDistance(p)) < kInPlane; });
    }
    [[nodiscard]] Vec2 flat(const Vec3& p) const {
        return level_ ? Vec2(p.x, p.y) : alongX_ ? Vec2(p.x, p.z) : Vec2(p.y, p.z);
    }
    [[nodiscard]] Vec3 lifted(const Vec2& p) const {
        const Vec3& n = plane_.n;
        if (level_) {
            return {p.x, p.y, origin_.z - (n.x * (p.x - origin_.x) + n.y * (p.y - origin_.y)) / n.z};
        }
        if (alongX_) {
            return {p.x, origin_.y - (n.x * (p.x - origin_.x) + n.z * (p.y - origin_.z)) / n.y, p.y};
        }
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
/// What the upright line at u meets of a convex polygon. Requires: u within its reach.
Span spanAt(const Flat& polygon, double u) {
    Span span{1e300, -1e300};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[(i + 1) % polygon.size()];
        const auto include = [&](double v) {
            span.low = std::min(span.low, v);
            span.high = std::max(span.high, v);
        };
        if (a.x == u) {
            include(a.y);
        }
        if ((a.x < u && b.x > u) || (a.x > u && b.x < u)) {
            include(a.y + (b.y - a.y) * ((u - a.x) / (b.x - a.x)));
        }
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
    for (const Vec2& p : whole) {
        cuts.push_back(p.x);
    }
    const auto [first, last] = std::minmax_element(cuts.begin(), cuts.end());
    const double from = *first;
    const double to = *last;
    for (const Flat& hole : holes) {
        for (const Vec2& p : hole) {
            if (p.x > from && p.x < to) {
                cuts.push_back(p.x);
            }
        }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
}

/// Less than this (metres) between two borders is nothing: both were found on the same edge.
constexpr double kNoHeight = 1e-9;

/// One strip between `a` and `b`, from the lower border's heights up to the upper one's; nothing if it has no area.
void addStrip(std::vector<Flat>& out, double a, double b, const Vec2& low, const Vec2& high) {
    Flat piece{{a, low.x}, {b, low.y}};
    if (high.y > low.y + kNoHeight) {
        piece.emplace_back(b, high.y);
    }
    if (high.x > low.x + kNoHeight) {
        piece.emplace_back(a, high.x);
    }
    if (piece.size() > 2) {
        out.push_back(std::move(piece));
    }
}

std::vector<Flat> stripsWithout(const Flat& whole, const std::vector<Flat>& holes) {
    std::vector<Flat> out;
    const std::vector<double> cuts = cutsOf(whole, holes);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double a = cuts[i];
        const double b = cuts[i + 1];
        std::vector<std::pair<Span, Span>> taken;
        for (const Flat& hole : holes) {
            if (spans(hole, a, b)) {
                taken.emplace_back(spanAt(hole, a), spanAt(hole, b));
            }
        }
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

Face facing(Face face, const Vec3& direction) {
    return glm::dot(faceNormal(face), direction) < 0.0 ? flipped(std::move(face)) : face;
}

Material materialOf(const ShellMaterials& materials, const Vec3& normal) {
    return normal.z > 0.7 ? materials.floor : normal.z < -0.7 ? materials.ceiling : materials.walls;
}

/// Lays the picture on a side of a swept body: u along it, v round the section, from `rolled` metres on.
void layRound(Face& face, const Vec3& along, const Vec3& edgeStart, const Vec3& edge, double rolled) {
    const double scale = 1.0 / metresPerTile(face.material);
    const Vec3 axis = glm::normalize(along);
    const Vec3 round = glm::normalize(edge - axis * glm::dot(edge, axis));
    for (std::size_t i = 0; i < face.points.size(); ++i) {
        const Vec3& p = face.points[i];
        face.uvs[i] = Vec2(glm::dot(p, axis), -(rolled + glm::dot(p - edgeStart, round))) * scale;
    }
}

} // namespace

std::vector<Face> faceWithout(const Face& face, const std::vector<Outline>& openings) {
    if (openings.empty()) {
        return {face};
    }
    const FlatView view(face.points);
    const auto flatten = [&](const Outline& outline) {
        Flat out;
        for (const Vec3& p : outline) {
            out.push_back(view.flat(p));
        }
        return out;
    };
    std::vector<Flat> holes;
    for (const Outline& opening : openings) {
        holes.push_back(flatten(opening));
    }
    std::vector<Face> out;
    for (const Flat& piece : stripsWithout(flatten(face.points), holes)) {
        std::vector<Vec3> points;
        for (const Vec2& p : piece) {
            points.push_back(view.lifted(p));
        }
        Face strip = planarFace(points, face.material);
        if (glm::dot(faceNormal(strip), view.normal()) < 0.0) {
            std::reverse(points.begin(), points.end());
            strip = planarFace(std::move(points), face.material);
        }
        out.push_back(std::move(strip));
    }
    return out;
}

std::vector<Face> sweptFaces(const Outline& section, const Vec3& along, const ShellMaterials& materials) {
    Vec3 middle = 0.5 * along;
    for (const Vec3& p : section) {
        middle += p / static_cast<double>(section.size());
    }
    const auto inward = [&](std::vector<Vec3> points) {
        if (glm::dot(planeOf(points).n, middle - points[0]) < 0.0) {
            std::reverse(points.begin(), points.end());
        }
        const Material material = materialOf(materials, planeOf(points).n);
        return planarFace(std::move(points), material);
    };
    const bool lying = std::abs(along.z) < 0.9 * glm::length(along);
    std::vector<Face> faces;
    double rolled = 0.0;
    for (std::size_t i = 0; i < section.size(); ++i) {
        const Vec3& a = section[i];
        const Vec3& b = section[(i + 1) % section.size()];
        Face side = inward({a, b, b + along, a + along});
        if (lying && std::abs(faceNormal(side).z) < 0.99) {
            layRound(side, along, a, b - a, rolled);
        }
        rolled += glm::length(b - a);
        faces.push_back(std::move(side));
    }
    std::vector<Vec3> end;
    for (const Vec3& p : section) {
        end.push_back(p + along);
    }
    faces.push_back(inward(section));
    faces.push_back(inward(std::move(end)));
    return faces;
}

Outline levelOutline(const std::vector<Vec2>& corners, double z) {
    Outline out;
    for (const Vec2& p : corners) {
        out.emplace_back(p, z);
    }
    return out;
}

std::vector<Vec2> octagon(double a, double h) {
    return {{a, -h}, {a, h}, {h, a}, {-h, a}, {-a, h}, {-a, -h}, {-h, -a}, {h, -a}};
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Outline archOutline(const Upright& at, double spring, double height) {
    constexpr int kArcs = 8;
    Outline out{at.foot - at.across * at.half, at.foot + at.across * at.half};
    for (int k = 0; k <= kArcs; ++k) {
        const double angle = kPi * k / kArcs;
        out.push_back(at.foot + at.across * onGrid(at.half * std::cos(angle)) +
                      Vec3(0.0, 0.0, onGrid(spring + (height - spring) * std::sin(angle))));
    }
    return out;
}

Outline rectOutline(const Upright& at, double height) {
    const Vec3 up{0.0, 0.0, height};
    const Vec3 side = at.across * at.half;
    return {at.foot - side, at.foot + side, at.foot + side + up, at.foot - side + up};
}

std::size_t CellComplex::add(std::string name, std::vector<Face> faces) {
    drafts_.push_back({std::move(name), std::move(faces), {}, {}});
    return drafts_.size() - 1;
}

std::size_t CellComplex::addRun(const std::string& name, const Outline& section, const Vec3& along,
                                std::size_t count, const ShellMaterials& materials) {
    const std::size_t first = drafts_.size();
    Outline at = section;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t cell = addSwept(name + "." + std::to_string(k), at, along, materials);
        if (k > 0) {
            join(cell - 1, cell, at);
        }
        for (Vec3& p : at) {
            p += along;
        }
    }
    return first;
}

void CellComplex::join(std::size_t a, std::size_t b, const Outline& opening) {
    open(a, opening);
    open(b, opening);
}

void CellComplex::open(std::size_t cell, const Outline& opening) {
    drafts_.at(cell).openings.push_back(opening);
}

std::vector<CellPlan> CellComplex::finish() const {
    std::vector<CellPlan> plans;
    for (const Draft& draft : drafts_) {
        CellPlan plan;
        plan.name = draft.name;
        plan.statics = draft.statics;
        std::vector<Face> portals;
        for (const Face& face : draft.faces) {
            const FlatView view(face.points);
            std::vector<Outline> own;
            std::copy_if(draft.openings.begin(), draft.openings.end(), std::back_inserter(own),
                         [&](const Outline& o) { return view.holds(o); });
            for (Face& strip : faceWithout(face, own)) {
                plan.faces.push_back(std::move(strip));
            }
            for (const Outline& o : own) {
                portals.push_back(facing(portalFace(o), view.normal()));
            }
        }
        LIMEN_ASSERT(portals.size() == draft.openings.size(),
                     "an opening lies in exactly one face of its cell");
        plan.faces.insert(plan.faces.end(), portals.begin(), portals.end());
        closeSeams(plan.faces);
        plans.push_back(std::move(plan));
    }
    return plans;
}

} // namespace limen::demo
