#pragma once

#include "visibility/VisibleSet.h"

#include <cstdint>
#include <vector>

namespace limen::visibility {

/// An opening that its parent has admitted and that is not yet a visit of the tree.
struct Candidate {
    std::uint32_t portal = 0;
    std::uint32_t parent = 0;
    Plane entryPlane;                               ///< eye-relative; beyond = positive
    Vec3 planeOnScreen{0.0};                        ///< its normal for points in (x, y, w)
    Rect rect;                                      ///< bounds of the region
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< region, in the owner's vertex array
    bool inPlane = false;
    bool hole = false; ///< rays pass the portal's polygon and end there
    bool shut = false; ///< a hole with a filling
    bool narrowed = false;
    bool split = false; ///< a part of an opening that was cut to break a cycle of overlaps
};

/// Candidates, and their regions in one array.
struct CandidateList {
    std::vector<Candidate> items;
    std::vector<Vec3> vertices;

    void clear() {
        items.clear();
        vertices.clear();
    }
    [[nodiscard]] std::span<const Vec3> region(const Candidate& c) const {
        return std::span<const Vec3>(vertices).subspan(c.firstVertex, c.vertexCount);
    }
    void add(Candidate candidate, std::span<const Vec3> region) {
        candidate.firstVertex = static_cast<std::uint32_t>(vertices.size());
        candidate.vertexCount = static_cast<std::uint32_t>(region.size());
        vertices.insert(vertices.end(), region.begin(), region.end());
        items.push_back(candidate);
    }
};

} // namespace limen::visibility
