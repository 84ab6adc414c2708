#pragma once

#include "dat/Archive.h"
#include "world/Image.h"
#include "world/World.h"

// Single records of a portal file, as they would look in a world.
namespace limen::world {

/// A world that holds nothing but a GfxObj or a Setup, in its resting pose, at the corner of block (0, 0) and upright; outdoors. Errors:
/// no such model; one that has nothing to show.
[[nodiscard]] Result<World> loadModel(const dat::Archive& archive, dat::RecordId model);

/// The picture of a RenderSurface; of a SurfaceTexture, the largest that is there; of a Surface, read as the surface says. Errors: no such
/// record; a Surface of one colour; a picture that is missing or cannot be decoded.
[[nodiscard]] Result<Image> loadPicture(const dat::Archive& archive, dat::RecordId id);

} // namespace limen::world
