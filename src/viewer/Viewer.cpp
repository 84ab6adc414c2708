#include "viewer/Viewer.h"

#include "engine/CheckView.h"
#include "viewer/Screenshots.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace limen::viewer {
namespace {

/// The session options of `shot` that change pictures.
std::string pictureOptions(const engine::SessionOptions& options) {
    const world::LoadOptions usual;
    std::string text;
    if (options.load.radius != usual.radius)
        text += fmt::format(" --radius {}", options.load.radius);
    if (options.load.detail != usual.detail)
        text += fmt::format(" --detail {}", options.load.detail);
    if (options.samples > 1)
        text += fmt::format(" --msaa {}", options.samples);
    return text;
}

bool isSameView(const engine::FrameRequest& a, const engine::FrameRequest& b) {
    return a.camera.eye == b.camera.eye && a.camera.heading.yaw == b.camera.heading.yaw &&
           a.camera.heading.pitch == b.camera.heading.pitch && a.size.width == b.size.width &&
           a.size.height == b.size.height && a.scene.time == b.scene.time &&
           a.scene.dayGroup == b.scene.dayGroup && a.scene.weather == b.scene.weather &&
           a.scene.doors == b.scene.doors && a.scene.eachDoor == b.scene.eachDoor &&
           a.scene.body == b.scene.body;
}

} // namespace

Viewer::Viewer(Window& window, gpu::GlDevice& device, engine::Session& session, engine::FrameRequest start,
               ViewerKeys keys, std::filesystem::path screenshots)
    : window_(window), device_(device), session_(session), panel_(window), stream_(session),
      play_(session, std::move(start), &stream_), bindings_(std::move(keys.bindings)),
      keysFile_(std::move(keys.file)), screenshots_(std::move(screenshots)) {
    start_ = request().camera.eye;
    lastSeconds_ = window_.seconds();
    device_.restoreState(); // ImGui's setup changed GL state
}

Result<void> Viewer::frame(double fixedSeconds) {
    window_.poll(panel_.takes(), bindings_);
    const double now = window_.seconds();
    frameSeconds_ = now - lastSeconds_;
    lastSeconds_ = now;
    takeKeys();
    if (Result<void> moved = play_.step(takeInput(fixedSeconds > 0.0 ? fixedSeconds : frameSeconds_)); !moved)
        return moved;
    if (stream_.hasRefused())
        notice("this place cannot be loaded; choose another one");
    if (const std::optional<PixelPlace> clicked = window_.clicked()) {
        if (Result<void> picked = pick(*clicked); !picked)
            return picked;
    }
    if (wantsCheck_) {
        if (Result<void> checked = check(); !checked)
            return checked;
    }
    if (wantsPicture_) {
        if (Result<void> kept = keepPicture(); !kept)
            return kept;
    }
    if (verdict_ && !isSameView(request(), checkedFrom_))
        verdict_.reset();
    const std::optional<frame::Highlight> pulse = selectionPulse();
    engine::DrawOptions options{.ids = switches_.ids || switches_.depth};
    if (pulse)
        options.highlights = std::span(&*pulse, 1);
    if (Result<void> drawn = session_.draw(request(), options); !drawn)
        return drawn;
    probed_ = probe_ ? probe_->see({frames_, request().scene.seconds, session_.part().world, request(),
                                    session_.visible(), session_.plan(), session_.figures().glCalls})
                     : std::string();
    overlay();
    return {};
}

bool Viewer::isAtStart() {
    constexpr double kUnderWay = 1.5; // metres; after this distance the greeting is no longer needed
    hasLeft_ = hasLeft_ || glm::length(request().camera.eye - start_) > kUnderWay;
    return !hasLeft_;
}

void Viewer::rest() {
    window_.rest();
    lastSeconds_ = window_.seconds();
}

std::string Viewer::doorInReach() const {
    const std::optional<std::size_t> door = play_.doorInReach();
    return door ? session_.part().world.doors[*door].name : std::string();
}

std::string Viewer::noticeText() const {
    if (lastSeconds_ < notice_.until)
        return notice_.text;
    return play_.goingTo().empty() ? std::string() : fmt::format("loading {} ...", play_.goingTo());
}

std::vector<std::string> Viewer::openDoors() const {
    std::vector<std::string> names;
    const std::vector<world::Door>& doors = session_.part().world.doors;
    for (std::size_t i = 0; i < doors.size(); ++i)
        if (request().scene.doors.value_or(i < request().scene.eachDoor.size() ? request().scene.eachDoor[i]
                                                                               : doors[i].open) > 0.0)
            names.push_back(doors[i].name);
    return names;
}

