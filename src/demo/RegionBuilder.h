#pragma once

#include "demo/Models.h"
#include "demo/Plants.h"

namespace limen::demo {

/// Adds the Region: heights, calendar, sky, terrain types with their scenes, ground pictures and blend maps;
/// and the Scene records it names.
void addRegion(ModelSink& sink, const Plants& plants);

/// The sky: domes, sun, moon and clouds as GfxObjs, and two day groups, fair and snowy, with keyframes through the day.
[[nodiscard]] dat::SkyDesc buildSky(ModelSink& sink);

} // namespace limen::demo
