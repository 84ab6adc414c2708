#include "visibility/Outline.h"

#include <algorithm>

namespace limen::visibility {

namespace {

/// True if `p` lies outside the edge from `a` to `b` of a polygon that is counter-clockwise from the eye, the origin.
bool isOutside(const Vec3& a, const Vec3& p, const Vec3& b) {
    return glm::dot(glm::cross(a, b), p) > 0.0;
}

} // namespace

std::vector<OutlineVertex> markCorners(std::span<const Vec3> corners, std::span<const Vec3> outline) {
    std::vector<OutlineVertex> marked;
    const auto first =
        corners.empty() ? outline.end() : std::find(outline.begin(), outline.end(), corners[0]);
    if (first == outline.end() || outline.size() <= corners.size()) {
        return marked;
    }
    const auto start = static_cast<std::size_t>(first - outline.begin());
    std::size_t met = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec3& vertex = outline[(start + i) % outline.size()];
        const bool isCorner = met < corners.size() && vertex == corners[met];
        marked.push_back({vertex, isCorner});
        met += isCorner ? 1 : 0;
    }
    if (met < corners.size()) {
        marked.clear();
    }
    return marked;
}

void hullSeenFrom(const Vec3& eye, std::span<const OutlineVertex> outline, std::vector<Vec3>& out) {
    out.clear();
    std::size_t corner = 0; // the last one's place in `out`; corners always stay
    const auto add = [&](const Vec3& vertex) {
        while (out.size() > corner + 1 && !isOutside(out[out.size() - 2], out.back(), vertex)) {
            out.pop_back();
        }
        out.push_back(vertex);
    };
    for (const OutlineVertex& vertex : outline) {
        add(vertex.at - eye);
        if (vertex.isCorner) {
            corner = out.size() - 1;
        }
    }
    add(outline.front().at - eye); // closes the last edge
    out.pop_back();
}

} // namespace limen::visibility
