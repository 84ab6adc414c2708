#pragma once

#include "reference/TileCandidates.h"

#include <optional>

namespace limen::reference {

/// The triangles and portals that a ray may meet in a space: all that it meets, and some near it. A single
/// ray walks the hierarchies; a ray of a tile goes through the candidates that the tile has gathered. The
/// Follower tests both with the same arithmetic, so answers do not depend on the source.
class Candidates {
public:
    /// For a single ray. `ray` must outlive it.
    Candidates(const SceneData& scene, const RayFrame& ray, const world::RangeSteps& eye)
        : scene_(scene), ray_(ray), eye_(eye) {}
    /// For the ray of a tile's pixel (column + 8 · row).
    Candidates(const SceneData& scene, const RayFrame& ray, const world::RangeSteps& eye,
               TileCandidates& tile, std::uint32_t pixel)
        : scene_(scene), ray_(ray), eye_(eye), tile_(&tile), pixel_(pixel) {}

    /// The nearest portal that the ray leaves its space through.
    [[nodiscard]] Exit exitOf(const Leaving& from) {
        return tile_ ? scene_.openings.nearest(tile_->in(from.space).portals, ray_, from)
                     : scene_.openings.nearest(ray_, boxRay(), from);
    }

    /// Calls visit(set, triangle) for solid triangles of a space, after `after` and not beyond `farthest`,
    /// which `visit` may lower; roughly from near to far.
    template <class Visit>
    void forSolids(world::SpaceIndex space, double after, const double& farthest, Visit&& visit) {
        const auto visitAll = [&](const TriangleSet& set) {
            set.walk(boxRay(), after, farthest, [&](const Triangle& triangle) { visit(set, triangle); });
        };
        if (tile_) {
            tile_->in(space).solid.walk(pixel_, after, farthest, [&](const TileSurfaces::Found& found) {
                found.triangle ? visit(*found.set, *found.triangle) : visitAll(*found.set);
            });
            return;
        }
        scene_.forLists(space, [&](const Bodies& bodies, const BodyLists::ListPair& lists) {
            lists.solid.walk(boxRay(), after, farthest, [&](std::uint32_t body) {
                if (bodies.isInLevelRange(body, eye_))
                    visitAll(bodies.surfacesOf(body).solid);
            });
        });
    }

    /// Calls visit(triangle, isFilling) for translucent triangles of a space, after `after` and not beyond
    /// `most`: all triangles up to `nearest`, and those of fillings at any distance.
    template <class Visit>
    void forBlended(world::SpaceIndex space, double after, double most, double nearest, Visit&& visit) {
        const auto visitAll = [&](const TriangleSet& set, bool isFilling) {
            set.walk(boxRay(), after, most, [&](const Triangle& triangle) { visit(triangle, isFilling); });
        };
        if (tile_) {
            tile_->in(space).blended.walk(pixel_, after, std::min(most, nearest),
                                          [&](const TileSurfaces::Found& found) {
                                              found.triangle ? visit(*found.triangle, found.isFilling)
                                                             : visitAll(*found.set, found.isFilling);
                                          });
            return;
        }
        scene_.forLists(space, [&](const Bodies& bodies, const BodyLists::ListPair& lists) {
            lists.blended.walk(boxRay(), after, most, [&](std::uint32_t body) {
                if (bodies.isInLevelRange(body, eye_))
                    visitAll(bodies.surfacesOf(body).blended, bodies.isFilling(body));
            });
        });
    }

private:
    [[nodiscard]] const BoxRay& boxRay() {
        if (!boxRay_)
            boxRay_.emplace(ray_.eye, ray_.direction, 0.0);
        return *boxRay_;
    }

    const SceneData& scene_;
    const RayFrame& ray_;
    const world::RangeSteps eye_;
    std::optional<BoxRay> boxRay_; ///< made when first needed: many rays of tiles need none
    TileCandidates* tile_ = nullptr;
    std::uint32_t pixel_ = 0;
};

} // namespace limen::reference
