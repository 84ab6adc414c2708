#pragma once

#include "core/Error.h"
#include "world/World.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace limen::output {

/// Encodes instances of a world as a binary glTF 2.0 file (.glb) with embedded pictures. `origin` (global,
/// metres) becomes the origin of the file.
/// - Each instance is a node, named by its record, below one root node that turns z up into glTF's y up.
/// - Instances with the same mesh and materials share them in the file.
/// - Opaque, cut-out (mask at 0.5) and blended surfaces keep their kind. Additive surfaces become blended,
///   because glTF has no additive mode.
/// - Terrain is left out, because the renderer mixes its textures at run time.
///
/// Errors: NotFound, if no instance is left.
[[nodiscard]] Result<std::string>
encodeGlb(const world::World& world, std::span<const world::InstanceIndex> instances, const Vec3& origin);

} // namespace limen::output
