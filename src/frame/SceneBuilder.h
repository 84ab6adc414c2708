#pragma once

#include "frame/SceneUpload.h"
#include "frame/StaticScene.h"

namespace limen::frame {

/// The static content of a scene's world in the GPU's layout. Instances, materials and light sets keep the
/// world's numbers. The result may outlive the scene; its textures are views into the world.
[[nodiscard]] SceneUpload buildScene(const StaticScene& scene);

} // namespace limen::frame
