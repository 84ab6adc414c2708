#include "peer/Peer.h"
#include "peer/osg/OsgScene.h"

#include "geometry/Tolerances.h"
#include "gpu/device/HeadlessContext.h"
#include "plain/GlTarget.h"

#include <optional>
#include <osg/CullFace>
#include <osg/GL>
#include <osgUtil/Optimizer>
#include <osgViewer/Viewer>

namespace limen::bench {

namespace {

constexpr double kPeerNearPlane = kNearestPlace; // metres: it has no reversed depth
constexpr double kFarPlane = 4000.0;             // metres
constexpr int kWarmUpFrames = 2;                 // they upload textures and buffers

osg::Vec3d toOsg(const Vec3& v) {
    return {v.x, v.y, v.z};
}

osg::Vec4 toOsg(const Vec3f& v) {
    return {v.x, v.y, v.z, 1.0f};
}

class OsgWay final : public FrameWay {
public:
    OsgWay(gpu::HeadlessContext context, std::uint32_t width, std::uint32_t height)
        : FrameWay(kPeerWay), context_(std::move(context)), target_(width, height) {
        const int w = static_cast<int>(width), h = static_cast<int>(height);
        viewer_.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        const osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window =
            viewer_.setUpViewerAsEmbeddedInWindow(0, 0, w, h);
        window->setDefaultFboId(target_.framebuffer());
        osg::Camera& camera = *viewer_.getCamera();
        camera.setClearColor({0.5f, 0.7f, 0.9f, 1.0f});
        camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        camera.setDrawBuffer(GL_COLOR_ATTACHMENT0_EXT);
        camera.setReadBuffer(GL_COLOR_ATTACHMENT0_EXT);
    }
    ~OsgWay() override {
        static_cast<void>(enter());
        viewer_.setSceneData(nullptr);
    }

    [[nodiscard]] Result<void> enter() override { return context_.makeCurrent(); }
    [[nodiscard]] Result<void> show(const FramePlace& place) override;
    [[nodiscard]] Result<void> draw() override;
    [[nodiscard]] FramePicture read() override;

private:
    void setLight(const FramePlace& place);
    void setCamera(const frame::FrameView& view);

    gpu::HeadlessContext context_;
    GlTarget target_;
    osgViewer::Viewer viewer_;
    std::shared_ptr<const engine::LoadedPart> part_; ///< that `scene_` is of
    std::optional<OsgScene> scene_;
    osg::ref_ptr<osg::Group> standing_; ///< the static instances of `part_`
    double depthUnit_ = 0.0;            ///< the near plane of the frame over that of the peer
};

Result<void> OsgWay::show(const FramePlace& place) {
    if (part_ != place.part) {
        part_ = place.part;
        scene_.emplace(part_->world, originNear(place.view.view.eye));
        standing_ = scene_->graphOf(part_->world.instances);
        osgUtil::Optimizer().optimize(standing_, osgUtil::Optimizer::SHARE_DUPLICATE_STATE |
                                                     osgUtil::Optimizer::VERTEX_POSTTRANSFORM);
    }
    const osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(standing_);
    root->addChild(scene_->graphOf(place.dynamics.instances));
    osg::StateSet& state = *root->getOrCreateStateSet();
    state.setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    state.setMode(GL_LIGHTING, osg::StateAttribute::ON);
    state.setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    setLight(place);
    setCamera(place.view);
    viewer_.setSceneData(root);
    for (int i = 0; i < kWarmUpFrames; ++i)
        if (Result<void> drawn = draw(); !drawn)
            return drawn;
    return {};
}

void OsgWay::setLight(const FramePlace& place) {
    const PlainLight light = plainLightOf(place.part->world, place.view);
    viewer_.setLightingMode(osg::View::SKY_LIGHT);
    viewer_.getLight()->setPosition({light.towards.x, light.towards.y, light.towards.z, 0.0f});
    viewer_.getLight()->setDiffuse(toOsg(light.sun));
    viewer_.getLight()->setAmbient(toOsg(light.ambient));
    viewer_.getLight()->setSpecular({0.0f, 0.0f, 0.0f, 1.0f});
}

void OsgWay::setCamera(const frame::FrameView& view) {
    const Vec3 eye = view.view.eye - scene_->origin();
    depthUnit_ = view.nearPlane / kPeerNearPlane;
    const double x = view.view.tanHalfX * kPeerNearPlane, y = view.view.tanHalfY * kPeerNearPlane;
    viewer_.getCamera()->setProjectionMatrixAsFrustum(-x, x, -y, y, kPeerNearPlane, kFarPlane);
    viewer_.getCamera()->setViewMatrixAsLookAt(toOsg(eye), toOsg(eye + view.view.forward),
                                               toOsg(view.view.up));
}

Result<void> OsgWay::draw() {
    target_.bind(); // the viewer binds no framebuffer of its own
    viewer_.frame();
    glFinish();
    return {};
}

FramePicture OsgWay::read() {
    FramePicture picture{target_.width(), target_.height(), target_.readColour(), target_.readDepth()};
    const double share = (kFarPlane - kPeerNearPlane) / kFarPlane;
    for (float& depth : picture.depth) // 1 at the far plane, where nothing was drawn
        depth = depth < 1.0f ? static_cast<float>((1.0 - depth * share) * depthUnit_) : 0.0f;
    return picture;
}

} // namespace

Result<std::unique_ptr<FrameWay>> makePeerWay(std::uint32_t width, std::uint32_t height) {
    Result<gpu::HeadlessContext> context =
        gpu::HeadlessContext::create(false, gpu::ContextProfile::Compatibility);
    if (!context)
        return Failure(context.error());
    return std::make_unique<OsgWay>(std::move(*context), width, height);
}

} // namespace limen::bench
