#pragma once

#include "core/Error.h"
#include "world/World.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace limen::output {

/// Parts of a world as a binary glTF 2.0 file (.glb), pictures embedded: a node for each instance, named by its record, under one
/// root that turns z up into glTF's y up. `origin`, global, becomes the file's. Instances that share a mesh and its materials share them
/// in the file. Opaque, cut-out (mask at 0.5) and blended surfaces keep their kind; additive ones become blended, for glTF
/// has none. Terrain is left out: its ground is mixed by the renderer. Errors: nothing is left to write.
[[nodiscard]] Result<std::string>
encodeGlb(const world::World& world, std::span<const world::InstanceIndex> instances, const Vec3& origin);

} // namespace limen::output
