#pragma once

#include "frame/FrameView.h"
#include "visibility/VisibleSet.h"
#include "world/DynamicState.h"
#include "world/World.h"

#include <cstdint>
#include <string>
#include <vector>

namespace limen::bench {

/// Many small objects outdoors.
struct FieldSpec {
    std::uint32_t objects = 10'000;
    std::uint32_t groups =
        1662;                 ///< meshes, at most as many as objects; each with a texture of its own choice
    double side = 400.0;      ///< metres, of the square they stand on
    double movingShare = 0.0; ///< of the objects, 0..1
    std::uint32_t seed = 1;
};

/// A world in memory, as a loader would yield it: flat ground of whole landblocks with a square of boxes in the middle, and
/// no cells. A group is a box of 12 triangles; its size, and where its objects stand, follow from hashes of their numbers.
/// The boxes float 2 cm above the ground and never touch: no pixel depends on the order in which they are drawn. An object
/// has the same ids whether it moves or not.
struct ObjectField {
    world::World world;
    world::DynamicState dynamics; ///< the objects that move; empty if none does
    Vec3 eye{0.0};                ///< global; in the middle, higher than the boxes
    std::vector<Vec3> homes;      ///< by Moment::instances: what they move around, block-local

    /// Puts what moves where it is in a frame: up to 5 cm from its home. Allocates nothing.
    void moveTo(std::uint32_t frame);
};

/// Requires 0 < groups <= objects, and 1.8 m of the square's side for each of the square root of `objects`: room for the boxes.
[[nodiscard]] ObjectField makeField(const FieldSpec& spec);

/// A view from a field's eye with what it sees: one visit, the outside.
struct FieldView {
    frame::FrameView frame;
    visibility::VisibleSet visible;
};

/// `count` headings, evenly around, level, 75 degrees high.
[[nodiscard]] std::vector<FieldView> fieldViews(const ObjectField& field, std::uint32_t count,
                                                std::uint32_t width, std::uint32_t height);

} // namespace limen::bench
