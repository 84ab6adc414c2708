#pragma once

#include "frames/FrameWay.h"
#include "plain/MeshParts.h"

#include <map>

namespace limen::bench {

/// One draw call of a model: a part of its mesh.
struct PlainDraw {
    PlainSurface surface;
    std::uint32_t firstIndex = 0, indexCount = 0;
    std::uint32_t model = 0;
};

/// A run of an array.
struct PlainRun {
    std::uint32_t first = 0, count = 0;
};

/// An instance of a model.
struct PlainObject {
    world::Instance instance;
    glm::mat4 placement{1.0f}; ///< to metres about PlainScene::origin
    std::uint32_t model = 0;
};

/// Everything that a place can show, in the form of a plain forward renderer: one arena of vertices, draws
/// ordered by surface, and objects with a placement.
struct PlainScene {
    Vec3 origin{0.0}; ///< global
    std::vector<PlainVertex> vertices;
    std::vector<std::uint32_t> indices; ///< into `vertices`
    std::vector<PlainDraw> solid;       ///< of all models: opaque before cut-out, then by texture
    std::vector<PlainDraw> blended;     ///< by model
    std::vector<PlainRun> blendedOf;    ///< by model
    std::vector<PlainObject> objects;
};

/// The scene of a place, static and dynamic instances.
[[nodiscard]] PlainScene plainSceneOf(const FramePlace& place);

/// The draws of one frame: the visible objects at the eye's levels of detail. Reused, so that steady frames
/// allocate nothing.
struct PlainSelection {
    /// A part of an object that is blended.
    struct Blended {
        std::uint32_t draw = 0; ///< index into PlainScene::blended
        std::uint32_t instance = 0;
        double distance = 0.0; ///< of the eye from the middle of the object's bounds
    };
    std::vector<glm::mat4> placements;  ///< by model
    std::vector<PlainRun> ofModel;      ///< by model: runs of `placements`
    std::vector<Blended> blended;       ///< back to front
    std::vector<std::uint32_t> visible; ///< indices of PlainScene::objects
};
void selectPlain(const world::World& world, const PlainScene& scene, const visibility::View& view,
                 PlainSelection& selection);

/// Number of triangles of the draws.
[[nodiscard]] std::size_t trianglesOf(const PlainScene& scene, const PlainSelection& selection);

} // namespace limen::bench
