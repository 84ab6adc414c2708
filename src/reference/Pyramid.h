#pragma once

#include "reference/Picture.h"
#include "reference/TriangleSet.h"

#include <span>

namespace limen::reference {

/// Neighbouring rays of a picture: up to 8 × 8 pixels that share an eye.
struct Tile {
    static constexpr std::uint32_t kSide = 8, kPixels = kSide * kSide;
    const Camera& camera;
    int left = 0, top = 0; ///< its first pixel; -1 is the border
    [[nodiscard]] Ray ray(std::uint32_t column, std::uint32_t row) const {
        return rayThrough(camera, left + static_cast<double>(column), top + static_cast<double>(row));
    }
};

/// A bit for each pixel of a tile: column + 8 · row.
using PixelMask = std::uint64_t;

/// The rays of a tile together, as boxes, polygons and triangles are tested against all of them at once. Every test errs
/// towards "may be met": what any of the rays in double meets passes for certain, so that no answer depends on it.
class Pyramid {
public:
    /// `origin` is the scene's; the camera's axes must be orthonormal to one part in a million, its
    /// tangents greater than 0.
    Pyramid(const Tile& tile, const Vec3& origin);

    /// Which of four boxes ([0] least, [1] greatest; by axis; by box) the rays may meet, as bits. least[i] is a bound:
    /// no ray meets anything in box i before it.
    [[nodiscard]] int meetsBoxes(const float (&sides)[2][3][4], float (&least)[4]) const;

    /// The rays that may meet a box.
    [[nodiscard]] PixelMask pixelsOf(const Box& box) const;

    /// False if no ray comes within `margin` metres of the points' convex hull.
    [[nodiscard]] bool mayMeet(std::span<const Vec3> points, double margin) const;

    /// What of a tile may meet a triangle's front, and the parameters between which it does.
    struct Cover {
        PixelMask pixels = 0;
        double least = 0.0, most = 0.0;
    };
    [[nodiscard]] Cover coverOf(const Triangle& triangle) const;

private:
    /// A point as the tile sees it: the ray of column i and row j passes through those with x = i · z, y = j · z.
    struct Corner {
        double x, y, z;
        double reach; ///< the sum of the eye's distances along the axes
    };
    [[nodiscard]] Corner cornerOf(const Vec3& p) const;
    /// A function of pixels that is positive inside an edge: atFirst + column · across + row · down.
    struct Edge {
        float atFirst, across, down;
    };
    [[nodiscard]] Edge edgeOf(const Corner& a, const Corner& b) const;

    Vec3 eye_;
    Vec3 column_, row_, forward_; ///< scalar products with them give Corner's x, y, z
    double hand_ = 1.0;           ///< -1 for a camera that sees a mirror image
    double rounding_ = 0.0;       ///< of an edge's values, for corners with a reach of 1 metre
    double blur_ = 0.0;           ///< pixels that a point's place in the tile may be off by
    double slack_ = 0.0;          ///< share of a depth that float arithmetic may be off by
    std::array<Vec3, 4> sides_;   ///< inward normals of the planes around the rays, not of length 1
    std::array<std::array<float, 3>, 5> planes_{}; ///< the sides, and the axis, as boxes are tested
    std::array<float, 3> below_{}, above_{};       ///< around the eye
};

} // namespace limen::reference
