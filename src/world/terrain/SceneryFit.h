#pragma once

#include "world/records/Records.h"

namespace limen::world {

/// Whether an object at a block-local place is within the block, as scenery must be. Its scale does not count.
/// The shape that is tested: the sorting sphere of an object with a physics mesh; else the circle of each cylinder;
/// else, of an object with spheres, the sorting sphere; else its origin. docs/formats/landscape.md#scenery.
[[nodiscard]] bool isWithinBlock(dat::RecordId model, const Vec3& origin, const Quat& orientation,
                                 Records& records);

} // namespace limen::world
