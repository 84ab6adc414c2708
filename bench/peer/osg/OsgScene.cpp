#include "peer/osg/OsgScene.h"

#include "world/LevelRange.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <osg/AlphaFunc>
#include <osg/BlendFunc>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>

namespace limen::bench {

namespace {

constexpr double kSquare = 24.0; // metres, side of the groups that are culled as a whole
constexpr float kCutOutAlpha = 0.5f;

osg::Vec4 toOsg(const Vec4f& v) {
    return {v.x, v.y, v.z, v.w};
}

osg::Matrix toOsg(const glm::mat4& m) {
    // Both have the columns of the other's rows: OSG multiplies row vectors.
    return osg::Matrix(&m[0].x);
}

osg::ref_ptr<osg::Geometry> geometryOf(const MeshPart& part) {
    const osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array, normals = new osg::Vec3Array;
    const osg::ref_ptr<osg::Vec2Array> uvs = new osg::Vec2Array;
    for (const PlainVertex& v : part.vertices) {
        positions->push_back({v.position.x, v.position.y, v.position.z});
        normals->push_back({v.normal.x, v.normal.y, v.normal.z});
        uvs->push_back({v.uv.x, v.uv.y});
    }
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(positions);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, uvs);
    geometry->addPrimitiveSet(
        new osg::DrawElementsUInt(GL_TRIANGLES, part.indices.begin(), part.indices.end()));
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    return geometry;
}

/// Counts triangles where an eye's levels of detail lead.
class TriangleCounter final : public osg::NodeVisitor {
public:
    explicit TriangleCounter(const osg::Vec3& eye)
        : osg::NodeVisitor(osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN), eye_(eye) {}

    osg::Vec3 getEyePoint() const override { return eye_; }
    void apply(osg::Geometry& geometry) override {
        for (unsigned i = 0; i < geometry.getNumPrimitiveSets(); ++i)
            indices += geometry.getPrimitiveSet(i)->getNumIndices();
    }
    std::size_t indices = 0;

private:
    osg::Vec3 eye_;
};

/// An instance that is drawn at some distances only.
class LevelNode final : public osg::Group {
public:
    LevelNode(const world::World& world, const world::Instance& instance, const Vec3& origin)
        : world_(world), instance_(instance), origin_(origin) {}

    void traverse(osg::NodeVisitor& visitor) override {
        const osg::Vec3 eye = visitor.getEyePoint();
        const Vec3 at = origin_ + Vec3(eye.x(), eye.y(), eye.z());
        if (visitor.getTraversalMode() != osg::NodeVisitor::TRAVERSE_ACTIVE_CHILDREN ||
            world::isInLevelRange(world_, instance_, world::rangeStepsOf(at)))
            osg::Group::traverse(visitor);
    }

private:
    const world::World& world_;
    const world::Instance instance_;
    const Vec3 origin_;
};

} // namespace

osg::ref_ptr<osg::Texture2D> OsgScene::textureOf(const PlainSurface& surface) {
    osg::ref_ptr<osg::Texture2D>& texture = textures_[{surface.texture, surface.isClamped}];
    if (texture)
        return texture;
    const world::Image& picture = *world_.textures[surface.texture];
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(static_cast<int>(picture.width), static_cast<int>(picture.height), 1, GL_RGBA,
                         GL_UNSIGNED_BYTE);
    std::memcpy(image->data(), picture.rgba.data(), picture.rgba.size());
    texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    const osg::Texture::WrapMode wrap =
        surface.isClamped ? osg::Texture::CLAMP_TO_EDGE : osg::Texture::REPEAT;
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

osg::ref_ptr<osg::StateSet> OsgScene::stateOf(const PlainSurface& surface) {
    const auto known = std::find_if(states_.begin(), states_.end(),
                                    [&](const auto& entry) { return entry.first == surface; });
    if (known != states_.end())
        return known->second;
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setDiffuse(osg::Material::FRONT_AND_BACK, toOsg(surface.colour));
    material->setAmbient(osg::Material::FRONT_AND_BACK, toOsg(surface.colour));
    state->setAttributeAndModes(material);
    if (surface.texture != world::kNone)
        state->setTextureAttributeAndModes(0, textureOf(surface));
    if (surface.surfaceClass == world::SurfaceClass::CutOut)
        state->setAttributeAndModes(new osg::AlphaFunc(osg::AlphaFunc::GEQUAL, kCutOutAlpha));
    if (surface.surfaceClass == world::SurfaceClass::Blended) {
        const GLenum source = surface.isInvAlpha ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_ALPHA;
        const GLenum beneath = surface.isInvAlpha ? GL_SRC_ALPHA : GL_ONE_MINUS_SRC_ALPHA;
        state->setAttributeAndModes(
            new osg::BlendFunc(source, surface.isAdditive ? GLenum{GL_ONE} : beneath));
        state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    states_.emplace_back(surface, state);
    return state;
}

osg::ref_ptr<osg::Geode> OsgScene::geodeOf(const world::Instance& instance) {
    osg::ref_ptr<osg::Geode>& geode = geodes_[partsKeyOf(instance)];
    if (geode)
        return geode;
    geode = new osg::Geode;
    for (const MeshPart& part : partsOf(world_, instance)) {
        const osg::ref_ptr<osg::Geometry> geometry = geometryOf(part);
        geometry->setStateSet(stateOf(part.surface));
        geode->addDrawable(geometry);
    }
    return geode;
}

osg::ref_ptr<osg::Node> OsgScene::nodeOf(const world::Instance& instance) {
    const osg::Matrix placement = toOsg(placementOf(world_, instance, origin_));
    const osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(placement);
    node->setDataVariance(osg::Object::STATIC);
    node->addChild(geodeOf(instance));
    if (instance.level == world::kNone)
        return node;
    const osg::ref_ptr<osg::Node> level = new LevelNode(world_, instance, origin_);
    level->asGroup()->addChild(node);
    return level;
}

osg::ref_ptr<osg::Group> OsgScene::graphOf(const std::vector<world::Instance>& instances) {
    osg::ref_ptr<osg::Group> root = new osg::Group;
    std::map<std::pair<int, int>, osg::ref_ptr<osg::Group>> squares;
    for (const world::Instance& instance : instances) {
        if (instance.mesh == world::kNone)
            continue;
        osg::ref_ptr<osg::Group>& square =
            squares[{static_cast<int>(std::floor(instance.bounds.centre.x / kSquare)),
                     static_cast<int>(std::floor(instance.bounds.centre.y / kSquare))}];
        if (!square) {
            square = new osg::Group;
            root->addChild(square);
        }
        square->addChild(nodeOf(instance));
    }
    return root;
}

std::size_t trianglesIn(osg::Node& graph, const Vec3& origin, const Vec3& eye) {
    const Vec3 at = eye - origin;
    TriangleCounter counter(
        osg::Vec3(static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)));
    graph.accept(counter);
    return counter.indices / 3;
}

} // namespace limen::bench
