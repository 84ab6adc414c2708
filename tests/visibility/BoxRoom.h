#pragma once

#include "visibility/SpaceMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace limen::visibility {

/// A room with the shape of a box, as a closed mesh. A wall with an opening is a frame of four faces around it.
class BoxRoom {
public:
    BoxRoom(const Vec3& low, const Vec3& high) : low_(low), high_(high) {}

    /// Marks a rectangle of a wall as opening `number`. `axis`: of the wall's normal; `isHigh`: the wall at the box's
    /// high end. `from` and `to`: shares of the wall along the axes after `axis`, in cyclic order.
    struct Hole {
        int axis = 0;
        bool isHigh = false;
        std::array<double, 2> from{0.25, 0.25}, to{0.75, 0.75};
        std::uint32_t number = 0;
        bool asTriangles = false;
    };
    void open(const Hole& hole) { holes_.push_back(hole); }

    /// The mesh; valid until the room changes or is moved.
    [[nodiscard]] SpaceMesh mesh();
    /// The corners of a hole, counter-clockwise seen from inside.
    [[nodiscard]] std::vector<Vec3> polygonOf(const Hole& hole) const;

    std::vector<Vec3>
        vertices; ///< of the last `mesh`; a test may damage them and make a SpaceMesh of its own
    std::vector<std::uint32_t> corners;
    std::vector<MeshFace> faces;

private:
    using Quad = std::array<Vec3, 4>;
    [[nodiscard]] Quad rectangle(int axis, bool isHigh, std::array<double, 2> from,
                                 std::array<double, 2> to) const;
    void addFace(std::initializer_list<Vec3> face, std::uint32_t opening);

    Vec3 low_, high_;
    std::vector<Hole> holes_;
};

} // namespace limen::visibility
