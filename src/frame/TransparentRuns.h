#pragma once

#include "frame/DynamicPieces.h"
#include "frame/FramePlan.h"
#include "frame/StaticScene.h"
#include "world/DynamicState.h"

#include <span>
#include <vector>

namespace limen::frame {

/// The blended pieces of a transparent batch, by instance. Reuse it: steady frames allocate nothing.
class TransparentRuns {
public:
    void clear() { runs_.clear(); }
    /// Adds static instances: positions of Clusters::order, from `first` to before `end`.
    void addStatic(const StaticScene& scene, const Vec3& eye, std::uint32_t first, std::uint32_t end);
    /// Adds a run of pieces of one instance. `bounds`: of the instance, global.
    void addRun(const PieceRun& run, std::uint32_t instance, const Sphere& bounds, const Vec3& eye);
    /// Moves the blended pieces of `pieces` into the plan, and adds them.
    void addDynamic(const world::DynamicState& dynamics, const Vec3& eye, DynamicPieces& pieces,
                    FramePlan& plan);
    /// Adds everything to the plan's last batch, back to front.
    void write(bool gated, FramePlan& plan);

private:
    struct Run {
        double distance = 0.0; ///< from the eye to the nearest point of its bounds, metres
        std::uint32_t instance = 0;
        PieceRun run;
    };
    /// Pieces of one class in which those of an instance are consecutive. `first`: number of the first piece;
    /// `boundsOf(instance)`: its bounding sphere.
    template <class BoundsOf>
    void gather(const Vec3& eye, std::span<const gpu::DrawPiece> pieces, std::uint32_t first,
                const BoundsOf& boundsOf);

    std::vector<Run> runs_;
};

} // namespace limen::frame
