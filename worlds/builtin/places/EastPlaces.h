#pragma once

#include "worlds/builtin/places/Places.h"
#include "worlds/builtin/places/Tour.h"

namespace limen::worlds {

/// Places in and around the inn and the meeting hall.
[[nodiscard]] std::vector<std::pair<std::string, Eye>> eastPlaces(const VillageMap& map);

/// The tour's second part: from the cottage's rear room to the inn, up to its balcony, down to its basement,
/// then through the meeting hall and out onto the lane.
[[nodiscard]] std::vector<TourLeg> eastTour(const VillageMap& map);

} // namespace limen::worlds
