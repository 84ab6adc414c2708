#pragma once

#include "worlds/builtin/land/Plants.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Adds the Region (heights, calendar, sky, terrain types with their scenes, ground pictures, blend maps) and
/// its Scenes.
void addRegion(ModelWriter& writer, const Plants& plants);

/// The sky: domes, sun, moon and clouds as GfxObjs, and two day groups, fair and snowy, with keyframes
/// through the day.
[[nodiscard]] dat::SkyDesc buildSky(ModelWriter& writer);

} // namespace limen::worlds
