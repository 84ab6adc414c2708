#pragma once

#include "reference/Picture.h"
#include "reference/TriangleSet.h"

#include <span>

namespace limen::reference {

/// Neighbouring rays of a picture: up to 8 × 8 pixels that share an eye.
struct Tile {
    static constexpr std::uint32_t kSide = 8, kPixels = kSide * kSide;
    const Camera& camera;
    int left = 0, top = 0; ///< the first pixel; -1 is the border
    [[nodiscard]] Ray ray(std::uint32_t column, std::uint32_t row) const {
        return rayThrough(camera, left + static_cast<double>(column), top + static_cast<double>(row));
    }
};

/// A bit for each pixel of a tile: column + 8 · row.
using PixelMask = std::uint64_t;

/// The rays of a tile, tested together against boxes, polygons and triangles. Every test errs towards "may be
/// met": anything that one of the rays in double meets passes. So no answer depends on these tests.
class Pyramid {
public:
    /// `origin` is the scene's. The camera's axes must be orthonormal to one part in a million, and its
    /// tangents greater than 0.
    Pyramid(const Tile& tile, const Vec3& origin);

    /// The boxes of four ([0] least, [1] greatest; by axis; by box) that the rays may meet, as bits. No ray
    /// meets anything in box i before the parameter least[i].
    [[nodiscard]] int meetsBoxes(const float (&sides)[2][3][4], float (&least)[4]) const;

    /// The rays that may meet a box.
    [[nodiscard]] PixelMask pixelsOf(const Box& box) const;

    /// False if no ray comes within `margin` metres of the points' convex hull.
    [[nodiscard]] bool mayMeet(std::span<const Vec3> points, double margin) const;

    /// The pixels whose rays may meet a triangle's front, and the bounds of the parameters where they meet
    /// it.
    struct Cover {
        PixelMask pixels = 0;
        double least = 0.0, most = 0.0;
    };
    [[nodiscard]] Cover coverOf(const Triangle& triangle) const;

private:
    /// A point in the tile's coordinates: the ray of column i and row j contains the points with x = i · z, y
    /// = j · z.
    struct Corner {
        double x, y, z;
        double reach; ///< distance from the eye, as the sum over the axes; metres
    };
    [[nodiscard]] Corner cornerOf(const Vec3& p) const;
    /// A function of pixels that is positive inside an edge: atFirst + column · across + row · down.
    struct Edge {
        float atFirst, across, down;
    };
    [[nodiscard]] Edge edgeOf(const Corner& a, const Corner& b) const;

    Vec3 eye_;
    Vec3 column_, row_, forward_; ///< their scalar products with a point are Corner's x, y, z
    double hand_ = 1.0;           ///< -1 for a camera that sees a mirror image
    double rounding_ =
        0.0;             ///< bound of the rounding of an edge's values, for corners with a reach of 1 metre
    double blur_ = 0.0;  ///< bound of the error of a point's place in the tile, pixels
    double slack_ = 0.0; ///< bound of the error of float arithmetic, as a share of a depth
    std::array<Vec3, 4> sides_; ///< inward normals of the planes around the rays, not normalised
    std::array<std::array<float, 3>, 5> planes_{}; ///< the sides and the axis, in float, for the box tests
    std::array<float, 3> below_{}, above_{};       ///< floats below and above the eye, by axis
};

} // namespace limen::reference
