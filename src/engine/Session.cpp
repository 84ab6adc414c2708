#include "engine/Session.h"

#include "core/Assert.h"
#include "engine/Quality.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace limen::engine {
namespace {

/// Milliseconds since its construction.
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

/// Distance in blocks from the loaded centre that the eye can move before the next part is loaded: half the
/// radius.
int leashOf(int radius) {
    return std::max(1, radius / 2);
}

} // namespace

void applyQuality(std::size_t quality, SessionOptions& options) {
    LIMEN_ASSERT(quality < kQualities.size(), "the index of a quality level");
    options.quality = quality;
    options.load = loadBy(kQualities[quality], options.load);
    options.samples = 0;
    options.presetSamples = kQualities[quality].samples;
    options.anisotropy = kQualities[quality].anisotropy;
}

std::uint32_t samplesOn(const gpu::Capabilities& driver, const SessionOptions& options) {
    if (options.samples > 0)
        return options.samples;
    return driver.software ? 1 : std::max(options.presetSamples, 1u);
}

Session::Session(std::shared_ptr<const WorldSource> source, const SessionOptions& options,
                 gpu::Device& device)
    : source_(std::move(source)), options_(options), device_(device),
      checked_(kIsDevelopment ? std::make_optional<gpu::CheckedDevice>(device) : std::nullopt),
      pipeline_(drawnOn(), {.textures = {.mode = options.textures, .anisotropy = options.anisotropy},
                            .drawing = options.drawing,
                            .culling = options.culling}) {
    LIMEN_ASSERT(source_ != nullptr, "a session has a source");
    pipeline_.setGate(options_.gate);
}

Session::~Session() = default;

gpu::Device& Session::drawnOn() {
    if (checked_)
        return *checked_;
    return device_;
}

void Session::setGate(frame::Gate gate) {
    options_.gate = gate;
    pipeline_.setGate(gate);
}

void Session::setQuality(std::size_t quality) {
    applyQuality(quality, options_);
    renderer().setAnisotropy(options_.anisotropy);
}

Result<void> Session::load(dat::BlockCoord centre) {
    if (isLoaded() && part().target == PartTarget{centre, options_.load})
        return {};
    Result<std::unique_ptr<PartPlanner>> loaded = read(centre);
    if (!loaded)
        return Failure(loaded.error());
    return show(std::move(*loaded));
}

Result<std::unique_ptr<PartPlanner>> Session::read(const PartTarget& target, unsigned threads,
                                                   world::LoadProgress* progress) const {
    LIMEN_ASSERT(threads > 0, "at least one thread reads");
    const Result<world::MovingEntries> moving = movingAround(*source_, target.centre, target.options);
    if (!moving)
        return Failure(moving.error());
    Result<std::shared_ptr<const LoadedPart>> loaded =
        loadPart(source_->archive, target, *moving, {cache_.get(), threads, progress});
    source_->archive.letPagesGo(); // the cache holds the records that the next part needs
    if (!loaded)
        return Failure(loaded.error());
    return std::make_unique<PartPlanner>(std::move(*loaded));
}

std::shared_ptr<const LoadedPart> Session::follow(const Vec3& eye, world::SpaceIndex root) {
    LIMEN_ASSERT(isLoaded(), "load before following an eye");
    const LoadedPart& shown = part();
    const dat::RecordId cell = cellOf(shown.world, root);
    const dat::BlockCoord here = blockAround(source_->archive, shown, cell, eye);
    const dat::BlockCoord centre = shown.target.centre;
    const int distance = std::max(std::abs(here.x - centre.x), std::abs(here.y - centre.y));
    const PartTarget target{here, options_.load};
    offered_.reset();
    if ((distance <= leashOf(options_.load.radius) && shown.target.options == options_.load) ||
        shown.target == target)
        return nullptr;
    Result<std::unique_ptr<PartPlanner>> loaded = read(target);
    if (!loaded)
        return nullptr; // the part on the screen stays
    offered_ = std::move(*loaded);
    return offered_->part;
}

bool Session::show() {
    LIMEN_ASSERT(offered_ != nullptr, "show follows an offer");
    return show(std::move(offered_)).has_value();
}

Passage Session::open(dat::BlockCoord centre) {
    return load(centre) ? Passage::Open : Passage::Refused;
}

Result<gpu::RenderTarget*> Session::fitTarget(PixelSize size, const DrawOptions& options) {
    LIMEN_ASSERT(size.width <= kMaxSide && size.height <= kMaxSide,
                 "the picture is not larger than kMaxSide");
    const bool multisampled = samples() > 1 && !options.ids && !options.layers;
    std::optional<gpu::RenderTarget>& target = multisampled ? sampledTarget_ : target_;
    // A target that can count layers also serves frames without layers. Otherwise frames of alternating kinds
    // would make a new target each.
    const bool fits = target && target->width() == size.width && target->height() == size.height;
    const bool layers = !multisampled && (options.layers || (fits && target->options().layers));
    if (fits && target->options().layers == layers)
        return &*target;
    shown_ = nullptr;
    target.reset(); // frees its memory before the new target is made
    Result<gpu::RenderTarget> made =
        gpu::RenderTarget::create(drawnOn(), size.width, size.height,
                                  {.layers = layers,
                                   .wide = options_.drawing == gpu::Drawing::Fast,
                                   .samples = multisampled ? samples() : 0});
    if (!made)
        return Failure(made.error());
    target.emplace(std::move(*made));
    return &*target;
}

