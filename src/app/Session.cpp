#include "app/Session.h"

#include "app/DayGroup.h"
#include "core/Assert.h"
#include "frame/SceneBuilder.h"
#include "frame/WorldGraph.h"
#include "motion/Collisions.h"
#include "motion/Locate.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace limen::app {
namespace {

/// Milliseconds since it was made.
class Stopwatch {
public:
    [[nodiscard]] double ms() const {
        return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

#ifdef LIMEN_DEVELOPMENT
constexpr bool kIsDevelopment = true;
#else
constexpr bool kIsDevelopment = false;
#endif

/// Blocks that an eye may go from the loaded centre before the next part is loaded, as a share of the radius.
int leashOf(int radius) {
    return std::max(1, radius / 2);
}

void choose(std::size_t quality, SessionOptions& options) {
    options.quality = quality;
    options.load = loadBy(kQualities[quality], options.load);
    options.samples = kQualities[quality].samples;
    options.anisotropy = kQualities[quality].anisotropy;
}

Result<world::SpaceIndex> findRoot(const world::World& world, const RootChoice& root, const Vec3& eye,
                                   bool& ambiguous) {
    if (root.kind == RootChoice::Kind::Outside)
        return world::kOutside;
    if (root.kind == RootChoice::Kind::Auto) {
        const motion::Located located = motion::locate(world, eye);
        ambiguous = located.ambiguous;
        return located.space;
    }
    const world::SpaceIndex cell = world::findCell(world, root.cell);
    if (cell == world::kNone)
        return fail(ErrorCode::NotFound, "--root",
                    fmt::format("there is no cell {} in this world", hexId(root.cell)));
    return cell;
}

frame::FrameView frameView(const FrameEye& eye, const DrawOptions& options) {
    frame::FrameView view;
    view.view = viewOf(eye.camera, eye.size, eye.root);
    view.width = eye.size.width;
    view.height = eye.size.height;
    view.dayGroup = eye.dayGroup;
    view.timeOfDay = eye.time;
    view.seconds = eye.seconds;
    view.weather = eye.weather;
    view.highlights = options.highlights;
    view.exactCutOuts = options.ids || options.shading != gpu::Shading::Lit;
    return view;
}

} // namespace

void addSessionOptions(CLI::App& command, SessionOptions& options) {
    command // first: what else is said comes after it
        .add_option_function<std::string>(
            "--quality", [&options](const std::string& text) { choose(*qualityNamed(text), options); },
            "sets --radius, --far, --detail and --msaa, and how sharp textures are seen askew")
        ->type_name("low|medium|high|ultra")
        ->check(CLI::IsMember({"low", "medium", "high", "ultra"}))
        ->group("World");
    command
        .add_option("--dat", options.dat,
                    "directory of client_portal.dat and client_cell_1.dat; the built-in world unless said")
        ->type_name("DIR")
        ->group("World")
        ->check(
            [](const std::string& text) { return std::string(text.empty() ? "names no directory" : ""); });
    command
        .add_option_function<std::string>(
            "--zones", [&options](const std::string& text) { options.load.mergeZones = text == "merged"; },
            "merged: cells that cannot hide each other share a zone (default); cells: every cell its own; "
            "the picture is the same")
        ->type_name("merged|cells")
        ->check(CLI::IsMember({"merged", "cells"}))
        ->group("World");
    command
        .add_option("--radius", options.load.radius, "landblocks that are loaded each way around the eye (4)")
        ->type_name("N")
        ->check(CLI::Range(0, 16))
        ->group("World");
    command
        .add_option("--far", options.load.farRadius,
                    "landblocks beyond these up to so many each way have their ground alone (0: none)")
        ->type_name("N")
        ->check(CLI::Range(0, 32))
        ->group("World");
    command
        .add_option("--detail", options.load.detail,
                    "levels of detail change at so many times their distances (1); inf: the nearest stays")
        ->type_name("F")
        ->check(CLI::Range(0.01, std::numeric_limits<double>::infinity()))
        ->group("World");
    command
        .add_option_function<std::string>(
            "--textures",
            [&options](const std::string& text) {
                options.textures = text == "bindless" ? gpu::TextureMode::Bindless
                                   : text == "pages"  ? gpu::TextureMode::ArrayPages
                                                      : gpu::TextureMode::Auto;
            },
            "how textures are bound (auto: bindless where the driver has it)")
        ->type_name("auto|bindless|pages")
        ->check(CLI::IsMember({"auto", "bindless", "pages"}))
        ->group("World");
    command
        .add_option_function<std::string>(
            "--culling",
            [&options](const std::string& text) {
                options.culling = text == "none"     ? gpu::Culling::None
                                  : text == "unseen" ? gpu::Culling::Unseen
                                                     : gpu::Culling::Hidden;
            },
            "triangles that are left out before they are drawn: none, those without a pixel, those behind "
            "walls and ground, too "
            "(hidden); pictures are the same")
        ->type_name("none|unseen|hidden")
        ->check(CLI::IsMember({"none", "unseen", "hidden"}))
        ->group("World");
    command
        .add_option("--msaa", options.samples, "samples a pixel; ids and depth always have one (default: 1)")
        ->type_name("1|4")
        ->check(CLI::IsMember({0, 1, 4}))
        ->group("World");
}

Result<std::unique_ptr<LoadedWorld>> LoadedWorld::load(const dat::Archive& archive, dat::BlockCoord centre,
                                                       const world::LoadOptions& options,
                                                       const world::MovingEntries& moving,
                                                       const world::LoadHelp& help) {
    Result<world::World> world = world::loadWorld(archive, centre, options, moving, help);
    if (!world)
        return tl::unexpected(world.error());
    Result<visibility::Graph> graph = frame::visibilityGraph(*world);
    if (!graph)
        return tl::unexpected(graph.error());
    return std::unique_ptr<LoadedWorld>(new LoadedWorld(std::make_shared<const Contents>(
        std::move(*world), std::move(*graph), StreamTarget{centre, options})));
}

dat::BlockCoord blockAround(const dat::Archive& archive, const LoadedWorld& before, dat::RecordId cell,
                            const Vec3& eye) {
    if (cell != 0)
        return dat::blockOf(cell);
    const dat::BlockCoord below = world::blockAt(eye);
    return below == before.centre || !world::isDungeon(archive, below) ? below : before.centre;
}

world::SpaceIndex rootIn(const LoadedWorld& loaded, dat::RecordId cell, const Vec3& eye) {
    const world::SpaceIndex root = cell == 0 ? world::kOutside : world::findCell(loaded.world, cell);
    return root != world::kNone
               ? root
               : motion::locate(loaded.world, eye).space; // its block is damaged or was left out: look again
}

Result<FrameEye> placeEye(const LoadedWorld& loaded, const Viewpoint& stand, PixelSize size) {
    FrameEye eye;
    eye.camera = stand.camera;
    eye.size = size;
    eye.player = stand.player;
    if (stand.onGround) {
        const double ground = world::terrainHeight(loaded.world, stand.camera.eye.x, stand.camera.eye.y);
        if (!std::isfinite(ground))
            return fail(ErrorCode::NotFound, "--at",
                        "there is no ground at these map coordinates in this world");
        eye.camera.eye.z = ground + kEyeHeight;
        if (eye.player == stand.camera.eye)
            eye.player = eye.camera.eye;
    }
    const Result<world::SpaceIndex> root =
        findRoot(loaded.world, stand.root, eye.camera.eye, eye.rootAmbiguous);
    if (!root)
        return tl::unexpected(root.error());
    eye.root = *root;
    return eye;
}

namespace {

/// By World::doors. Doors of other parts of the world are left out.
Result<std::vector<double>> eachDoor(const world::World& world, const world::WorldFile& file,
                                     std::span<const check::View::DoorState> states) {
    std::vector<double> open;
    for (const world::Door& door : world.doors)
        open.push_back(door.open);
    for (const check::View::DoorState& state : states) {
        const auto isIt = [&](const auto& door) { return door.name == state.name; };
        if (std::none_of(file.moving.doors.begin(), file.moving.doors.end(), isIt))
            return fail(ErrorCode::NotFound, "--door",
                        "this world's world.json names no door '" + state.name + "'");
        const auto found = std::find_if(world.doors.begin(), world.doors.end(), isIt);
        if (found != world.doors.end())
            open[static_cast<std::size_t>(found - world.doors.begin())] = state.open;
    }
    return open;
}

} // namespace

Result<void> applyDynamics(const LoadedWorld& loaded, const world::WorldFile& file, const ViewRequest& view,
                           FrameEye& eye) {
    eye.time = view.time;
    Result<std::uint32_t> day = dayGroupOf(loaded.world.sky.desc, view.day);
    if (!day)
        return tl::unexpected(day.error());
    eye.dayGroup = *day;
    eye.weather = view.weather;
    eye.seconds = view.seconds;
    eye.doors = view.doors;
    if (!view.eachDoor.empty()) {
        Result<std::vector<double>> doors = eachDoor(loaded.world, file, view.eachDoor);
        if (!doors)
            return tl::unexpected(doors.error());
        eye.eachDoor = std::move(*doors);
    }
    if (!view.body)
        return {};
    bool ambiguous = false;
    const Vec3 middle = motion::Capsule().middle(view.body->feet);
    const Result<world::SpaceIndex> space = findRoot(loaded.world, view.body->root, middle, ambiguous);
    if (!space)
        return tl::unexpected(space.error());
    eye.body = motion::PlayerBody{view.body->feet,    view.body->yaw,   *space,
                                  view.body->opacity, view.body->speed, view.body->metres};
    return {};
}

Session::Session(std::shared_ptr<const WorldSource> source, const SessionOptions& options,
                 gpu::Device& device)
    : source_(std::move(source)), options_(options), device_(device),
      checked_(kIsDevelopment ? std::make_optional<gpu::CheckedDevice>(device) : std::nullopt),
      renderer_(drawnOn(), {.textures = {.mode = options.textures, .anisotropy = options.anisotropy},
                            .culling = options.culling}) {}

Session::~Session() = default;

gpu::Device& Session::drawnOn() {
    if (checked_)
        return *checked_;
    return device_;
}

void Session::drawBy(std::size_t quality) {
    choose(quality, options_);
    renderer_.setAnisotropy(options_.anisotropy);
}

Result<void> Session::load(dat::BlockCoord centre) {
    if (loaded_ && loaded_->target == StreamTarget{centre, options_.load})
        return {};
    Result<std::shared_ptr<LoadedWorld>> loaded = read(centre);
    if (!loaded)
        return tl::unexpected(loaded.error());
    return show(std::move(*loaded));
}

Result<std::shared_ptr<LoadedWorld>> Session::read(const StreamTarget& target, unsigned threads) const {
    Result<std::unique_ptr<LoadedWorld>> loaded = LoadedWorld::load(
        source_->archive, target.centre, target.options, source_->file.moving, {cache_.get(), threads});
    source_->archive.letPagesGo(); // what is needed again soon is in the cache
    if (!loaded)
        return tl::unexpected(loaded.error());
    return std::shared_ptr<LoadedWorld>(std::move(*loaded));
}

Result<void> Session::show(std::shared_ptr<LoadedWorld> world) {
    if (Result<void> uploaded = renderer_.upload(frame::buildScene(world->world, world->planner.pieces()));
        !uploaded)
        return uploaded;
    static_cast<void>(take(std::move(world)));
    return {};
}

std::shared_ptr<LoadedWorld> Session::take(std::shared_ptr<LoadedWorld> world) {
    return std::exchange(loaded_, std::move(world));
}

bool Session::follow(const Vec3& eye, world::SpaceIndex& root, Walk*) {
    const dat::RecordId cell = root == world::kOutside ? 0 : loaded_->world.spaces[root].cellId;
    const dat::BlockCoord here = blockAround(source_->archive, *loaded_, cell, eye);
    const int distance = std::max(std::abs(here.x - loaded_->centre.x), std::abs(here.y - loaded_->centre.y));
    if (distance <= leashOf(options_.load.radius) && loaded_->target.options == options_.load)
        return false;
    if (!load(here))
        return false;
    root = rootIn(*loaded_, cell, eye);
    return true;
}

Passage Session::open(dat::BlockCoord centre) {
    return load(centre) ? Passage::Open : Passage::Refused;
}

Result<gpu::RenderTarget*> Session::fitTarget(PixelSize size, const DrawOptions& options) {
    const bool multisampled = options_.samples > 1 && !options.ids && !options.layers;
    std::optional<gpu::RenderTarget>& target = multisampled ? sampledTarget_ : target_;
    // A target that can count layers serves frames without, so that taking turns makes no new ones.
    const bool fits = target && target->width() == size.width && target->height() == size.height;
    const bool layers = !multisampled && (options.layers || (fits && target->options().layers));
    if (fits && target->options().layers == layers)
        return &*target;
    shown_ = nullptr;
    target.reset(); // room for the new one
    Result<gpu::RenderTarget> made =
        gpu::RenderTarget::create(drawnOn(), size.width, size.height,
                                  {.layers = layers, .samples = multisampled ? options_.samples : 0});
    if (!made)
        return tl::unexpected(made.error());
    target.emplace(std::move(*made));
    return &*target;
}

Result<void> Session::draw(const FrameEye& eye, const DrawOptions& options) {
    LIMEN_ASSERT(loaded_ != nullptr, "load before drawing");
    const Result<gpu::RenderTarget*> target = fitTarget(eye.size, options);
    if (!target)
        return tl::unexpected(target.error());
    shown_ = *target;
    const frame::FrameView view = frameView(eye, options);
    loaded_->dynamicsBuilder.build(dynamicsInput(loaded_->world, eye), dynamics_);
    const Stopwatch flooding;
    visibility::flood(loaded_->graph, dynamics_.closed, view.view, {}, scratch_, visible_);
    floodMs_ = flooding.ms();
    const Stopwatch planning;
    loaded_->planner.plan(view, dynamics_, visible_, plan_);
    planMs_ = planning.ms();
    Result<void> rendered = renderer_.render(
        plan_, **target, {.wantIds = options.ids, .shading = options.shading, .wantLayers = options.layers});
    LIMEN_ASSERT(!checked_ || checked_->faults().empty(), checked_->faults().front().c_str());
    return rendered;
}

Result<Picked> Session::pick(const FrameEye& eye, std::uint32_t x, std::uint32_t y) {
    LIMEN_ASSERT(x < eye.size.width && y < eye.size.height, "a pixel of the picture");
    if (Result<void> drawn = draw(eye, {.ids = true, .shading = gpu::Shading::IdsOnly}); !drawn)
        return tl::unexpected(drawn.error());
    const std::size_t pixel = std::size_t{y} * eye.size.width + x;
    return pickedPixel(loaded_->world, loaded_->ids, dynamics_, visible_, shown_->readIds()[pixel],
                       shown_->readOwnership()[pixel], shown_->readDistances(plan_.constants)[pixel]);
}

void Session::tracePortals(const FrameEye& eye, visibility::FloodTrace& trace) {
    LIMEN_ASSERT(loaded_ != nullptr && shown_ != nullptr, "draw before asking why");
    visibility::VisibleSet visible;
    visibility::flood(loaded_->graph, dynamics_.closed, viewOf(eye.camera, eye.size, eye.root), {}, scratch_,
                      visible, &trace);
}

FrameFigures Session::figures() const {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const gpu::FrameReport report = renderer_.report();
    FrameFigures figures;
    figures.driver = driver();
    figures.textures = renderer_.driver().textureMode;
    figures.glCalls = report.glCalls;
    figures.ringStalls = report.ringStalls;
    figures.trouble = report.trouble;
    figures.bytesWritten = report.bytesWritten;
    figures.resident = device_.objects();
    figures.floodMs = floodMs_;
    figures.planMs = planMs_;
    figures.submitMs = report.cpuMs;
    figures.gpuMs = 0.0;
    for (const gpu::StageReport& stage : report.stages) {
        figures.stages.push_back(
            {frame::nameOf(stage.kind), stage.draws, stage.cpuMs, stage.gpuMs.value_or(kUnknown)});
        figures.gpuMs += stage.gpuMs.value_or(kUnknown);
    }
    return figures;
}

std::string Session::driver() const {
    const gpu::DriverReport report = renderer_.driver();
    return fmt::format("{}, OpenGL {}", report.renderer, report.version);
}

Result<HeadlessSession> openHeadless(std::shared_ptr<const WorldSource> source,
                                     const SessionOptions& options) {
    Result<gpu::HeadlessContext> context = gpu::HeadlessContext::create();
    if (!context)
        return tl::unexpected(context.error());
    HeadlessSession headless;
    headless.context = std::make_unique<gpu::HeadlessContext>(std::move(*context));
    Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return tl::unexpected(device.error());
    headless.device = std::move(*device);
    headless.session = std::make_unique<Session>(std::move(source), options, *headless.device);
    return headless;
}

std::string findingsLine(const world::World& world) {
    if (world.findings.empty())
        return {};
    const world::Finding& first = world.findings.front();
    const std::string rest =
        world.findings.size() > 1 ? fmt::format(" (and {} more)", world.findings.size() - 1) : "";
    return fmt::format("limen: in the world's data: {}: {}{}", hexId(first.record), first.what, rest);
}

} // namespace limen::app
