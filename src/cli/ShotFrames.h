#pragma once

#include "cli/Console.h"
#include "cli/ShotRequest.h"
#include "engine/Session.h"

// The frames of `limen shot` and their files.
namespace limen::cli {

/// The frame of a view in a loaded part. Notes a root that was chosen among several. Errors: as
/// engine::frameRequest.
[[nodiscard]] Result<engine::FrameRequest> requestOf(const engine::LoadedPart& part,
                                                     const world::WorldFile& file,
                                                     const engine::ViewRequest& view, const Console& console);

/// Draws a view and writes its outputs. `supersample`: samples along a pixel's side. Requires a loaded part.
/// Errors: as requestOf; the renderer's; an output cannot be written.
[[nodiscard]] Result<void> shoot(engine::Session& session, const ListedView& listed,
                                 std::uint32_t supersample, const Console& console);

} // namespace limen::cli
