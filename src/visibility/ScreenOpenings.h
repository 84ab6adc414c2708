#pragma once

#include "visibility/FloodTrace.h"
#include "visibility/Graph.h"
#include "visibility/VisibleSet.h"

#include <span>
#include <vector>

namespace limen::visibility {

/// NDC by which rectangles are widened: an eighth of a pixel on a 4k screen. The rasteriser snaps vertices,
/// and a cell seen through a gap narrower than that must not be lost.
inline constexpr double kRectMargin = 1e-4;

/// The openings of the spaces on the screen of one view. The openings of a space are projected together, when
/// the first ray enters it, and kept until the flood ends.
class ScreenOpenings {
public:
    /// The input of a flood.
    struct Input {
        const Graph* graph = nullptr;
        std::span<const std::uint8_t> closed; ///< by portal; empty: all open
        Vec3 eye{0.0};
        Mat3 screenFromEye{1.0};
        bool isTraced = false; ///< also keep the openings that no ray passes
    };
    /// An open portal to another space of the same zone.
    struct Inner {
        Rect rect; ///< contains all rays that pass it; the whole plane for an eye in the opening
        std::uint32_t portal = 0, destination = 0;
        PortalFate refusal = PortalFate::OutsideRegion; ///< of rays that are outside `rect`
    };
    /// Another portal that faces the eye, or nearly: it leads out of the zone or nowhere, or is closed. A run
    /// of the vertices of its outline.
    struct Exit {
        Rect rect; ///< contains the outline; the whole plane if a part of it is behind the eye
        std::uint32_t portal = 0;
        std::uint32_t firstVertex = 0, vertexCount = 0;
    };
    /// The openings of one space, as runs of the arrays below.
    struct Space {
        std::uint32_t stamp = 0;
        std::uint32_t firstInner = 0, innerCount = 0;
        std::uint32_t tested = 0;                   ///< inner portals that face the eye, or nearly
        std::uint32_t firstExit = 0, exitCount = 0; ///< of a space without a tree of bounds
        bool hasExits = false;
    };

    /// Forgets the projections of the flood before.
    void begin(const Input& input);
    /// Projects the space's openings if this has not been done. The reference is valid until the next call.
    [[nodiscard]] const Space& of(std::uint32_t space) {
        Space& known = spaces_[space];
        if (known.stamp != stamp_)
            project(space, known);
        return known;
    }
    [[nodiscard]] std::span<const Inner> inner(const Space& space) const {
        return std::span<const Inner>(inner_).subspan(space.firstInner, space.innerCount);
    }
    [[nodiscard]] std::span<const Exit> exits(const Space& space) const {
        return std::span<const Exit>(exits_).subspan(space.firstExit, space.exitCount);
    }
    /// The vertices of an exit's outline, relative to the eye.
    [[nodiscard]] std::span<const Vec3> relative(const Exit& exit) const {
        return std::span<const Vec3>(relative_).subspan(exit.firstVertex, exit.vertexCount);
    }
    /// The vertices of an exit's outline in (x, y, w).
    [[nodiscard]] std::span<const Vec3> onScreen(const Exit& exit) const {
        return std::span<const Vec3>(onScreen_).subspan(exit.firstVertex, exit.vertexCount);
    }

private:
    void project(std::uint32_t index, Space& space);
    void addInner(std::uint32_t index, const Graph::Portal& portal, double side);
    void addExit(std::uint32_t index, const Graph::Portal& portal);
    [[nodiscard]] bool screenRect(std::span<const Vec3> polygon, Rect& rect);

    Input in_;
    std::vector<Space> spaces_; ///< by space
    std::vector<Inner> inner_;
    std::vector<Exit> exits_;
    std::vector<Vec3> relative_, onScreen_;
    std::uint32_t stamp_ = 0;
    std::vector<Vec3> clipped_, swap_, hull_;
};

} // namespace limen::visibility
