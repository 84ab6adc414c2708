#include "worlds/shapes/Panel.h"

namespace limen::worlds {

namespace {

std::vector<double> cuts(double from, double to, const std::vector<Rect>& holes) {
    std::vector<double> out{from, to};
    for (const Rect& h : holes) {
        for (const double u : {h.u0, h.u1})
            if (u > from && u < to)
                out.push_back(u);
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

} // namespace

std::vector<Rect> withoutHoles(const Rect& whole, const std::vector<Rect>& holes) {
    std::vector<Rect> relevant;
    for (const Rect& h : holes)
        if (h.v1 > whole.v0 && h.v0 < whole.v1 && h.u1 > whole.u0 && h.u0 < whole.u1)
            relevant.push_back(h);
    std::sort(relevant.begin(), relevant.end(), [](const Rect& a, const Rect& b) { return a.v0 < b.v0; });
    const std::vector<double> edges = cuts(whole.u0, whole.u1, relevant);
    std::vector<Rect> out;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        double v = whole.v0;
        for (const Rect& h : relevant) {
            if (h.u0 <= edges[i] && h.u1 >= edges[i + 1]) {
                if (h.v0 > v)
                    out.push_back({edges[i], v, edges[i + 1], h.v0});
                v = std::max(v, h.v1);
            }
        }
        if (v < whole.v1)
            out.push_back({edges[i], v, edges[i + 1], whole.v1});
    }
    return out;
}

double planeOfSide(const Vec3& min, const Vec3& max, Side side) {
    switch (side) {
    case Side::West:
        return min.x;
    case Side::East:
        return max.x;
    case Side::South:
        return min.y;
    case Side::North:
        return max.y;
    case Side::Floor:
        return min.z;
    case Side::Ceiling:
        break;
    }
    return max.z;
}

std::vector<Vec3> rectOnSide(Side side, double at, const Rect& r) {
    switch (side) {
    case Side::West:
        return {{at, r.u0, r.v0}, {at, r.u1, r.v0}, {at, r.u1, r.v1}, {at, r.u0, r.v1}};
    case Side::East:
        return {{at, r.u1, r.v0}, {at, r.u0, r.v0}, {at, r.u0, r.v1}, {at, r.u1, r.v1}};
    case Side::South:
        return {{r.u1, at, r.v0}, {r.u0, at, r.v0}, {r.u0, at, r.v1}, {r.u1, at, r.v1}};
    case Side::North:
        return {{r.u0, at, r.v0}, {r.u1, at, r.v0}, {r.u1, at, r.v1}, {r.u0, at, r.v1}};
    case Side::Floor:
        return {{r.u0, r.v0, at}, {r.u1, r.v0, at}, {r.u1, r.v1, at}, {r.u0, r.v1, at}};
    case Side::Ceiling:
        return {{r.u0, r.v1, at}, {r.u1, r.v1, at}, {r.u1, r.v0, at}, {r.u0, r.v0, at}};
    }
    return {};
}

} // namespace limen::worlds
