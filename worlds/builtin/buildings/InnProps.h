#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// Models that only the inn has. They stand on z = 0 with their front to the south, unless the comment says
/// otherwise.
struct InnProps {
    dat::RecordId bar = 0; ///< 3.6 m long in x, guests to the south
    dat::RecordId roundTable = 0;
    dat::RecordId breast = 0; ///< chimney breast above the hall's fireplace, 0.3 m high; back to the north
    dat::RecordId upperBreast = 0;
    dat::RecordId stairs = 0; ///< flight of stairs with a platform: origin at its head, down to the south
    dat::RecordId rack = 0;   ///< two rows of casks; back to the north
    dat::RecordId post = 0;   ///< of the hall, with braces; 2.8 m
};
[[nodiscard]] InnProps addInnProps(ModelWriter& writer);

/// Adds the balcony over the front door, its posts and the sign to the exterior.
void addBalcony(FaceMesh& mesh, double ground);

} // namespace limen::worlds
