#include "gpu/device/Device.h"

#include <algorithm>
#include <utility>

namespace limen::gpu {

WorkGroups WorkGroups::atLeast(std::uint32_t count, std::uint32_t layers) {
    const std::uint32_t rows = std::max((count + kMostGroups - 1) / kMostGroups, 1u);
    return {(count + rows - 1) / rows, rows, layers};
}

StateTracker::Changes StateTracker::apply(const DrawState& next) {
    const Changes changes{next.program != current_.program, next.cullBackFaces != current_.cullBackFaces,
                          next.writeDepth != current_.writeDepth, next.depthTest != current_.depthTest,
                          next.clips != current_.clips};
    current_ = next;
    return changes;
}

bool StateTracker::setCulling(bool backFaces) {
    cullsBetween_ = backFaces;
    return std::exchange(current_.cullBackFaces, backFaces) != backFaces;
}

bool StateTracker::enableDepthWrite() {
    return !std::exchange(current_.writeDepth, true);
}

bool StateTracker::setViewport(const Viewport& viewport) {
    return std::exchange(viewport_, viewport) != viewport;
}

bool StateTracker::setClearColour(const glm::vec4& colour) {
    return std::exchange(clearColour_, colour) != colour;
}

StateTracker::Changes StateTracker::reset() {
    return apply({.program = current_.program, .cullBackFaces = cullsBetween_});
}

DrawState StateTracker::with(ProgramHandle program) const {
    DrawState state{.program = program};
    state.clips = current_.clips; // a compute program has no clip distances: eight calls are saved
    return state;
}

} // namespace limen::gpu
