#pragma once

#include "worlds/builtin/land/PlantPictures.h"
#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Models of plants and stones for Scene records, each on z = 0, with levels of detail.
struct Plants {
    dat::RecordId oak = 0, birch = 0, pine = 0, youngPine = 0, bush = 0, stump = 0;
    dat::RecordId grass = 0, tallGrass = 0, flowers = 0, fern = 0;
    dat::RecordId rock = 0, boulder = 0;
};
/// Sets the picture of Material::FarPlants, too. `pictureOf`: the pictures that the plants are drawn with; `field`: texels
/// across the picture of one plant, at least 8, a multiple of 4. Requires: addMaterials.
[[nodiscard]] Plants addPlants(ModelWriter& writer, const PictureOf& pictureOf, int field);

} // namespace limen::worlds
