#pragma once

#include "engine/map/PlacesOnMap.h"
#include "output/Picture.h"

namespace limen::output {

/// The map as a picture.
[[nodiscard]] Picture pictureOfMap(const engine::LandscapeMap& map);

/// Draws a dot for each place on the map, and names where they do not overlap. Dungeons are left out.
/// `pixelsPerTexel`: the size of the picture in proportion to the map.
void drawPlaces(Picture& picture, const engine::LandscapeMap& map, std::span<const world::Place> places,
                double pixelsPerTexel = 1.0);

} // namespace limen::output
