#include "engine/FrameDrawer.h"

#include "engine/FrameMemory.h"
#include "engine/Session.h"
#include "gpu/device/CurrentContext.h"
#include "gpu/device/SavedGlState.h"

#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <utility>

namespace limen::engine {

static_assert(kMostPixelsPerSide == kMaxSide);

struct DrawerState {
    DrawerState(const OpenedWorld& of, const SessionOptions& wanted) : world(of), options(wanted) {}

    OpenedWorld world;
    SessionOptions options;
    std::optional<gpu::HeadlessContext> context{}; ///< none: the caller's
    void* callers = nullptr;                       ///< the caller's context
    std::unique_ptr<gpu::GlDevice> device;
    std::unique_ptr<Session> session; ///< destroyed first
    std::optional<PixelSize> drawn;   ///< of the last frame; none: there is none
    bool hasIds = false;              ///< of the last frame
};

namespace {

constexpr double kFarthestEye = 1e6;                // metres from the map's corner
constexpr double kMostSeconds = 1e9;                // of the world's time
constexpr double kLeastFov = 0.1, kMostFov = 179.0; // degrees
constexpr int kMostRadius = 16, kMostFarRadius = 32;

Failure wrong(const char* member, const char* expected) {
    return fail(ErrorCode::BadArgument, member, expected);
}

/// False for NaN.
bool isWithin(double value, double low, double high) {
    return value >= low && value <= high;
}

Result<void> check(const Viewpoint& view) {
    for (int axis = 0; axis < 3; ++axis)
        if (!isWithin(view.eye[axis], -kFarthestEye, kFarthestEye))
            return wrong("viewpoint.eye", "must be within 1,000 km of the map's corner");
    if (!std::isfinite(view.yaw) || !isWithin(view.pitch, -90.0, 90.0))
        return wrong("viewpoint", "needs a finite yaw and a pitch of -90 to 90 degrees");
    return {};
}

Result<void> check(const FrameDescription& frame) {
    if (Result<void> checked = check(frame.viewpoint); !checked)
        return checked;
    if (!isWithin(frame.fovDegrees, kLeastFov, kMostFov))
        return wrong("fovDegrees", "must be 0.1 to 179");
    if (!isWithin(frame.width, 1, kMaxSide) || !isWithin(frame.height, 1, kMaxSide))
        return wrong("width, height", "must be 1 to 16384 pixels");
    if (!isWithin(frame.timeOfDay, 0.0, 1.0))
        return wrong("timeOfDay", "must be 0 to 1");
    if (!isWithin(frame.seconds, -kMostSeconds, kMostSeconds))
        return wrong("seconds", "must be within 1,000,000,000");
    if (frame.doors && !isWithin(*frame.doors, 0.0, 1.0))
        return wrong("doors", "must be 0 to 1");
    return {};
}

Result<SessionOptions> sessionOptions(const DrawerOptions& options) {
    if (!isWithin(options.radius, 0, kMostRadius) || !isWithin(options.farRadius, 0, kMostFarRadius))
        return wrong("radius, farRadius", "must be 0 to 16 and 0 to 32 landblocks");
    if (options.samples != 1 && options.samples != frame::gpu::kSamples)
        return wrong("samples", "must be 1 or 4");
    SessionOptions made;
    made.load.radius = options.radius;
    made.load.farRadius = options.farRadius;
    made.samples = options.samples;
    return made;
}

/// The result of `work`, with exceptions of the standard library as errors.
template <class Work>
std::invoke_result_t<Work> guarded(Work&& work) {
    try {
        return work();
    } catch (const std::exception& exception) {
        return fail(ErrorCode::Unsupported, "frame drawer", std::string("failed: ") + exception.what());
    }
}

/// Runs `work` with the drawer's context current and the device's state in it. Restores both for the caller.
template <class Work>
std::invoke_result_t<Work> inContext(DrawerState& state, Work&& work) {
    if (state.context) {
        const Result<gpu::ContextSwitch> current = gpu::ContextSwitch::to(*state.context);
        return current ? guarded(work) : Failure(current.error());
    }
    if (gpu::currentContext() != state.callers)
        return fail(
            ErrorCode::BadArgument, "frame drawer",
            "another OpenGL context is current on this thread, or none; make that of the drawer current");
    const gpu::SavedGlState saved;
    state.device->restoreState();
    return guarded(work);
}

/// A device in the current context. Its state is not that of the caller any more.
Result<void> begin(DrawerState& state) {
    Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return Failure(device.error());
    if (Result<void> samples = gpu::checkSamples(state.options.samples, (*device)->capabilities()); !samples)
        return samples;
    state.device = std::move(*device);
    state.session = std::make_unique<Session>(state.world.source(), state.options, *state.device);
    return {};
}

/// Destroys everything on the device. False: its context cannot be used.
bool end(DrawerState& state) {
    const auto destroy = [&] {
        state.session.reset();
        state.device.reset();
        return Result<void>{};
    };
    return state.device == nullptr || inContext(state, destroy).has_value();
}

ViewRequest requestOf(const Viewpoint& viewpoint) {
    ViewRequest view;
    view.eye = viewpoint.eye;
    view.yaw = viewpoint.yaw;
    view.pitch = viewpoint.pitch;
    if (viewpoint.cell)
        view.root = *viewpoint.cell == 0 ? RootChoice{RootChoice::Rule::Outside, 0}
                                         : RootChoice{RootChoice::Rule::Cell, *viewpoint.cell};
    return view;
}

ViewRequest requestOf(const FrameDescription& frame) {
    ViewRequest view = requestOf(frame.viewpoint);
    view.fov = frame.fovDegrees;
    view.size = {frame.width, frame.height};
    view.scene.time = frame.timeOfDay;
    view.scene.seconds = frame.seconds;
    view.scene.weather = frame.isRaining ? Weather::Rain : Weather::Clear;
    view.scene.doors = frame.doors;
    return view;
}

/// Errors of the rooms below may name an option of the command line; here they name a member.
Failure named(const char* member, const Error& error) {
    return Failure({error.code, error.where.starts_with("--") ? member : error.where, error.what});
}

Result<FrameCounts> drawFrame(DrawerState& state, const FrameDescription& frame) {
    Session& session = *state.session;
    const ViewRequest view = requestOf(frame);
    if (Result<void> fits =
            checkFrameFits(view.size, session.samples(), session.capabilities(), availableMemory());
        !fits)
        return named("width, height", fits.error());
    if (Result<void> loaded = session.load(centreOf(view)); !loaded)
        return Failure(loaded.error());
    const Result<FrameRequest> request = frameRequest(session.part().world, session.source().file, view);
    if (!request)
        return named("viewpoint.cell", request.error());
    if (Result<void> drawn = session.draw(*request, {.ids = frame.withIds}); !drawn)
        return Failure(drawn.error());
    state.drawn = view.size;
    state.hasIds = frame.withIds;
    const frame::PlanCounts& counts = session.plan().counts;
    return FrameCounts{static_cast<std::uint32_t>(session.visible().visits.size()), counts.cellsSeen,
                       counts.instancesDrawn};
}

Failure movedFrom() {
    return wrong("frame drawer", "was moved to another object; use that one");
}

/// Runs `read` on the last frame's images.
template <class Read>
std::invoke_result_t<Read> ofLastFrame(DrawerState* state, bool needsIds, Read&& read) {
    if (state == nullptr)
        return movedFrom();
    if (!state->drawn)
        return wrong("frame drawer", "has no frame; call draw first");
    if (needsIds && !state->hasIds)
        return wrong("frame drawer", "drew the last frame without ids; draw it with withIds");
    return inContext(*state, read);
}

Surface surfaceOf(const Picked& picked) {
    const IdMeaning& meaning = picked.meaning;
    return {meaning.kind,  meaning.space, meaning.record, meaning.polygon,
            picked.object, picked.placed, picked.distance};
}

} // namespace

FrameDrawer::FrameDrawer(std::unique_ptr<DrawerState> state) : state_(std::move(state)) {}
FrameDrawer::FrameDrawer(FrameDrawer&& other) noexcept = default;

FrameDrawer& FrameDrawer::operator=(FrameDrawer&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}

FrameDrawer::~FrameDrawer() {
    if (state_ != nullptr && !end(*state_))
        static_cast<void>(
            state_.release()); // deleting names in another context would delete objects of that one
}

Result<FrameDrawer> FrameDrawer::headless(const OpenedWorld& world, const DrawerOptions& options) {
    const Result<SessionOptions> made = sessionOptions(options);
    if (!made)
        return Failure(made.error());
    return guarded([&]() -> Result<FrameDrawer> {
        const Result<gpu::ContextSwitch> former = gpu::ContextSwitch::begin();
        if (!former)
            return Failure(former.error());
        Result<gpu::HeadlessContext> context = gpu::HeadlessContext::create();
        if (!context)
            return Failure(context.error());
        FrameDrawer drawer(std::make_unique<DrawerState>(world, *made));
        drawer.state_->context.emplace(std::move(*context));
        if (Result<void> begun = begin(*drawer.state_); !begun)
            return Failure(begun.error());
        return drawer;
    });
}

Result<FrameDrawer> FrameDrawer::onCurrentContext(const OpenedWorld& world, const DrawerOptions& options) {
    const Result<SessionOptions> made = sessionOptions(options);
    if (!made)
        return Failure(made.error());
    void* const context = gpu::currentContext();
    if (context == nullptr)
        return wrong("frame drawer",
                     "no OpenGL context is current on this thread; make one current, or use headless");
    return guarded([&]() -> Result<FrameDrawer> {
        if (const Result<gpu::Capabilities> capable = gpu::queryCapabilities(); !capable)
            return Failure(capable.error()); // saving the state needs OpenGL 4.5
        const gpu::SavedGlState saved;
        FrameDrawer drawer(std::make_unique<DrawerState>(world, *made));
        drawer.state_->callers = context;
        if (Result<void> begun = begin(*drawer.state_); !begun)
            return Failure(begun.error());
        return drawer;
    });
}

Result<void> FrameDrawer::load(const Viewpoint& viewpoint) {
    if (state_ == nullptr)
        return movedFrom();
    if (Result<void> checked = check(viewpoint); !checked)
        return checked;
    return inContext(*state_, [&] { return state_->session->load(centreOf(requestOf(viewpoint))); });
}

Result<FrameCounts> FrameDrawer::draw(const FrameDescription& frame) {
    if (state_ == nullptr)
        return movedFrom();
    if (Result<void> checked = check(frame); !checked)
        return Failure(checked.error());
    return inContext(*state_, [&] {
        state_->drawn.reset();
        return drawFrame(*state_, frame);
    });
}

Result<void> FrameDrawer::copyTo(std::uint32_t framebuffer, std::int32_t x, std::int32_t y) {
    return ofLastFrame(state_.get(), false, [&]() -> Result<void> {
        if (state_->context)
            return wrong("frame drawer",
                         "is headless, and has no framebuffer of the caller's; use readColour");
        return state_->device->copyTo(state_->session->target().handle(), framebuffer, x, y);
    });
}

Result<FrameObjects> FrameDrawer::objects() {
    return ofLastFrame(state_.get(), false, [&]() -> Result<FrameObjects> {
        if (state_->context)
            return wrong("frame drawer",
                         "is headless, and its objects are not in the caller's context; use readColour");
        const gpu::GlDevice::PictureNames names = state_->device->namesOf(state_->session->target().handle());
        return FrameObjects{names.framebuffer, names.colour, names.ids, names.depth,
                            state_->session->plan().constants.nearPlane};
    });
}

Result<std::vector<std::uint8_t>> FrameDrawer::readColour() {
    return ofLastFrame(state_.get(), false, [&]() -> Result<std::vector<std::uint8_t>> {
        return state_->session->target().readColour();
    });
}

Result<std::vector<std::uint32_t>> FrameDrawer::readIds() {
    return ofLastFrame(state_.get(), true, [&]() -> Result<std::vector<std::uint32_t>> {
        return state_->session->target().readIds();
    });
}

Result<std::vector<float>> FrameDrawer::readDistances() {
    return ofLastFrame(state_.get(), true, [&]() -> Result<std::vector<float>> {
        const Session& session = *state_->session;
        return session.target().readDistances(session.plan().constants);
    });
}

Result<Surface> FrameDrawer::surfaceAt(std::uint32_t x, std::uint32_t y) {
    return ofLastFrame(state_.get(), true, [&]() -> Result<Surface> {
        if (x >= state_->drawn->width || y >= state_->drawn->height)
            return wrong("pixel", "is outside of the frame");
        const Session& session = *state_->session;
        const gpu::RenderTarget& target = session.target();
        const std::size_t pixel = std::size_t{y} * state_->drawn->width + x;
        return surfaceOf(pickedPixel(session.part().world, session.part().ids, session.dynamics(),
                                     session.visible(), target.readIds()[pixel],
                                     target.readOwnership()[pixel],
                                     target.readDistances(session.plan().constants)[pixel]));
    });
}

std::string FrameDrawer::driver() const {
    return state_ == nullptr ? std::string() : state_->session->driver();
}

} // namespace limen::engine
