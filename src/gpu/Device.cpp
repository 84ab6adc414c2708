#include "gpu/Device.h"

#include <utility>

namespace limen::gpu {

StateTracker::Changes StateTracker::apply(const DrawState& next) {
    const Changes changes{next.program != current_.program, next.cullBackFaces != current_.cullBackFaces,
                          next.writeDepth != current_.writeDepth};
    current_ = next;
    return changes;
}

bool StateTracker::enableDepthWrite() {
    return !std::exchange(current_.writeDepth, true);
}

bool StateTracker::disableCulling() {
    return std::exchange(current_.cullBackFaces, false);
}

} // namespace limen::gpu
