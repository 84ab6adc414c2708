#pragma once

#include "plain/MeshParts.h"

#include <map>
#include <osg/Geode>
#include <osg/Group>
#include <osg/Texture2D>

namespace limen::bench {

/// Builds a scene graph from a loaded world: a transform for each instance, in groups of 24 m squares that
/// are culled as a whole; a node that is passed at some distances only where an instance has levels of detail; a geometry for each mesh and
/// surface, which instances share. Terrain has its base texture alone. The world must outlive the builder.
class OsgScene {
public:
    /// `origin`: global, of the graph's coordinates.
    OsgScene(const world::World& world, const Vec3& origin) : world_(world), origin_(origin) {}

    /// A graph of instances; their meshes, textures and states are shared with those of earlier calls.
    [[nodiscard]] osg::ref_ptr<osg::Group> graphOf(const std::vector<world::Instance>& instances);

    [[nodiscard]] const Vec3& origin() const { return origin_; }

private:
    [[nodiscard]] osg::ref_ptr<osg::Node> nodeOf(const world::Instance& instance);
    [[nodiscard]] osg::ref_ptr<osg::Geode> geodeOf(const world::Instance& instance);
    [[nodiscard]] osg::ref_ptr<osg::StateSet> stateOf(const PlainSurface& surface);
    [[nodiscard]] osg::ref_ptr<osg::Texture2D> textureOf(const PlainSurface& surface);

    const world::World& world_;
    Vec3 origin_;
    std::map<PartsKey, osg::ref_ptr<osg::Geode>> geodes_;
    std::vector<std::pair<PlainSurface, osg::ref_ptr<osg::StateSet>>> states_;
    std::map<std::pair<std::uint32_t, bool>, osg::ref_ptr<osg::Texture2D>> textures_; ///< and if clamped
};

/// Number of triangles that the graph shows to an eye (global) without frustum culling.
[[nodiscard]] std::size_t trianglesIn(osg::Node& graph, const Vec3& origin, const Vec3& eye);

} // namespace limen::bench
