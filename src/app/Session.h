#pragma once

#include "app/DynamicStateInput.h"
#include "app/FrameReport.h"
#include "app/Picked.h"
#include "app/Quality.h"
#include "app/Residency.h"
#include "app/Streamer.h"
#include "app/WorldSource.h"
#include "frame/Planner.h"
#include "gpu/CheckedDevice.h"
#include "gpu/GlDevice.h"
#include "gpu/HeadlessContext.h"
#include "gpu/Renderer.h"
#include "motion/DynamicStateBuilder.h"
#include "visibility/Flood.h"
#include "world/LoadCache.h"
#include "world/Loader.h"

#include <memory>

namespace CLI {
class App;
}

namespace limen::app {

/// How a world is loaded and drawn, whatever the verb.
struct SessionOptions {
    std::string dat; ///< directory; empty: the built-in world
    world::LoadOptions load;
    gpu::TextureMode textures = gpu::TextureMode::Auto;
    gpu::Culling culling = gpu::Culling::Hidden;
    std::uint32_t samples = 0; ///< a pixel, of frames without ids and layers; 0 and 1: no multisampling
    float anisotropy = 4.0f;   ///< of textures, at most
    std::optional<std::size_t> quality{}; ///< of kQualities, that was chosen last
};
void addSessionOptions(CLI::App& command, SessionOptions& options);

/// A part of a world in memory, ready to be flooded and planned. Never moves: the planner refers to it.
class LoadedWorld {
    /// What never changes.
    struct Contents {
        Contents(world::World loaded, visibility::Graph made, const StreamTarget& asked)
            : world(std::move(loaded)), graph(std::move(made)), ids(world), target(asked) {}
        const world::World world;
        const visibility::Graph graph;
        const IdTable ids; ///< refers to world
        const StreamTarget target;
    };

public:
    /// Errors: the loader's; portals that the graph refuses.
    [[nodiscard]] static Result<std::unique_ptr<LoadedWorld>>
    load(const dat::Archive& archive, dat::BlockCoord centre, const world::LoadOptions& options,
         const world::MovingEntries& moving = {}, const world::LoadHelp& help = {});
    /// The same part, to be planned by another thread.
    explicit LoadedWorld(const LoadedWorld& other) : LoadedWorld(other.contents_) {}
    LoadedWorld& operator=(const LoadedWorld&) = delete;

private:
    explicit LoadedWorld(std::shared_ptr<const Contents> contents)
        : contents_(std::move(contents)), world(contents_->world), graph(contents_->graph),
          ids(contents_->ids), target(contents_->target), centre(target.centre), scene(world), planner(scene),
          dynamicsBuilder(world) {}
    const std::shared_ptr<const Contents> contents_; // first: the others refer to it

public:
    const world::World& world;
    const visibility::Graph& graph;
    const IdTable& ids;
    const StreamTarget& target; ///< what it was asked for
    const dat::BlockCoord& centre;
    const frame::StaticScene scene;
    frame::Planner planner;
    motion::DynamicStateBuilder dynamicsBuilder;
};

/// The block that an eye in the cell `cell` (0: outside) is to have around it. Over a dungeon's block, which has no landscape, it is the
/// one that was: the land is seen from there, and the dungeon is not.
[[nodiscard]] dat::BlockCoord blockAround(const dat::Archive& archive, const LoadedWorld& before,
                                          dat::RecordId cell, const Vec3& eye);

/// The space, in a part of the world that is shown now, that an eye is in which was in the cell `cell` (0: outside) before.
[[nodiscard]] world::SpaceIndex rootIn(const LoadedWorld& loaded, dat::RecordId cell, const Vec3& eye);

/// Eye, root and height of the ground of a standpoint, found in a loaded world. Errors: a root cell that is
/// not there; no ground where the eye is to stand on it.
[[nodiscard]] Result<FrameEye> placeEye(const LoadedWorld& loaded, const Viewpoint& stand, PixelSize size);

/// Gives an eye what a view says of time, weather, doors and the player's body. Errors: a door that the world file does not name; a kind of day or
/// a cell that is not there.
[[nodiscard]] Result<void> applyDynamics(const LoadedWorld& loaded, const world::WorldFile& file,
                                         const ViewRequest& view, FrameEye& eye);

/// What the renderer is asked to draw of a frame.
struct DrawOptions {
    bool ids = false;                         ///< write the id image, cut-outs tested exactly
    gpu::Shading shading = gpu::Shading::Lit; ///< of FlatIds, with --msaa: the mean of the samples' colours
    bool layers = false; ///< count the layers of translucent surfaces instead of painting them
    std::span<const frame::Highlight> highlights{};
};

/// One world on one graphics device: archive, loaded part, flood, plan, renderer. Every verb that draws goes
/// through here. The device must outlive it.
class Session final : public Residency {
public:
    Session(std::shared_ptr<const WorldSource> source, const SessionOptions& options, gpu::Device& device);
    ~Session() override;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Loads and uploads the blocks around `centre` unless they are there already. On an error the world that
    /// was there stays.
    [[nodiscard]] Result<void> load(dat::BlockCoord centre);
    /// The two halves of it. Reads the blocks around `centre`; any thread may, whatever else the session does.
    [[nodiscard]] Result<std::shared_ptr<LoadedWorld>> read(dat::BlockCoord centre) const {
        return read({centre, options_.load});
    }
    [[nodiscard]] Result<std::shared_ptr<LoadedWorld>> read(const StreamTarget& target,
                                                            unsigned threads = 1) const;
    /// Uploads what was read; it is drawn from now on. On an error the world that was there stays.
    [[nodiscard]] Result<void> show(std::shared_ptr<LoadedWorld> world);
    /// What is loaded is drawn from now on, of which the renderer has just shown the scene. Yields what was drawn before.
    [[nodiscard]] std::shared_ptr<LoadedWorld> take(std::shared_ptr<LoadedWorld> world);
    /// How parts of the world are loaded from now on.
    void loadBy(const world::LoadOptions& load) { options_.load = load; }
    /// Index into kQualities. Samples change with the next frame, all else with the next part of the world that is loaded: where the
    /// session loads by itself, with the next frame, too.
    void drawBy(std::size_t quality);
    /// Loads the blocks around a moving eye when it comes near the edge of what is loaded; `root` is
    /// translated. True if something was loaded. Where nothing can be loaded the old world stays.
    bool follow(const Vec3& eye, world::SpaceIndex& root, Walk* walk) override;
    /// Loads it at once.
    [[nodiscard]] Passage open(dat::BlockCoord centre) override;
    /// Floods, plans and draws one frame. Requires a loaded world.
    [[nodiscard]] Result<void> draw(const FrameEye& eye, const DrawOptions& options);
    /// What a pixel (from the upper left corner) shows. Draws a frame of ids for it: draw the one to show again. Requires a
    /// loaded world.
    [[nodiscard]] Result<Picked> pick(const FrameEye& eye, std::uint32_t x, std::uint32_t y);

