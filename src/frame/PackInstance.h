#pragma once

#include "frame/GpuLayout.h"
#include "world/World.h"

#include <span>
#include <vector>

namespace limen::frame {

/// An instance in the GPU's layout. Its zones are appended to `zones`, each once, the zone it is placed in first,
/// with the light of the first of its spaces that lies in that zone. `members` is the array that the instance's
/// member run is in (the world's or a moment's); `firstMember` is set relative to the start of `zones`.
[[nodiscard]] gpu::Instance packInstance(const world::World& world, const world::Instance& instance,
                                         std::span<const world::SpaceIndex> members,
                                         std::vector<gpu::Member>& zones);

} // namespace limen::frame
