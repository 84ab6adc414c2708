#pragma once

#include "reference/Candidates.h"
#include "reference/Gap.h"

#include "core/SmallVec.h"

namespace limen::reference {

/// Follows one ray from space to space: the ray rule itself. An object serves one ray.
class Follower {
public:
    /// A single ray.
    Follower(const SceneData& scene, const Ray& ray);
    /// The ray of a tile's pixel (column + 8 · row), with the tile's candidates. The answer is the same.
    Follower(const SceneData& scene, const Ray& ray, TileCandidates& tile, std::uint32_t pixel);
    Follower(const Follower&) = delete; // candidates_ refers to ray_
    Follower& operator=(const Follower&) = delete;
    /// `root`: by Openings::spaceOfEye.
    [[nodiscard]] Answer follow(world::SpaceIndex root);

private:
    /// A translucent polygon and the parameter at which it is first met.
    struct Layer {
        std::uint32_t id = 0;
        double t = 0.0;
    };
    struct Visit {
        world::SpaceIndex space = world::kOutside;
        double after = 0.0;                       ///< where the ray entered; portals beyond it count
        double surfacesAfter = 0.0;               ///< surfaces beyond this count: a little before the entry
        world::PortalIndex cameBy = world::kNone; ///< kNone: the root
    };
    [[nodiscard]] Leaving leavingFrom(const Visit& visit) const;
    void meetSurfaces(const Visit& visit, double most);
    void meetLayer(const Triangle& triangle, bool isFilling, double t);
    [[nodiscard]] bool isGap(world::SpaceIndex space, const BoxRay& wide, const Gap& gap) const;
    [[nodiscard]] bool closeGap(const Visit& visit, Exit& exit);
    void meetFilling(const Exit& exit);
    [[nodiscard]] bool isShut(world::PortalIndex portal) const {
        return !scene_.shut.empty() && scene_.shut[portal] != 0;
    }
    [[nodiscard]] Layers layersBefore(double end) const;

    const SceneData& scene_;
    RayFrame ray_;
    const world::RangeSteps eye_;
    Candidates candidates_;
    double nearPlane_;
    Nearest nearest_;
    double end_ = std::numeric_limits<double>::infinity(); ///< layers beyond this do not count
    SmallVec<Layer, 16> layers_;
    SmallVec<world::PortalIndex, 8> notAgain_;
};

} // namespace limen::reference
