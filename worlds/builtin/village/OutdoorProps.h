#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Models for yards: on z = 0 around their origin, front to the south.
struct OutdoorProps {
    dat::RecordId fence = 0; ///< 3 m along x, from the origin
    dat::RecordId well = 0, woodpile = 0, signpost = 0, bench = 0, trough = 0, lampPost = 0;
};
[[nodiscard]] OutdoorProps addOutdoorProps(ModelWriter& writer);

} // namespace limen::worlds
