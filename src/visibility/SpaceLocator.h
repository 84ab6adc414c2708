#pragma once

#include "geometry/Bounds.h"
#include "visibility/SpaceMesh.h"

#include <array>
#include <span>
#include <vector>

namespace limen::visibility {

/// Finds the spaces that contain a point, from the closed meshes of the spaces. Immutable; may be shared by threads.
/// For a point that moves, use spaceAfterMove: spaces may overlap, and only the way decides then.
class LIMEN_API SpaceLocator {
public:
    /// Copies the meshes; space i is that of mesh i. `tolerance` and errors: those of checkClosed.
    [[nodiscard]] static Result<SpaceLocator> build(std::span<const SpaceMesh> meshes, double tolerance);

    /// The lowest space that contains the point; kNone if none does. A point on a face is inside. Cost: the triangles
    /// of the spaces whose boxes contain the point. Ref: van Oosterom, Strackee, "The solid angle of a plane triangle"
    /// (1983); Jacobson et al., "Robust inside-outside segmentation using generalized winding numbers" (2013).
    [[nodiscard]] std::uint32_t spaceAt(const Vec3& point) const;
    /// All spaces that contain the point, ascending. `out` is overwritten.
    void spacesAt(const Vec3& point, std::vector<std::uint32_t>& out) const;

private:
    struct Space {
        Aabb box;
        std::uint32_t firstTriangle = 0, triangleCount = 0;
    };
    [[nodiscard]] bool contains(const Space& space, const Vec3& point) const;

    std::vector<Space> spaces_;
    std::vector<std::array<Vec3, 3>> triangles_;
};

} // namespace limen::visibility
