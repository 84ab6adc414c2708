#pragma once

#include "frame/FramePlan.h"
#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/World.h"

#include <span>

namespace limen::frame {

/// Appends the triangles of openings to a plan: `ownershipVertices`, and a clip set for each region that clips
/// them. An opening has the same vertices as the walls around it. With FrameView::coverageDecides and Gate::Ownership triangles
/// are counter-clockwise in the picture. All arguments must outlive it.
class OpeningTriangles {
public:
    OpeningTriangles(const world::World& world, const FrameView& frame, const visibility::VisibleSet& set,
                     FramePlan& plan)
        : world_(world), frame_(frame), set_(set), plan_(plan), screen_(frame.view.screenFromEye()) {}

    /// Pixels by which a parent's edges are moved outwards. The edges are exact, but the parent was drawn with snapped
    /// corners: the child must not lose a pixel that the parent owns. With a larger growth the child takes pixels beside
    /// a thin jamb that its parent does not own, and surfaces behind the parent's plane show there.
    static constexpr double kGrowth = kSnapTolerance;

    /// How an opening is clipped to a region.
    struct Clip {
        double growth = 0.0;         ///< pixels by which the region's edges are moved outwards
        gpu::vec4 plane{0, 0, 0, 1}; ///< and one more plane
    };

    /// Whether the eye is in the opening's plane or so near it that floats may put it on the wrong side. Then
    /// the flood's region, computed in double, decides alone. Its edges are not exactly the walls', but that
    /// is not visible: such a region is half of all directions, or too thin to hold more than a few pixels.
    [[nodiscard]] static bool isEdgeOn(const visibility::Visit& visit) {
        return visit.inPlane || std::abs(visit.entryPlane.d) < kEyeInPlaneTolerance;
    }
    /// gpu::Visit::entryPlane: eye-relative; the root's keeps everything. Openings are drawn by this plane.
    [[nodiscard]] static gpu::vec4 entryPlaneOf(const visibility::Visit& visit) {
        return visit.depth == 0 ? gpu::vec4(0, 0, 0, 1)
                                : gpu::vec4(Vec3f(visit.entryPlane.n), visit.entryPlane.d);
    }
    /// A clip set that keeps everything.
    [[nodiscard]] static gpu::ClipSet openClipSet();
    /// Draws the opening of a visit whole. Its plane must not contain the eye.
    void draw(std::uint32_t visit) { draw(visit, Clipping{}); }
    /// Draws the opening of a visit within a region. A region with more edges than a clip set has is divided into
    /// fans around its first vertex, one draw each. The inner edges of the fans are always moved outwards, so that
    /// the fans overlap and leave no gap.
    void drawWithin(std::uint32_t visit, std::span<const Vec3> region, const Clip& by);
    /// Draws the visit's region itself.
    void drawRegion(std::uint32_t visit);
    /// Whether the eye is so near the opening that the rasteriser does not find its edges.
    [[nodiscard]] bool isNear(const visibility::Visit& visit) const;

private:
    /// A clip set, and how many of its edges are in use.
    struct Clipping {
        std::uint32_t set = 0, edges = 1;
    };
    /// False if all corners of the opening are two pixels inside of an edge, so that no fragment need test it.
    [[nodiscard]] bool mayCut(const gpu::vec4& edge, std::uint32_t visit) const;
    /// The plane through the eye and one edge of a region, moved outwards by `growth` pixels, eye-relative.
    [[nodiscard]] gpu::vec4 edgePlane(const Vec3& a, const Vec3& b, double growth) const;
    /// An opening whose plane contains the eye is drawn around the window: its clip set must be its region.
    void draw(std::uint32_t visit, const Clipping& by);
    void drawEverywhere(std::uint32_t visit, const Clipping& by);
    void drawPortal(std::uint32_t visit, const Clipping& by);
    /// Turns the last triangle, if need be. Its corners on the screen, homogeneous.
    void face(const Vec3& a, const Vec3& b, const Vec3& c);

    const world::World& world_;
    const FrameView& frame_;
    const visibility::VisibleSet& set_;
    FramePlan& plan_;
    Mat3 screen_;
};

} // namespace limen::frame
