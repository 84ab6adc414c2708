#pragma once

#include "frame/Clusters.h"
#include "frame/InstanceLevels.h"
#include "frame/OccluderShapes.h"
#include "frame/ResidentPieces.h"

namespace limen::frame {

/// The static content of a world, prepared for planning and for upload: made once from a world, immutable
/// afterwards. Threads may share it as `const`: a planner refers to one, frame/SceneBuilder.h makes the
/// upload from it.
class StaticScene {
public:
    /// `world` must outlive the scene and stay unchanged.
    explicit StaticScene(const world::World& world);
    StaticScene(const StaticScene&) = delete;
    StaticScene& operator=(const StaticScene&) = delete;

    [[nodiscard]] const world::World& world() const { return world_; }
    [[nodiscard]] const Clusters& clusters() const { return clusters_; }
    [[nodiscard]] const ClusterBatches& clusterBatches() const { return clusterBatches_; }
    /// The pieces of the static instances, which the runs of plans refer to.
    [[nodiscard]] const ResidentPieces& pieces() const { return pieces_; }
    /// The pieces of each mesh, for dynamic instances.
    [[nodiscard]] const MeshPieces& meshPieces() const { return meshPieces_; }
    [[nodiscard]] const OccluderShapes& occluders() const { return occluders_; }
    [[nodiscard]] const InstanceLevels& levels() const { return levels_; }
    /// The device records of World::instances, by number, without highlights.
    [[nodiscard]] std::span<const gpu::Instance> records() const { return records_; }
    /// The member records that `records` refer to; those of the spaces come first (frame/PackInstance.h).
    [[nodiscard]] std::span<const gpu::Member> members() const { return members_; }
    /// Whether draws of a class can be the shells of cells; blended ones always can.
    [[nodiscard]] bool mayBeShells(DrawClass drawn) const {
        return drawn == DrawClass::Wall || drawn == DrawClass::Blended ||
               (drawn == DrawClass::CutOut && hasShellCutOuts_);
    }
    /// The static instances of an object, ascending; empty if the world has no such object.
    [[nodiscard]] std::span<const world::InstanceIndex> instancesOf(std::uint64_t object) const;

private:
    const world::World& world_;
    const Clusters clusters_;
    const ClusterBatches clusterBatches_;
    const ResidentPieces pieces_;
    const MeshPieces meshPieces_;
    const OccluderShapes occluders_;
    const InstanceLevels levels_;
    std::vector<gpu::Member> members_;
    std::vector<gpu::Instance> records_;
    const bool hasShellCutOuts_;                 ///< cut-outs, or split surfaces
    std::vector<world::InstanceIndex> byObject_; ///< sorted by object, then by number
};

} // namespace limen::frame
