#pragma once

#include "worlds/records/WorldRecords.h"

namespace limen::worlds {

/// Adds the records of addMaterials with pictures of kSmallPicture² texels, which are quick to paint.
void addSmallMaterials(WorldRecords& records);
inline constexpr int kSmallPicture = 32;

} // namespace limen::worlds
