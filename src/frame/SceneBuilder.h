#pragma once

#include "frame/ResidentPieces.h"
#include "frame/SceneUpload.h"
#include "world/World.h"

namespace limen::frame {

/// The world's static content in the GPU's layout. Instance, material and light set numbers are the world's;
/// members are per zone: a run in `members` for each instance, its zones without repeats, the zone it is
/// placed in first, each with the light of the first of its spaces that lies in that zone (frame/PackInstance.h).
[[nodiscard]] SceneUpload buildScene(const world::World& world);
/// The same, where the world's pieces are there already (Planner::pieces).
[[nodiscard]] SceneUpload buildScene(const world::World& world, const ResidentPieces& pieces);

} // namespace limen::frame
