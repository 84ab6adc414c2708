#pragma once

#include "frame/SceneUpload.h"
#include "gpu/scene/Programs.h"
#include "gpu/texture/TextureStaging.h"

#include <memory>
#include <optional>

namespace limen::gpu {

/// What is on a device, as far as it matters to the scene that comes next.
struct SceneState {
    std::vector<TextureContent> textures;
    std::optional<SceneBindings> bindings; ///< that the programs are built for; none: there is no scene
};

/// A scene made ready to be uploaded piece by piece. Plain data, made by any thread.
struct StagedScene {
    /// Without textures. Whoever keeps it, too, decides on which thread all that memory is given back.
    std::shared_ptr<const frame::SceneUpload> arrays;
    StagedTextures textures;
    SceneBindings bindings;
};

/// Checks a scene and does all that needs no device. `before`: of the renderer that it is for; what that has is not staged again.
/// Errors: BadArgument for indices that lead nowhere; what stageTextures reports.
[[nodiscard]] Result<StagedScene> stageScene(frame::SceneUpload scene, const TextureStoreOptions& options,
                                             const Capabilities& capabilities, const SceneState& before);

} // namespace limen::gpu
