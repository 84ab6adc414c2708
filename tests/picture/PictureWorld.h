#pragma once

#include "picture/Naming.h"
#include "picture/Omissions.h"
#include "support/TestWorld.h"

#include "check/Comparison.h"
#include "check/Traced.h"
#include "engine/Pipeline.h"
#include "gpu/RenderOptions.h"
#include "gpu/RendererOptions.h"
#include "world/MovingEntries.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace limen::test {

/// One drawn frame. Images have row 0 on top.
struct Picture {
    frame::FrameView frame;
    std::vector<std::uint32_t> ids;
    std::vector<float> depth;          ///< as in the depth buffer: near / w, 0 at infinity
    std::vector<std::uint8_t> colour;  ///< R,G,B,A
    std::vector<gpu::LayerSum> layers; ///< where asked for
    std::vector<glm::vec2> samples;    ///< of a multisampled one: from the pixel's centre, y downwards
    visibility::VisibleSet visible;
    frame::PlanCounts counts;
    std::uint32_t glCalls = 0, draws = 0;
    bool isCleared = false;            ///< its plan was made with FrameView::rootFirst
    std::vector<std::uint32_t> stages; ///< numbers of batches, by stage

    [[nodiscard]] std::uint32_t id(std::uint32_t x, std::uint32_t y) const {
        return ids[y * frame.width + x];
    }
};

struct PictureOptions {
    bool mergeZones = true;
    int radius = 1;
    world::MovingEntries moving{};
    std::vector<std::string> shaderDefines{}; ///< gpu::RendererOptions
    gpu::Drawing drawing = gpu::Drawing::Exact;
    bool rootFirst = true;                       ///< gpu::RendererOptions
    bool exactOutlines = true;                   ///< gpu::RendererOptions
    gpu::Culling culling = gpu::Culling::Hidden; ///< gpu::RendererOptions
    Omissions omissions{};                       ///< of the drawn world; the traced one stays whole
};

/// A world loaded from dats and drawn through the path that every command uses: load, flood, plan, render.
/// Tests of this folder need an OpenGL driver.
class PictureWorld {
public:
    using Options = PictureOptions;
    /// Writes the world to a temporary directory and loads it around its home block.
    explicit PictureWorld(TestWorld& world, const Options& options = {});
    PictureWorld(const std::filesystem::path& directory, dat::BlockCoord centre, const Options& options = {});
    ~PictureWorld();

    [[nodiscard]] const world::World& world() const { return whole_ ? *whole_ : part_->world; }
    /// The ray rule done the obvious way; made on first use.
    [[nodiscard]] const NaiveTracer& tracer() const;
    [[nodiscard]] world::SpaceIndex space(dat::RecordId cellId) const;
    [[nodiscard]] Vec3 homeOrigin() const { return origin_; }

    /// A view from a position local to the home block.
    [[nodiscard]] frame::FrameView look(const Vec3& local, double yaw, double pitch,
                                        world::SpaceIndex root) const;
    [[nodiscard]] Picture shoot(const frame::FrameView& frame, const gpu::RenderOptions& options = {}) {
        return shoot(frame, options, {.layers = options.wantLayers, .samples = 0});
    }
    /// Flat colours, with several samples a pixel: no ids and no depth.
    [[nodiscard]] Picture shootSampled(const frame::FrameView& frame,
                                       gpu::Shading shading = gpu::Shading::FlatIds);
    /// Sets the dynamic state. Before, nothing moves and nothing is shut.
    void setDynamics(const motion::DynamicStateInput& input);
    /// Only up to the plan: no driver.
    void plan(const frame::FrameView& frame, visibility::VisibleSet& visible, frame::FramePlan& plan);

    /// Holds a picture against the reference: the same judgement as `limen check`, of one by shootSampled that with --msaa.
    [[nodiscard]] check::Comparison judge(const Picture& picture,
                                          std::size_t mostSecondLooks = check::kMostSecondLooks);
    /// The driver's own text for its version, e.g. "4.5 (Core Profile) Mesa 22.3.6".
    [[nodiscard]] std::string driverVersion() const;
    [[nodiscard]] bool drawsOnProcessor() const; ///< gpu::Capabilities::software
    /// Draws and judges, layers too where they are counted; a finding or a void pixel fails the test.
    Picture expectClean(const frame::FrameView& frame, const gpu::RenderOptions& options = {});

    std::uint32_t width = 96, height = 64; ///< of the views that `look` makes
    double fov = 75.0;
    visibility::Rules floodRules; ///< for tests that leave one out

private:
    Picture shoot(const frame::FrameView& frame, const gpu::RenderOptions& options,
                  const gpu::TargetOptions& targetOptions);
    void load(const std::filesystem::path& directory, dat::BlockCoord centre, const Options& options);
    std::shared_ptr<const engine::LoadedPart> part_; ///< drawn
    std::unique_ptr<world::World> whole_;            ///< with omissions: the world that the reference sees
    Vec3 origin_{0.0};
    world::DynamicState dynamics_, drawnDynamics_;
    Options options_;
    mutable std::unique_ptr<NaiveTracer> tracer_;
    std::unique_ptr<check::TracedWorld> traced_;
    reference::Picture tracedPicture_;
    void floodAndPlan(const frame::FrameView& frame, engine::Pipeline& pipeline);
    struct Planning;
    std::unique_ptr<Planning> planning_; ///< without a driver
    struct Drawing;
    std::unique_ptr<Drawing> drawing_;
};

/// Multisampled pictures, each judged; a finding fails the test.
struct SampledTally {
    std::size_t pixels = 0, slivers = 0;
    std::size_t mixed = 0; ///< colours that a single pixel of a picture has: means of several ids
    void judge(PictureWorld& pictures, const frame::FrameView& frame);
};

} // namespace limen::test
