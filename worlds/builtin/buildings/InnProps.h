#pragma once

#include "worlds/records/ModelWriter.h"

namespace limen::worlds {

/// What only the inn has. All stand on z = 0, their front to the south, unless said otherwise.
struct InnProps {
    dat::RecordId bar = 0; ///< 3.6 m long in x, guests to the south
    dat::RecordId roundTable = 0;
    dat::RecordId breast = 0; ///< of the chimney above the hall's fireplace, 0.3 m high; back to the north
    dat::RecordId upperBreast = 0;
    dat::RecordId stairs =
        0;                  ///< the flight up with its platform: origin at the head of the flight, runs south
    dat::RecordId rack = 0; ///< two rows of casks; back to the north
    dat::RecordId post = 0; ///< of the hall, with braces; 2.8 m
};
[[nodiscard]] InnProps addInnProps(ModelWriter& sink);

/// The balcony over the front door, its posts and the sign; a part of the exterior.
void addBalcony(FaceMesh& mesh, double ground);

} // namespace limen::worlds
