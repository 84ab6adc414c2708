#pragma once

#include "engine/SceneState.h"
#include "engine/ViewRequest.h"
#include "reference/Picture.h"
#include "world/World.h"

#include <span>

namespace limen::engine {

/// One frame of a loaded world: a camera and a scene state. Every verb, benchmark and test that draws makes one of these.
struct FrameRequest {
    Camera camera;
    PixelSize size;
    world::SpaceIndex root = world::kOutside; ///< the space that the eye is in
    bool isRootAmbiguous = false;             ///< several cells contain the eye
    bool isHeld = false; ///< an obstacle keeps the camera closer to the body than its chosen distance
    SceneState scene;
};

/// A request's frame in a loaded world. `file` names the doors. Errors: a root cell, a door or a day group that is not there;
/// no ground below an eye that is to stand on it.
[[nodiscard]] Result<FrameRequest> frameRequest(const world::World& world, const world::WorldFile& file,
                                                const ViewRequest& request);

/// Options of one drawn frame that belong to its output, not to its content.
struct FrameOutputs {
    bool exactCutOuts = false; ///< cut-outs at mip 0, nearest texel: for ids and depth
    std::span<const frame::Highlight> highlights{};
};

/// A frame in the terms of planner and dynamic state. Made once a frame.
struct FrameInputs {
    frame::FrameView view;
    motion::DynamicStateInput dynamics; ///< refers to the request's door list
};
[[nodiscard]] FrameInputs frameInputs(const world::World& world, const FrameRequest& request,
                                      const FrameOutputs& outputs = {});
/// The dynamic state's part alone.
[[nodiscard]] motion::DynamicStateInput dynamicsInput(const world::World& world, const FrameRequest& request);

/// The camera as the reference tracer takes it. Its rays pass where the rasteriser samples.
[[nodiscard]] reference::Camera tracedCamera(const FrameRequest& request);

} // namespace limen::engine
