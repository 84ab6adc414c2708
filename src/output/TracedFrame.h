#pragma once

#include "output/FrameJson.h"
#include "output/Picture.h"
#include "reference/Picture.h"

#include <string>
#include <vector>

namespace limen::output {

/// A frame that was traced instead of drawn. Row 0 of its images is the top.
struct TracedFrame {
    reference::Camera camera;
    reference::Picture picture;

    [[nodiscard]] std::vector<std::uint32_t> ids() const;
    /// Distances along the rays in metres; infinity for sky, NaN for holes.
    [[nodiscard]] std::vector<float> depth() const;
    /// A picture with a colour for each id, darker where the surface is seen edge-on. It has no lighting and
    /// no textures.
    [[nodiscard]] Picture painting() const;
};

/// Traces a frame with one thread a processor.
[[nodiscard]] TracedFrame traceFrame(const reference::Scene& scene, const engine::FrameRequest& request);

/// frameJson for a traced frame. "cells" lists the cells that rays ended in. "visits" and "stages" are empty,
/// counts and gl_calls are 0, times are null, and "driver" is "reference".
[[nodiscard]] nlohmann::ordered_json tracedJson(const world::World& world, const engine::IdTable& table,
                                                const engine::FrameRequest& request,
                                                const world::DynamicState& dynamics, const TracedFrame& frame,
                                                const std::string& datOption);

} // namespace limen::output
