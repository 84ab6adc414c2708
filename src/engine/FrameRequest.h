#pragma once

#include "engine/SceneState.h"
#include "engine/ViewRequest.h"
#include "reference/Picture.h"
#include "world/World.h"

#include <span>

namespace limen::engine {

/// One frame of a loaded world: a camera and a scene state. Space indices refer to the loaded part. All
/// verbs, benchmarks and tests that draw through a Session use it.
struct FrameRequest {
    Camera camera;
    PixelSize size;
    world::SpaceIndex root = world::kOutside; ///< the space that contains the eye
    bool isRootAmbiguous = false;             ///< several cells contain the eye
    bool isHeld = false; ///< an obstacle keeps the camera closer to the body than its chosen distance
    SceneState scene;
    world::LevelShare levels; ///< of distances of levels of detail, in fast frames without ids
};

/// Resolves a request in a loaded world: finds root and day group, places the eye on the ground, orders the
/// doors. `file` lists all doors of the world. Requires an empty `place`. Errors: NotFound for a root cell, a
/// door or a day group that does not exist, and for an eye on the ground at a point without ground.
[[nodiscard]] Result<FrameRequest> frameRequest(const world::World& world, const world::WorldFile& file,
                                                const ViewRequest& request);

/// The same view, drawn with `percent` per cent of the pixels each way. Levels of detail change as in a view that much farther
/// away. `out` keeps its storage. As scaledSize.
void scaleRequest(const FrameRequest& request, std::uint32_t percent, FrameRequest& out);

/// Options of a frame's output. They do not change its content.
struct FrameOutputs {
    bool exactCutOuts = false; ///< cut-outs tested at mip level 0, nearest texel; for ids and depth
    std::span<const frame::Highlight> highlights{};
};

/// The inputs of the planner and of the dynamic state, made once a frame.
struct FrameInputs {
    frame::FrameView view;
    motion::DynamicStateInput dynamics; ///< refers to the request's door list, which must outlive it
};
[[nodiscard]] FrameInputs frameInputs(const world::World& world, const FrameRequest& request,
                                      const FrameOutputs& outputs = {});
/// Only the input of the dynamic state.
[[nodiscard]] motion::DynamicStateInput dynamicsInput(const world::World& world, const FrameRequest& request);

/// The camera as the reference tracer takes it. Its rays pass through the points at which the rasteriser
/// samples.
[[nodiscard]] reference::Camera tracedCamera(const FrameRequest& request);

} // namespace limen::engine
