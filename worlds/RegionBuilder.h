#pragma once

#include "worlds/Models.h"
#include "worlds/Plants.h"

namespace limen::worlds {

/// Adds the Region: heights, calendar, sky, terrain types with their scenes, ground pictures and blend maps;
/// and the Scene records it names.
void addRegion(ModelSink& sink, const Plants& plants);

/// The sky: domes, sun, moon and clouds as GfxObjs, and two day groups, fair and snowy, with keyframes through the day.
[[nodiscard]] dat::SkyDesc buildSky(ModelSink& sink);

} // namespace limen::worlds
