#pragma once

#include "visibility/VisibleSet.h"

#include <cstdint>
#include <vector>

namespace limen::visibility {

/// A visit to be: an opening admitted from its parent, not yet placed in the tree.
struct Candidate {
    std::uint32_t portal = 0;
    std::uint32_t parent = 0;
    Plane entryPlane;                               ///< eye-relative; beyond = positive
    Vec3 planeOnScreen{0.0};                        ///< its normal for points in (x, y, w)
    Rect rect;                                      ///< bounds of the region
    std::uint32_t firstVertex = 0, vertexCount = 0; ///< region, in the owner's vertex array
    bool inPlane = false;
    bool hole = false; ///< rays that pass the portal's polygon and end there
    bool shut = false; ///< a hole that is filled
    bool narrowed = false;
    bool split = false; ///< one of the parts of an opening cut to break a circle of overlaps
};

/// Candidates with their regions side by side.
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
