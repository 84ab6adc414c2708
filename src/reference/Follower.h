#pragma once

#include "reference/SceneData.h"

#include "core/SmallVec.h"

namespace limen::reference {

/// Follows one ray from space to space: the ray rule itself. Made for one ray and dropped after it.
class Follower {
public:
    Follower(const SceneData& scene, const Ray& ray);
    [[nodiscard]] Answer follow(world::SpaceIndex root);

private:
    /// A translucent polygon met, where it is met first.
    struct Layer {
        std::uint32_t id = 0;
        double t = 0.0;
    };
    struct Visit {
        world::SpaceIndex space = world::kOutside;
        double after = 0.0;                       ///< where the ray entered; portals beyond it
        double surfacesAfter = 0.0;               ///< surfaces may lie a little before the entry
        world::PortalIndex cameBy = world::kNone; ///< kNone: the root
    };
    [[nodiscard]] Exit exitOf(const Visit& visit) const;
    [[nodiscard]] Leaving leavingFrom(const Visit& visit) const;
    void meetSurfaces(const Visit& visit, double most);
    void meetLayers(const TriangleSet& blended, bool isFilling, const Stretch& stretch);
    [[nodiscard]] bool closeGap(const Visit& visit, Exit& exit);
    void meetFilling(const Exit& exit);
    [[nodiscard]] bool isShut(world::PortalIndex portal) const {
        return !scene_.shut.empty() && scene_.shut[portal] != 0;
    }
    [[nodiscard]] Layers layersBefore(double end) const;

    /// Calls act(bodies, place) for all that a ray can meet in the space.
    template <class Do>
    void forPlaces(world::SpaceIndex space, Do&& act) const;
    /// Calls meet(triangles) for those of the space's bodies that the ray may meet in the stretch, not beyond the nearest
    /// surface, roughly from near to far.
    template <class Meet>
    void forSolids(world::SpaceIndex space, const BoxRay& boxRay, const Stretch& stretch, Meet&& meet) const;

    const SceneData& scene_;
    RayFrame ray_;
    BoxRay boxRay_;
    double nearPlane_;
    Nearest nearest_;
    double end_ = std::numeric_limits<double>::infinity(); ///< layers at most here
    SmallVec<Layer, 16> layers_;
    SmallVec<world::PortalIndex, 8> notAgain_;
};

} // namespace limen::reference
