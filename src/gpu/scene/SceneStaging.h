#pragma once

#include "frame/DrawRecords.h"
#include "frame/SceneUpload.h"
#include "gpu/scene/BlendMapParts.h"
#include "gpu/scene/Programs.h"
#include "gpu/texture/TextureStaging.h"

#include <memory>
#include <optional>

namespace limen::gpu {

/// State of a device that the staging of the next scene depends on.
struct SceneState {
    std::vector<TextureContent> textures;
    std::optional<SceneBindings> bindings; ///< of the current programs; none without a scene
};

/// A scene ready for a sliced upload. Plain data, made by any thread.
struct StagedScene {
    /// Without textures. The last owner of this pointer frees the memory, on its own thread.
    std::shared_ptr<const frame::SceneUpload> arrays;
    /// Of Drawing::Fast, else empty.
    std::shared_ptr<const std::vector<std::uint32_t>> sharedIndices;
    frame::RecordTables tables;
    bool packsTerrain = false;         ///< the shaders read PackedCell
    std::vector<ShownParts> blendMaps; ///< partsOfMaps(), if they do
    StagedTextures textures;
    SceneBindings bindings;
};

/// Checks a scene and prepares it as far as possible without a device. `before`: of the renderer that will
/// draw it; shared content is not staged again. Errors: BadArgument for invalid indices; errors of
/// stageTextures.
[[nodiscard]] Result<StagedScene> stageScene(frame::SceneUpload scene, const RendererOptions& options,
                                             const Capabilities& capabilities, const SceneState& before);

} // namespace limen::gpu
