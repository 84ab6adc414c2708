#pragma once

#include "world/records/Pose.h"
#include "world/records/Records.h"

namespace limen::world {

/// The way in which a door opens, from its motion table.
struct DoorMotion {
    /// Poses of the Setup's parts in the door's own frame, from shut to open, at equal intervals. At least one: a door
    /// with one pose does not move. All have the same number of parts.
    std::vector<std::vector<Pose>> keys;
    double seconds = 1.0; ///< from shut to open
    bool isStill = true;  ///< shut and open it does not move
};

/// Reads the motion of a Setup. The shut pose is that of the substate Off of the table's default style, the open one that
/// of On; between them are the frames of the link from Off to On. Without a table, or with a table that lacks both, the
/// parts have the Setup's resting pose. Missing records are reported.
[[nodiscard]] DoorMotion doorMotionOf(const dat::Setup& setup, dat::RecordId motionTable, Records& records);

} // namespace limen::world
