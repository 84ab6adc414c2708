#pragma once

#include "dat/Archive.h"
#include "world/Image.h"
#include "world/World.h"

// Single records of a portal file, for export and preview.
namespace limen::world {

/// A world with one GfxObj or Setup in its resting pose, upright, outdoors, at the south-west corner of block
/// (0, 0). Errors: there is no such model, or it has no polygon to draw.
[[nodiscard]] Result<World> loadModel(const dat::Archive& archive, dat::RecordId model);

/// The picture of a RenderSurface, the largest existing one of a SurfaceTexture, or that of a Surface by its
/// decode rules. Errors: no such record, a Surface of one colour, a picture that is missing or cannot be
/// decoded.
[[nodiscard]] Result<Image> loadPicture(const dat::Archive& archive, dat::RecordId id);

} // namespace limen::world
