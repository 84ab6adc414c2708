#pragma once

#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// Adds the records of addMaterials, with pictures that are quick to paint: all of kSmallPicture² texels.
void addSmallMaterials(WorldRecords& records);
inline constexpr int kSmallPicture = 32;

} // namespace limen::worlds
