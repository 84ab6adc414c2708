#include "visibility/BoxRoom.h"

namespace limen::visibility {

BoxRoom::Quad BoxRoom::rectangle(int axis, bool isHigh, std::array<double, 2> from,
                                 std::array<double, 2> to) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](double atU, double atV) {
        Vec3 place;
        place[axis] = isHigh ? high_[axis] : low_[axis];
        place[u] = low_[u] + (high_[u] - low_[u]) * atU;
        place[v] = low_[v] + (high_[v] - low_[v]) * atV;
        return place;
    };
    Quad quad{corner(from[0], from[1]), corner(to[0], from[1]), corner(to[0], to[1]), corner(from[0], to[1])};
    if (isHigh) // counter-clockwise as seen from inside, where the normal points
        std::swap(quad[1], quad[3]);
    return quad;
}

std::vector<Vec3> BoxRoom::polygonOf(const Hole& hole) const {
    const Quad quad = rectangle(hole.axis, hole.isHigh, hole.from, hole.to);
    return {quad.begin(), quad.end()};
}

void BoxRoom::addFace(std::initializer_list<Vec3> face, std::uint32_t opening) {
    faces.push_back(
        {static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(face.size()), opening});
    for (const Vec3& corner : face) {
        corners.push_back(static_cast<std::uint32_t>(vertices.size()));
        vertices.push_back(corner);
    }
}

SpaceMesh BoxRoom::mesh() {
    vertices.clear();
    corners.clear();
    faces.clear();
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) {
            const Quad wall = rectangle(axis, isHigh, {0.0, 0.0}, {1.0, 1.0});
            const Hole* hole = nullptr;
            for (const Hole& known : holes_)
                if (known.axis == axis && known.isHigh == isHigh)
                    hole = &known;
            if (hole == nullptr) {
                addFace({wall[0], wall[1], wall[2], wall[3]}, kNone);
                continue;
            }
            const Quad inner = rectangle(axis, isHigh, hole->from, hole->to);
            for (std::size_t i = 0; i < 4; ++i)
                addFace({wall[i], wall[(i + 1) % 4], inner[(i + 1) % 4], inner[i]}, kNone);
            if (hole->asTriangles) {
                addFace({inner[0], inner[1], inner[2]}, hole->number);
                addFace({inner[0], inner[2], inner[3]}, hole->number);
            } else {
                addFace({inner[0], inner[1], inner[2], inner[3]}, hole->number);
            }
        }
    }
    return {vertices, corners, faces};
}

} // namespace limen::visibility