void Viewer::takeKeys() {
    if (rebinding_ && !window_.pressedKeys().empty()) {
        rebind(window_.pressedKeys().front());
        return;
    }
    for (const Action action : window_.pressed())
        press(action);
}

void Viewer::press(Action action) {
    switch (action) {
    case Action::Help:
        switches_.help = !switches_.help;
        return;
    case Action::Ids:
        switches_.ids = !switches_.ids;
        return;
    case Action::Depth:
        switches_.depth = !switches_.depth;
        return;
    case Action::Regions:
        switches_.regions = !switches_.regions;
        return;
    case Action::Portals:
        switches_.portals = !switches_.portals;
        return;
    case Action::Panel:
        switches_.panel = !switches_.panel;
        return;
    case Action::Check:
        wantsCheck_ = true;
        return;
    case Action::Probe:
        probe_ = probe_ ? std::nullopt : std::make_optional<output::Probe>();
        return;
    case Action::Freeze:
        freeze();
        return;
    case Action::Screenshot:
        wantsPicture_ = true;
        return;
    case Action::FullScreen:
        window_.switchFullScreen();
        return;
    case Action::Walk:
        return act({play::PlayActKind::Walk});
    case Action::Chase:
        return act({play::PlayActKind::Chase});
    case Action::Doors:
        return act({play::PlayActKind::Doors});
    case Action::Use:
        return act({play::PlayActKind::Use});
    case Action::Rain:
        return act({play::PlayActKind::Weather});
    case Action::Later:
        return act({play::PlayActKind::Time, std::fmod(request().scene.time + 1.0 / 24.0, 1.0)});
    case Action::Leave:
        leaving_ = true;
        return;
    default:
        if (action >= Action::Place1)
            act({play::PlayActKind::Place,
                 static_cast<double>(action) - static_cast<double>(Action::Place1)});
    }
}

void Viewer::rebind(KeyCode key) {
    const Rebinding wanted = *std::exchange(rebinding_, std::nullopt);
    if (key == keyNamed("Escape"))
        return;
    KeyBindings changed = bindings_;
    changed.bind(wanted.action, key, wanted.adds);
    keepBindings(std::move(changed));
}

void Viewer::keepBindings(KeyBindings bindings) {
    bindings_ = std::move(bindings);
    const Result<void> written = writeKeyBindings(keysFile_, bindings_);
    notice(written ? "keys saved in " + keysFile_.string() : written.error().message());
}

Result<void> Viewer::keepPicture() {
    wantsPicture_ = false;
    if (Result<void> drawn = session_.draw(request(), {}); !drawn)
        return drawn;
    const output::Picture picture =
        output::pictureFromRgba(request().size.width, request().size.height, session_.target().readColour());
    const Result<std::filesystem::path> kept =
        keepScreenshot(screenshots_, picture,
                       engine::reproduction(session_.part().world, request(), session_.source().datOption) +
                           pictureOptions(session_.options()));
    notice(kept ? kept->string() : kept.error().message()); // a full disk does not end the program
    return {};
}

void Viewer::notice(std::string text) {
    constexpr double kShown = 4.0; // seconds
    notice_ = {std::move(text), lastSeconds_ + kShown};
}

void Viewer::freeze() {
    if (frozen_)
        frozen_.reset();
    else
        frozen_ = FrozenFlood{engine::viewOf(request().camera, request().size, request().root),
                              session_.visible(), portalsNow()};
}

std::vector<PortalTrace> Viewer::portalsNow() {
    session_.tracePortals(request(), trace_);
    return portalTraces(trace_);
}

ResidencyMap Viewer::residency() const {
    const world::World& world = session_.part().world;
    const dat::BlockCoord here = blockOf(world, request().root, request().camera.eye);
    const dat::BlockCoord player =
        request().scene.body ? blockOf(world, request().scene.body->space, request().scene.body->feet) : here;
    return residencyMap(world, here, player, session_.options().load.radius + 1);
}

const play::PlayInput& Viewer::takeInput(double seconds) {
    const HeldInput& held = window_.held();
    for (const play::PlayAct& done : wheelActs(
             held.wheel, {walk().isOn(), walk().isChased(), walk().distance(), play::WalkingBody::kNearest}))
        act(done);
    input_ = inputOf(held, seconds);
    input_.isFrozen = verdict_.has_value(); // the world stops while a verdict is shown
    input_.size = window_.size();
    input_.acts = std::exchange(acts_, {});
    return input_;
}