    /// What a flood decides at each portal it comes to, with the doors as the last frame had them. Requires a frame that was drawn.
    void tracePortals(const FrameEye& eye, visibility::FloodTrace& trace);

    [[nodiscard]] const WorldSource& source() const { return *source_; }
    [[nodiscard]] const std::shared_ptr<const WorldSource>& shareSource() const { return source_; }
    [[nodiscard]] const SessionOptions& options() const { return options_; }
    [[nodiscard]] const LoadedWorld& loaded() const { return *loaded_; }
    /// The same, for who needs it longer than until the next load.
    [[nodiscard]] std::shared_ptr<const LoadedWorld> shareLoaded() const { return loaded_; }
    [[nodiscard]] bool isLoaded() const { return loaded_ != nullptr; }
    [[nodiscard]] gpu::Renderer& renderer() { return renderer_; }
    [[nodiscard]] const gpu::Renderer& renderer() const { return renderer_; }
    [[nodiscard]] const gpu::Capabilities& capabilities() const { return device_.capabilities(); }
    /// The last frame.
    [[nodiscard]] const visibility::VisibleSet& visible() const { return visible_; }
    [[nodiscard]] const frame::FramePlan& plan() const { return plan_; }
    [[nodiscard]] const world::DynamicState& dynamics() const { return dynamics_; }
    [[nodiscard]] const gpu::RenderTarget& target() const { return *shown_; }
    [[nodiscard]] FrameFigures figures() const;
    /// The driver in one line.
    [[nodiscard]] std::string driver() const;

private:
    [[nodiscard]] gpu::Device& drawnOn();
    /// Makes the target that such a frame is drawn into fit, and yields it.
    [[nodiscard]] Result<gpu::RenderTarget*> fitTarget(PixelSize size, const DrawOptions& options);

    std::shared_ptr<const WorldSource> source_;
    SessionOptions options_;
    const std::shared_ptr<world::LoadCache> cache_ = std::make_shared<world::LoadCache>();
    gpu::Device& device_;
    std::optional<gpu::CheckedDevice> checked_; ///< in development builds
    gpu::Renderer renderer_;
    std::optional<gpu::RenderTarget> target_, sampledTarget_; ///< one sample a pixel, and several
    gpu::RenderTarget* shown_ = nullptr;                      ///< that of the last frame
    std::shared_ptr<LoadedWorld> loaded_;
    visibility::FloodScratch scratch_;
    world::DynamicState dynamics_;
    visibility::VisibleSet visible_;
    frame::FramePlan plan_;
    double floodMs_ = 0.0, planMs_ = 0.0;
};

/// A session that draws without a window.
struct HeadlessSession {
    std::unique_ptr<gpu::HeadlessContext> context;
    std::unique_ptr<gpu::GlDevice> device;
    std::unique_ptr<Session> session; ///< goes first
    HeadlessSession() = default;
    HeadlessSession(HeadlessSession&&) noexcept = default;
    HeadlessSession& operator=(HeadlessSession&&) noexcept = default;
};
/// Errors: Driver; the world's.
[[nodiscard]] Result<HeadlessSession> openHeadless(std::shared_ptr<const WorldSource> source,
                                                   const SessionOptions& options);

/// What a person should know of a world's data, in one line; empty if there is nothing.
[[nodiscard]] std::string findingsLine(const world::World& world);

} // namespace limen::app
