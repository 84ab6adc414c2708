#pragma once

#include "geometry/Bounds.h"
#include "visibility/View.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace limen::visibility {

/// The distance of the nearest opaque triangle in each pixel of a picture, rounded up: occlusion culling on the processor
/// (decision 214). A pixel is covered if its centre is, as for a rasteriser.
///
/// Reuse it: steady frames allocate nothing.
class OcclusionBuffer {
public:
    /// Triangles nearer than this count as this far, metres.
    static constexpr double kNearest = 4.0;

    /// Uncovers all pixels. `width`, `height`: pixels, at least 1. `nearPlane`: metres, > 0; clips triangles, but not nearer than 0.1.
    void begin(const View& view, std::uint32_t width, std::uint32_t height, double nearPlane);
    /// Covers the pixels of a mesh. `corners`: eye-relative metres. `triangles`: three indices of corners each, counter-clockwise seen
    /// from the front. A triangle that faces away, or has a corner that is not finite, covers nothing.
    void cover(std::span<const Vec3> corners, std::span<const std::uint32_t> triangles);
    /// Prepares the tests: after all meshes.
    void finish();
    /// Whether no pixel of the picture shows a sphere: covered pixels hide it, with two pixels around it, or it is beside the
    /// picture. Eye-relative metres. False for a sphere that reaches kNearest.
    [[nodiscard]] bool hides(const Sphere& sphere) const;
    /// The same for an axis-aligned box. `half`: half of its extent along each axis.
    [[nodiscard]] bool hidesBox(const Vec3& centre, const Vec3& half) const;

private:
    /// Inverse distance: kOne * kNearest / metres forward, which is linear on the screen. More is nearer; 0: nothing.
    using Inverse = std::int16_t;
    static constexpr double kOne = 32767.0;
    /// A corner: pixels from the lower left corner of the picture, and 1 / metres forward.
    struct Corner {
        double x = 0.0, y = 0.0, inverse = 0.0;
    };
    /// A corner of a mesh.
    struct Place {
        Vec3 onScreen{0.0}; ///< homogeneous, as in View
        Corner corner;      ///< if it is not before the clip plane
        bool isBefore = false;
    };
    /// The plane of a triangle: 1 / metres forward, linear on the screen.
    struct Slope {
        double atOrigin = 0.0, byX = 0.0, byY = 0.0;
        double least = 0.0; ///< of the corners
    };
    /// Pixels, or rows of pixels.
    struct Run {
        std::int32_t first = 0, end = 0;
    };

    [[nodiscard]] Place placeOf(const Vec3& corner) const;
    [[nodiscard]] Corner cornerAt(const Vec3& onScreen) const;
    void cover(const Place& a, const Place& b, const Place& c);
    /// Covers a convex polygon, counter-clockwise.
    void cover(std::span<const Corner> polygon, Slope slope);
    void spanEdge(const Corner& from, const Corner& to);
    void coverRow(std::int32_t row, const Slope& slope);
    /// A box in the picture: screen x and y by forward, -1 to 1, and metres forward to its nearest point.
    struct Extent {
        double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
        double nearest = 0.0;
    };
    [[nodiscard]] bool hides(const Extent& extent) const;
    /// Whether all pixels of a tile within columns and rows are nearer than `least`.
    [[nodiscard]] bool hidesIn(const Run& columns, const Run& rows, Inverse least) const;
    [[nodiscard]] Inverse* rowAt(std::int32_t row) {
        return pixels_.data() + static_cast<std::size_t>(row) * stride_;
    }

    Mat3 screenFromEye_{1.0}; ///< as View's
    double tanHalfX_ = 1.0, tanHalfY_ = 1.0;
    std::int32_t width_ = 0, height_ = 0;
    double halfWidth_ = 0.5, halfHeight_ = 0.5; ///< of the picture, pixels
    double clipPlane_ = 0.0;                    ///< metres forward; triangles are clipped by it
    std::size_t stride_ = 0;                    ///< of a row, with room for a vector beyond its end
    std::vector<Inverse> pixels_;               ///< row by row, the lowest first
    std::int32_t tileColumns_ = 0;
    std::vector<Inverse> tiles_;              ///< the least of each tile's pixels, row by row
    std::vector<std::int32_t> firsts_, ends_; ///< by row: the pixels of the polygon that is being covered
    std::vector<Place> places_;               ///< corners of the mesh that is being covered
};

} // namespace limen::visibility