Result<void> Viewer::pick(const PixelPlace& place) {
    if (place.x >= request().size.width || place.y >= request().size.height)
        return {}; // the window has shrunk since the frame
    Result<engine::Picked> picked = session_.pick(request(), place.x, place.y);
    if (!picked)
        return tl::unexpected(picked.error());
    const bool isSame = picked_ && picked->object != 0 && picked->object == picked_->object &&
                        picked->meaning.polygon == picked_->meaning.polygon;
    picked_ =
        isSame || picked->meaning.kind == "void" ? std::nullopt : std::make_optional(std::move(*picked));
    return {};
}

Result<void> Viewer::check() {
    wantsCheck_ = false;
    if (verdict_) {
        verdict_.reset();
        return {};
    }
    Result<ViewVerdict> verdict = viewCheck_.check(session_, request());
    if (!verdict)
        return tl::unexpected(verdict.error());
    verdict_ = std::move(*verdict);
    checkedFrom_ = request();
    return {};
}

std::optional<frame::Highlight> Viewer::selectionPulse() const {
    constexpr double kPulse = 1.2; // seconds
    constexpr std::uint32_t kYellow = 0x0040D0FFu;
    if (!picked_ || picked_->object == 0 || picked_->isLandscape)
        return {};
    const double wave = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * request().scene.seconds / kPulse);
    const auto strength = static_cast<std::uint32_t>(std::lround(40.0 + 120.0 * wave));
    return frame::Highlight{picked_->object, kYellow | strength << 24};
}

void Viewer::take(const PanelChoice& choice) {
    if (choice.time != request().scene.time)
        act({play::PlayActKind::Time, choice.time});
    if (choice.dayGroup != request().scene.dayGroup)
        act({play::PlayActKind::Day, static_cast<double>(choice.dayGroup)});
    if (choice.weather != request().scene.weather)
        act({play::PlayActKind::Weather});
    if (choice.doors != request().scene.doors)
        act({play::PlayActKind::AllDoors, choice.doors.value_or(-1.0)});
    if (choice.quality && choice.quality != session_.options().quality)
        act({play::PlayActKind::Quality, static_cast<double>(*choice.quality)});
    if (choice.place >= 0)
        act({play::PlayActKind::Place, static_cast<double>(choice.place)});
    if (choice.rebinding)
        rebinding_ = choice.rebinding;
    if (choice.resetsKeys)
        keepBindings(KeyBindings());
}

void Viewer::overlay() {
    const std::vector<std::uint32_t> ids =
        switches_.ids ? session_.target().readIds() : std::vector<std::uint32_t>{};
    const std::vector<float> distances =
        switches_.depth ? session_.target().readDistances(session_.plan().constants) : std::vector<float>{};
    device_.presentToWindow(session_.target().handle(), request().size.width, request().size.height);
    const engine::FrameFigures figures = session_.figures();
    if (frames_++ > 0) // the first time includes the opening of the window
        times_.add(lastSeconds_, frameSeconds_ * 1e3, figures);
    const std::optional<std::size_t> door = play_.doorInReach();
    const std::string said = noticeText();
    portals_ = !switches_.portals ? std::vector<PortalTrace>{} : frozen_ ? frozen_->portals : portalsNow();
    const ResidencyMap blocks = residency();
    const PanelFacts facts{.world = session_.part().world,
                           .request = request(),
                           .visible = session_.visible(),
                           .plan = session_.plan(),
                           .figures = figures,
                           .times = times_,
                           .body = walk().isOn() ? &walk().body() : nullptr,
                           .door = door ? &session_.part().world.doors[*door] : nullptr,
                           .doorOpens = door && play_.opens(*door),
                           .picked = picked_ ? &*picked_ : nullptr,
                           .verdict = verdict_ ? &*verdict_ : nullptr,
                           .frozen = frozen_ ? &*frozen_ : nullptr,
                           .portals = portals_,
                           .residency = blocks,
                           .quality = session_.options().quality,
                           .places = session_.source().file.places,
                           .ids = ids,
                           .distances = distances,
                           .bindings = bindings_,
                           .rebinding = rebinding_,
                           .notice = said,
                           .greets = isAtStart()};
    const PanelChoice choice = panel_.draw(facts, switches_);
    device_.restoreState();
    take(choice);
}

} // namespace limen::viewer
