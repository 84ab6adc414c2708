#pragma once

#include "frame/Clusters.h"

#include <span>
#include <vector>

namespace limen::frame {

/// The static instances outside that can hide others: land and the exteriors of buildings, with the corners and triangles of
/// their opaque parts; and the boxes of all static instances. A property of the world.
class OccluderShapes {
public:
    OccluderShapes(const world::World& world, const Clusters& clusters);

    struct Occluder {
        world::InstanceIndex instance = world::kNone;
        std::uint32_t shape = 0;
    };
    /// The opaque part of a mesh.
    struct Shape {
        std::vector<Vec3f> corners;           ///< each once; in the space of the mesh's vertices
        std::vector<std::uint32_t> triangles; ///< three indices of corners each
    };
    /// Axis-aligned, global.
    struct Box {
        Vec3 centre{0.0}, half{0.0};
    };

    [[nodiscard]] std::span<const Occluder> occluders() const {
        return occluders_;
    } ///< in the order of the space's list
    [[nodiscard]] const Shape& shape(std::uint32_t number) const { return shapes_[number]; }
    /// Contains the static instance at a position of Clusters::order.
    [[nodiscard]] Box box(std::uint32_t position) const {
        const StoredBox& box = boxes_[position];
        return {origin_ + Vec3(box.centre), Vec3(box.half)};
    }

private:
    /// In floats, relative to origin_.
    struct StoredBox {
        Vec3f centre{0.0f}, half{0.0f};
    };
    void addOccluders(const world::World& world);
    void addBoxes(const world::World& world, const Clusters& clusters);

    std::vector<Occluder> occluders_;
    std::vector<Shape> shapes_;
    std::vector<StoredBox> boxes_; ///< by position
    Vec3 origin_{0.0};
};

} // namespace limen::frame