Result<void> Session::drawInto(gpu::RenderTarget& target, const FrameRequest& request,
                               const FrameOutputs& outputs, const gpu::RenderOptions& options) {
    const FrameInputs inputs = frameInputs(part().world, request, outputs);
    pipeline_.updateDynamics(inputs.dynamics);
    const Stopwatch flooding;
    if (Result<void> flooded = pipeline_.flood(inputs.view.view); !flooded)
        return flooded;
    floodMs_ = flooding.ms();
    const Stopwatch planning;
    pipeline_.plan(inputs.view);
    planMs_ = planning.ms();
    Result<void> rendered = pipeline_.render(target, options);
    LIMEN_ASSERT(!checked_ || checked_->faults().empty(), checked_->faults().front().c_str());
    ++frames_;
    return rendered;
}

Result<void> Session::draw(const FrameRequest& request, const DrawOptions& options) {
    LIMEN_ASSERT(isLoaded(), "load before drawing");
    const Result<gpu::RenderTarget*> target = fitTarget(request.size, options);
    if (!target)
        return Failure(target.error());
    shown_ = *target;
    return drawInto(**target, request,
                    {.exactCutOuts = options.ids || options.shading != gpu::Shading::Lit,
                     .highlights = options.highlights},
                    {.wantIds = options.ids, .shading = options.shading, .wantLayers = options.layers});
}

Result<gpu::RenderTarget> Session::makeTile(std::uint32_t width, std::uint32_t height) {
    return gpu::RenderTarget::create(
        drawnOn(), width, height,
        {.wide = options_.drawing == gpu::Drawing::Fast, .samples = samples() > 1 ? samples() : 0});
}

Result<void> Session::drawTile(const FrameRequest& request, gpu::RenderTarget& tile) {
    LIMEN_ASSERT(isLoaded(), "load before drawing");
    LIMEN_ASSERT(tile.isTile(), "the tile has a place in the picture");
    shown_ = nullptr;
    return drawInto(tile, request, {}, {.wantIds = false});
}

Result<Picked> Session::pick(const FrameRequest& request, std::uint32_t x, std::uint32_t y) {
    LIMEN_ASSERT(x < request.size.width && y < request.size.height, "a pixel of the picture");
    if (Result<void> drawn = draw(request, {.ids = true, .shading = gpu::Shading::IdsOnly}); !drawn)
        return Failure(drawn.error());
    const std::size_t pixel = std::size_t{y} * request.size.width + x;
    return pickedPixel(part().world, part().ids, dynamics(), visible(), shown_->readIds()[pixel],
                       shown_->readOwnership()[pixel], shown_->readDistances(plan().constants)[pixel]);
}

void Session::tracePortals(const FrameRequest& request, visibility::FloodTrace& trace) {
    LIMEN_ASSERT(isLoaded() && shown_ != nullptr, "draw a frame first");
    const Result<void> flooded = pipeline_.trace(viewOf(request.camera, request.size, request.root), trace);
    LIMEN_ASSERT(flooded.has_value(), "this view was drawn before");
}

const gpu::RenderTarget& Session::target() const {
    LIMEN_ASSERT(shown_ != nullptr, "draw a frame first");
    return *shown_;
}

FrameFigures Session::figures() const {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const gpu::FrameReport report = renderer().report();
    FrameFigures figures;
    figures.driver = driver();
    figures.drawing = options_.drawing == gpu::Drawing::Fast ? "fast" : "exact";
    figures.choices = gpu::driverChoices(renderer().options(), capabilities(), samples());
    figures.textures = renderer().driver().textureMode;
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
    const gpu::DriverReport report = renderer().driver();
    return fmt::format("{}, OpenGL {}", report.renderer, report.version);
}

Result<HeadlessSession> openHeadless(std::shared_ptr<const WorldSource> source, const SessionOptions& options,
                                     gpu::ContextDisplay display) {
    Result<gpu::HeadlessContext> context =
        gpu::HeadlessContext::create(false, gpu::ContextProfile::Core, display);
    if (!context)
        return Failure(context.error());
    HeadlessSession headless;
    headless.context = std::make_unique<gpu::HeadlessContext>(std::move(*context));
    Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return Failure(device.error());
    headless.device = std::move(*device);
    headless.session = std::make_unique<Session>(std::move(source), options, *headless.device);
    return headless;
}

} // namespace limen::engine
