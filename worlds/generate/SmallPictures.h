#pragma once

#include "worlds/builtin/land/Plants.h"

namespace limen::worlds {

/// Adds the records of addMaterials with pictures of kSmallPicture² texels, which are quick to paint.
void addSmallMaterials(WorldRecords& records);
inline constexpr int kSmallPicture = 32;

/// Plants drawn with such pictures.
[[nodiscard]] Plants addSmallPlants(ModelWriter& writer);

/// The materials and plants of a generated world: painted if it is furnished, else small.
void addGeneratedMaterials(WorldRecords& records, bool furnished);
[[nodiscard]] Plants addGeneratedPlants(ModelWriter& writer, bool furnished);

} // namespace limen::worlds
