#pragma once

#include "reference/Scene.h"

#include <cstdint>
#include <vector>

namespace limen::check {

/// Queries about single rays of one view, for pixels that need a second look. (x, y) are pixels of the
/// picture, with centres at whole numbers. An interface, so that tests can make up the answers.
class Retracer {
public:
    virtual ~Retracer() = default;

    /// The ray rule, as in the traced picture.
    [[nodiscard]] virtual reference::Answer exact(double x, double y) = 0;
    /// The rule's other option: objects are met in every space of their zones
    /// (reference::RuleOptions::objectsByZone).
    [[nodiscard]] virtual reference::Answer byZone(double x, double y) = 0;
    /// False for a ray that leaves the root space of an eye on a wall or on the edge of an opening
    /// (check/EyeContact.h).
    [[nodiscard]] virtual bool leadsIntoTheRoot(double x, double y) = 0;
    /// True if polygon `id` covers the place up to the rasteriser's rounding, and its plane there is nearer
    /// than depth `shown` (check/LonePolygon.h).
    [[nodiscard]] virtual bool isEdgeOn(double x, double y, std::uint32_t id, double shown) = 0;
    /// Pixels by which floats may move the outline of polygon `id` at the place, 1/128 at most
    /// (check/LonePolygon.h).
    [[nodiscard]] virtual double outlineRounding(double x, double y, std::uint32_t id) = 0;
    /// The ids of all polygons near the ray, in any space. Overwrites `ids`. Slow.
    virtual void polygonsAlong(double x, double y, std::vector<std::uint32_t>& ids) = 0;
    /// True if the rasteriser may give polygon `id` the view depth `drawn` at the pixel's centre
    /// (check/LonePolygon.h).
    [[nodiscard]] virtual bool mayHaveDepth(int x, int y, std::uint32_t id, double drawn) = 0;
};

} // namespace limen::check
