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
    std::uint32_t groups = 1662; ///< meshes, at most as many as objects; each has one of 32 textures
    double side = 400.0;         ///< side of the objects' square in metres
    double movingShare = 0.0;    ///< share of dynamic objects, 0..1
    std::uint32_t seed = 1;
};

/// A world in memory, in the form that the loader gives: flat ground of whole landblocks, a square of boxes
/// in the middle, no cells. A group is a box mesh of 12 triangles. Hashes determine its size and the
/// positions of its objects. The boxes float 2 cm above the ground and never touch, so no pixel depends on
/// the order of drawing. An object has the same ids whether it is static or dynamic.
struct ObjectField {
    world::World world;
    world::DynamicState dynamics; ///< the dynamic objects
    Vec3 eye{0.0};                ///< global; in the middle, above all boxes
    std::vector<Vec3> homes;      ///< by DynamicState::instances: the centres of their movement, block-local

    /// Moves the dynamic objects to their positions in a frame, up to 5 cm from their homes. Allocates
    /// nothing.
    void moveTo(std::uint32_t frame);
};

/// Requires 0 < groups <= objects, and side >= 1.8 m * sqrt(objects), so that the boxes have room.
[[nodiscard]] ObjectField makeField(const FieldSpec& spec);

/// A view from a field's eye, and its visible set: one visit, the outside.
struct FieldView {
    frame::FrameView frame;
    visibility::VisibleSet visible;
};

/// `count` level views in evenly spaced headings, 75 degrees high.
[[nodiscard]] std::vector<FieldView> fieldViews(const ObjectField& field, std::uint32_t count,
                                                std::uint32_t width, std::uint32_t height);

} // namespace limen::bench
