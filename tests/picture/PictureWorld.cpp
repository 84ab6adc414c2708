#include "picture/PictureWorld.h"

#include "picture/GateFigures.h"

#include "check/SampledComparison.h"
#include "frame/IdColour.h"
#include "gpu/device/CheckedDevice.h"
#include "gpu/device/DebugOutput.h"
#include "gpu/device/GlDevice.h"
#include "gpu/device/HeadlessContext.h"
#include "gpu/device/NullDevice.h"
#include "world/Loader.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <map>
#include <optional>

#include <gtest/gtest.h>
#include <unistd.h>

namespace limen::test {

namespace {

/// Tests have nobody to hand an error to.
template <class T>
T valueOf(Result<T> result) {
    if (!result) {
        std::cerr << result.error().message() << '\n';
        std::abort();
    }
    return std::move(*result);
}

void require(const Result<void>& result) {
    if (!result) {
        std::cerr << result.error().message() << '\n';
        std::abort();
    }
}

/// One context and device for the whole test program: shaders compile once.
struct Driver {
    gpu::HeadlessContext context = valueOf(gpu::HeadlessContext::create(true));
    gpu::DebugOutput debug;
    std::unique_ptr<gpu::Device> device = valueOf(gpu::GlDevice::create());
};

Driver& driver() {
    static Driver instance;
    return instance;
}

/// The same view at a size that people can look at, 480 pixels wide.
frame::FrameView enlarged(frame::FrameView frame) {
    const std::uint32_t factor = std::max(480 / frame.width, 1u);
    frame.width *= factor;
    frame.height *= factor;
    return frame;
}

} // namespace

struct PictureWorld::Planning {
    gpu::NullDevice device;
    engine::Pipeline pipeline{device};
};

struct PictureWorld::Drawing {
    explicit Drawing(const PictureOptions& options) {
        pipeline.emplace(device, gpu::RendererOptions{.drawing = options.drawing,
                                                      .exactOutlines = options.exactOutlines,
                                                      .culling = options.culling,
                                                      .rootFirst = options.rootFirst,
                                                      .shaderDefines = options.shaderDefines});
    }
    ~Drawing() {
        target.reset();
        pipeline.reset();
        EXPECT_TRUE(device.faults().empty()) << device.faults().front();
    }
    gpu::CheckedDevice device{*driver().device};
    std::optional<engine::Pipeline> pipeline;
    std::optional<gpu::RenderTarget> target;
};

PictureWorld::PictureWorld(TestWorld& world, const Options& options) {
    static int count = 0;
    const auto directory = std::filesystem::temp_directory_path() /
                           ("limen-picture-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    require(world.write(directory));
    load(directory, world.home(), options);
    std::filesystem::remove_all(directory);
}

PictureWorld::PictureWorld(const std::filesystem::path& directory, dat::BlockCoord centre,
                           const Options& options) {
    load(directory, centre, options);
}

PictureWorld::~PictureWorld() = default;

void PictureWorld::load(const std::filesystem::path& directory, dat::BlockCoord centre,
                        const Options& options) {
    const auto archive = valueOf(dat::Archive::open(directory));
    world::World world =
        valueOf(world::loadWorld(archive, centre, {options.radius, options.mergeZones}, options.moving));
    origin_ = {centre.x * world::kBlockSize, centre.y * world::kBlockSize, 0.0};
    options_ = options;
    if (!options.omissions.membership) {
        part_ = valueOf(engine::partOf(std::move(world)));
        return;
    }
    part_ = valueOf(engine::partOf(withoutMembership(world)));
    whole_ = std::make_unique<world::World>(std::move(world));
}

std::string PictureWorld::driverVersion() const {
    return driver().device->capabilities().version;
}

bool PictureWorld::drawsOnProcessor() const {
    return driver().device->capabilities().software;
}

world::SpaceIndex PictureWorld::space(dat::RecordId cellId) const {
    const world::SpaceIndex found = world::findCell(world(), cellId);
    EXPECT_NE(found, world::kNone) << "no such cell";
    return found;
}

frame::FrameView PictureWorld::look(const Vec3& local, double yaw, double pitch,
                                    world::SpaceIndex root) const {
    frame::FrameView frame = frame::makeView(origin_ + local, yaw, pitch, fov, width, height, root);
    frame.exactCutOuts = true;
    return frame;
}

void PictureWorld::floodAndPlan(const frame::FrameView& frame, engine::Pipeline& pipeline) {
    pipeline.state().dynamics = drawnDynamics_;
    pipeline.setGate(frame.gate);
    require(pipeline.flood(frame.view, {.rules = floodRules}));
    pipeline.plan(frame);
}

void PictureWorld::plan(const frame::FrameView& frame, visibility::VisibleSet& visible,
                        frame::FramePlan& plan) {
    if (!planning_) {
        planning_ = std::make_unique<Planning>();
        require(planning_->pipeline.show(std::make_unique<engine::PartPlanner>(part_)));
    }
    floodAndPlan(frame, planning_->pipeline);
    visible = planning_->pipeline.state().visible;
    plan = planning_->pipeline.state().plan;
}

const NaiveTracer& PictureWorld::tracer() const {
    if (!tracer_)
        tracer_ = std::make_unique<NaiveTracer>(world(), dynamics_);
    return *tracer_;
}

void PictureWorld::setDynamics(const motion::DynamicStateInput& input) {
    motion::DynamicStateBuilder(world()).build(input, dynamics_);
    drawnDynamics_ = without(options_.omissions, world(), dynamics_);
    tracer_.reset();
    if (traced_)
        traced_->setDynamics(dynamics_);
}

Picture PictureWorld::shootSampled(const frame::FrameView& frame, gpu::Shading shading) {
    return shoot(frame, {.wantIds = false, .shading = shading}, {.samples = frame::gpu::kSamples});
}

Picture PictureWorld::shoot(const frame::FrameView& frame, const gpu::RenderOptions& options,
                            const gpu::TargetOptions& targetOptions) {
    if (!drawing_) {
        drawing_ = std::make_unique<Drawing>(options_);
        require(drawing_->pipeline->show(std::make_unique<engine::PartPlanner>(part_)));
    }
    auto& target = drawing_->target;
    if (!target || target->width() != frame.width || target->height() != frame.height ||
        target->options() != targetOptions) {
        target.emplace(
            valueOf(gpu::RenderTarget::create(drawing_->device, frame.width, frame.height, targetOptions)));
    }
    Picture picture;
    picture.frame = frame;
    floodAndPlan(frame, *drawing_->pipeline);
    require(drawing_->pipeline->render(*target, options));
    const engine::FrameState& state = drawing_->pipeline->state();
    picture.visible = state.visible;
    if (targetOptions.samples > 0) {
        picture.samples = target->samplePositions();
    } else {
        picture.ids = target->readIds();
        picture.depth = target->readDepth();
    }
    picture.colour = target->readColour();
    if (options.wantLayers)
        picture.layers = target->readLayers();
    picture.counts = state.plan.counts;
    for (const frame::Batch& batch : state.plan.batches) {
        picture.draws += batch.draws;
        picture.isCleared = picture.isCleared || batch.program == frame::Program::Clearing;
    }
    picture.glCalls = drawing_->pipeline->renderer().report().glCalls;
    for (const frame::Stage& stage : state.plan.stages)
        picture.stages.push_back(stage.batchCount);
    EXPECT_TRUE(driver().debug.faults().empty()) << driver().debug.faults().front();
    EXPECT_TRUE(drawing_->device.faults().empty()) << drawing_->device.faults().front();
    return picture;
}

check::Comparison PictureWorld::judge(const Picture& picture, std::size_t mostSecondLooks) {
    if (!traced_) {
        traced_ = std::make_unique<check::TracedWorld>(world());
        traced_->setDynamics(dynamics_);
    }
    const frame::FrameView& frame = picture.frame;
    reference::Camera camera{frame.view.eye,     frame.view.right,    frame.view.up,
                             frame.view.forward, frame.view.tanHalfX, frame.view.tanHalfY,
                             frame.width,        frame.height,        frame.nearPlane};
    camera.root = frame.view.root;
    check::DrawnImages drawn;
    drawn.width = frame.width;
    drawn.height = frame.height;
    drawn.ids = picture.ids;
    if (frame.gate != frame::Gate::Depth) // its depth image has the depths of openings in places
        drawn.depth = picture.depth;
    drawn.depthUnit = frame.nearPlane;
    for (const gpu::LayerSum& layers : picture.layers)
        drawn.layers.push_back({layers.count, layers.hash});
    check::Comparison comparison;
    if (!picture.samples.empty()) {
        check::ViewRetracer retracer(*traced_, camera);
        drawn.colour = picture.colour;
        drawn.samples = picture.samples;
        std::vector<reference::Picture> traced(drawn.samples.size());
        for (std::size_t s = 0; s < traced.size(); ++s) {
            reference::Camera throughSample = camera;
            throughSample.place = Vec2(drawn.samples[s]);
            reference::tracePicture(traced_->scene(), throughSample, 2, traced[s]);
        }
        check::compareSampled(drawn, traced, frame::colourOfId, retracer, comparison);
        return comparison;
    }
    camera.place = frame::gpu::kPixelPlace;
    check::ViewRetracer retracer(*traced_, camera);
    reference::tracePicture(traced_->scene(), camera, 2, tracedPicture_);
    check::compare(drawn, tracedPicture_, retracer, comparison, mostSecondLooks);
    return comparison;
}

void SampledTally::judge(PictureWorld& pictures, const frame::FrameView& frame) {
    const Picture picture = pictures.shootSampled(frame);
    const check::Comparison c = pictures.judge(picture);
    EXPECT_EQ(c.findings(), 0u) << c.count(check::Verdict::EdgeOn) << " of them of hidden polygons";
    pixels += c.verdicts.size();
    slivers += c.count(check::Verdict::Sliver);
    std::map<std::array<std::uint8_t, 3>, std::size_t> colours;
    for (std::size_t i = 0; i < picture.colour.size(); i += 4)
        ++colours[{picture.colour[i], picture.colour[i + 1], picture.colour[i + 2]}];
    mixed += static_cast<std::size_t>(
        std::count_if(colours.begin(), colours.end(), [](const auto& colour) { return colour.second == 1; }));
}

Picture PictureWorld::expectClean(const frame::FrameView& frame, const gpu::RenderOptions& options) {
    if (const std::optional<GateFigures> figures = GateFigures::fromEnvironment()) {
        frame::FrameView measured = frame;
        measured.gate = figures->gate;
        const auto start = std::chrono::steady_clock::now();
        const Picture drawn = shoot(measured, options);
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        const check::Comparison comparison = judge(drawn, figures->secondLooks);
        figures->add(world(), drawn, comparison, time.count());
        if (figures->wantsPair(comparison))
            figures->writePair(shoot(enlarged(frame)), shoot(enlarged(measured)));
        return drawn;
    }
    Picture picture = shoot(frame, options);
    const check::Comparison c = judge(picture);
    const Vec3 eye = frame.view.eye - origin_;
    if (const auto wrong = std::find_if(c.verdicts.begin(), c.verdicts.end(), check::isFinding);
        wrong != c.verdicts.end()) {
        const auto at = static_cast<std::uint32_t>(wrong - c.verdicts.begin());
        const std::uint32_t x = at % frame.width, y = at / frame.width;
        ADD_FAILURE() << c.findings() << " wrong pixels, the first (" << x << ", " << y
                      << "): " << check::kVerdictNames[static_cast<std::size_t>(*wrong)] << ", drawn "
                      << describeId(world(), picture.id(x, y)) << ", traced "
                      << describeId(world(), tracedPicture_.at(static_cast<int>(x), static_cast<int>(y)).id)
                      << "; eye (" << eye.x << ", " << eye.y << ", " << eye.z << "), forward ("
                      << frame.view.forward.x << ", " << frame.view.forward.y << ", " << frame.view.forward.z
                      << "), root " << frame.view.root;
    }
    std::size_t voids = 0;
    for (std::size_t i = 0; i < picture.ids.size(); ++i)
        voids += picture.ids[i] == 0 && c.verdicts[i] != check::Verdict::Unjudged ? 1 : 0;
    EXPECT_EQ(voids, 0u) << "void pixels";
    return picture;
}

} // namespace limen::test
