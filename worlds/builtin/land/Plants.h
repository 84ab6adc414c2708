#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Models of plants and stones for Scene records, each on z = 0.
struct Plants {
    dat::RecordId oak = 0, birch = 0, pine = 0, youngPine = 0, bush = 0, stump = 0;
    dat::RecordId grass = 0, tallGrass = 0, flowers = 0, fern = 0;
    dat::RecordId rock = 0, boulder = 0;
};
[[nodiscard]] Plants addPlants(ModelWriter& writer);

} // namespace limen::worlds
