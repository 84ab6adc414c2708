#pragma once

#include "output/FrameJson.h"
#include "output/Picture.h"
#include "reference/Picture.h"

#include <string>
#include <vector>

namespace limen::output {

/// A frame traced instead of drawn. Images have row 0 on top.
struct TracedFrame {
    reference::Camera camera;
    reference::Picture picture;

    [[nodiscard]] std::vector<std::uint32_t> ids() const;
    /// Distances along the rays in metres: infinite for sky, NaN for holes.
    [[nodiscard]] std::vector<float> depth() const;
    /// For people: a colour for every id, darker where the surface is seen edge-on. No light, no textures.
    [[nodiscard]] Picture painting() const;
};

/// Traces a frame on as many threads as there are processors.
[[nodiscard]] TracedFrame traceFrame(const reference::Scene& scene, const engine::FrameRequest& eye);

/// frameJson for a traced frame: "cells" are those that rays ended in, "visits" and "stages" are empty, counts and
/// gl_calls 0, times null, "driver" says "reference".
[[nodiscard]] nlohmann::ordered_json tracedJson(const world::World& world, const engine::IdTable& table,
                                                const engine::FrameRequest& eye,
                                                const world::DynamicState& dynamics, const TracedFrame& frame,
                                                const std::string& datOption);

} // namespace limen::output
