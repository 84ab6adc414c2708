#pragma once

#include "worlds/records/FaceMesh.h"

namespace limen::worlds {

/// A thatched gable roof with overhanging eaves, its ridge along x. The walls are from x = -halfWidth to
/// halfWidth and y = 0 to depth, and end at z = top.
struct RoofSpec {
    double halfWidth = 6.0, depth = 10.0, top = 2.75, pitch = 1.0;
};
void addThatchedRoof(FaceMesh& mesh, const RoofSpec& roof);

/// A stone chimney with a cap and a pot, from inside the roof at `foot` up to `top` (metres, of the cap).
void addChimney(FaceMesh& mesh, const Vec3& foot, double top);

} // namespace limen::worlds
