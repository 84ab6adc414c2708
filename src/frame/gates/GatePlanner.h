#pragma once

#include "frame/OpeningTriangles.h"
#include "frame/StaticScene.h"
#include "frame/TransparentRuns.h"
#include "frame/gates/GateSelection.h"
#include "frame/gates/GateViews.h"
#include "frame/gates/ScreenPlanes.h"
#include "visibility/Viewcone.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"

#include <optional>
#include <vector>

namespace limen::frame {

/// Plans the stages of a frame with Gate::Planes or Gate::Depth (docs/gates.md). One planner per thread; the scene
/// must outlive it.
class GatePlanner {
public:
    explicit GatePlanner(const StaticScene& scene);

    /// Adds everything but constants and lamps to the plan. Requires several visits, and a flood in which every
    /// space is a zone of its own.
    void plan(const FrameView& frame, const world::DynamicState& dynamics, const visibility::VisibleSet& set,
              FramePlan& plan);

private:
    /// One region of a space on the screen.
    struct Slice {
        std::uint32_t visit = 0;
        std::uint32_t clipSet = 0; ///< of the plan
        RectRun rects;
    };
    /// A wall or a piece of ground, whole or clipped by one slice.
    struct Surface {
        std::uint32_t position = 0;          ///< of Clusters::order
        std::uint32_t record = world::kNone; ///< of the plan; kNone: the static one, unclipped
        RectRun rects;
    };
    /// What one frame is planned from.
    struct Input {
        const FrameView& frame;
        const world::DynamicState& dynamics;
        const visibility::VisibleSet& set;
        FramePlan& plan;
    };
    using Order = std::span<const std::uint32_t>; ///< visits, far to near

    void begin(const Input& in);
    void planPlanes(const Input& in);
    void planDepth(const Input& in);

    /// Makes the slices of visits, those to the outside first.
    void makeSlices(const Input& in, Order visits);
    [[nodiscard]] Slice makeSlice(const Input& in, std::uint32_t visit);
    void reportSpaces(const Input& in, Order visits);
    /// Selects a part, and adds its dynamic instances to the plan.
    void selectPart(const Input& in, Order visits, std::size_t number);
    /// Appends the surfaces of a part that are of a slice's space.
    void addSliced(const Input& in, const Slice& slice, const SelectedPart& part, std::vector<Surface>& out);
    void addWhole(Order visits, const SelectedPart& part, const visibility::VisibleSet& set,
                  std::vector<Surface>& out) const;
    [[nodiscard]] Surface clipped(const Input& in, std::uint32_t position, const Slice& slice) const;

    void addSurfaces(std::span<const Surface> surfaces, DrawClass drawn, FramePlan& plan) const;
    void addObjects(std::size_t part, DrawClass drawn, FramePlan& plan);
    void addBlended(const Input& in, std::span<const Surface> surfaces, std::optional<std::size_t> part);
    [[nodiscard]] PieceRun runOf(const Surface& surface, DrawClass drawn, FramePlan& plan) const;
    void addSky(const Input& in, bool overLand);
    void addPlainSky(FramePlan& plan) const;
    void addOpenings(const Input& in, Order visits, Program program);

    // Of Gate::Depth.
    void planLandscape(const Input& in);
    void planBuilding(const Input& in, std::size_t building);
    void planInside(const Input& in, std::size_t part);
    /// Whether a step of the landscape draws a surface.
    [[nodiscard]] bool isOf(const Surface& surface, const LandscapeStep& step) const;
    /// Writes the ground and exteriors gathered so far as a stage, and forgets them.
    void flushGround(FramePlan& plan);

    [[nodiscard]] const world::Instance& instanceAt(std::uint32_t position) const {
        return world_.instances[scene_.clusters().order[position]];
    }

    const StaticScene& scene_;
    const world::World& world_;
    std::optional<Exteriors> exteriors_; ///< none until Gate::Depth is used
    GateSelection selection_;
    visibility::Viewcones cones_;
    std::vector<SelectedPart> parts_;
    std::vector<DynamicPieces> pieces_; ///< by part
    std::vector<Slice> slices_;         ///< those to the outside first
    std::size_t outsideSlices_ = 0;
    std::vector<ScreenPlanes> planes_; ///< by visit, of those with a slice
    std::vector<Surface> surfaces_, ground_;
    DepthViews views_; ///< of Gate::Depth
    TransparentRuns transparent_;
    std::vector<world::SkyPlacement> sky_;
};

} // namespace limen::frame
