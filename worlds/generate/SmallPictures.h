#pragma once

#include "worlds/builtin/land/Plants.h"

namespace limen::worlds {

/// Adds the records of addMaterials with pictures of kSmallPicture² texels, which are quick to paint.
void addSmallMaterials(WorldRecords& records);
inline constexpr int kSmallPicture = 32;

/// Plants drawn with such pictures.
[[nodiscard]] Plants addSmallPlants(ModelWriter& writer);

} // namespace limen::worlds
