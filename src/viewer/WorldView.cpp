#include "viewer/WorldView.h"

#include "core/AbsolutePath.h"
#include "engine/CheckView.h"
#include "output/RegionOverlay.h"
#include "viewer/Screenshots.h"
#include "viewer/SelectionPulse.h"
#include "viewer/panel/PanelParts.h"

#include <fmt/format.h>
#include <utility>

namespace limen::viewer {
namespace {

/// The session options of `shot` that change pictures.
std::string pictureOptions(const engine::Session& session) {
    const engine::SessionOptions& options = session.options();
    const world::LoadOptions usual;
    std::string text;
    if (options.load.radius != usual.radius)
        text += fmt::format(" --radius {}", options.load.radius);
    if (options.load.detail != usual.detail)
        text += fmt::format(" --detail {}", options.load.detail);
    if (session.samples() > 1)
        text += fmt::format(" --msaa {}", session.samples());
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

void FrameWindows::add(double now, double frameMs, double sceneMs, const engine::FrameFigures& figures) {
    frame.add(now, frameMs);
    scene.add(now, sceneMs);
    stages.resize(figures.stages.size());
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i].cpu.add(now, figures.stages[i].cpuMs);
        stages[i].gpu.add(now, figures.stages[i].gpuMs);
    }
}

WorldView::WorldView(gpu::GlDevice& device, OpenedWorld opened)
    : device_(device), session_(std::move(opened.session)), stream_(*session_),
      play_(*session_, std::move(opened.start), &stream_) {}

bool WorldView::needsFrame(const WorldInput& input) const {
    return !input.isPaused || frames_ == 0 || input.percent != percent_ || !acts_.empty() ||
           input.size != request().size || wantsCheck_ || !play_.goingTo().empty() ||
           stream_.streamer().phase() != engine::Streamer::Phase::Idle;
}

Result<void> WorldView::frame(const WorldInput& input) {
    hasStepped_ = needsFrame(input);
    probed_.clear();
    if (!hasStepped_)
        return {};
    if (Result<void> moved = play_.step(takeInput(input)); !moved)
        return moved;
    percent_ = input.percent;
    engine::scaleRequest(request(), percent_, drawn_);
    if (input.clicked) {
        if (Result<void> picked = pick(*input.clicked); !picked)
            return picked;
    }
    if (wantsCheck_) {
        if (Result<void> checked = check(); !checked)
            return checked;
    }
    if (verdict_ && !isSameView(drawn_, checkedFrom_))
        verdict_.reset();
    if (Result<void> drawn = draw(); !drawn)
        return drawn;
    if (probe_)
        probed_ = probe_->see({frames_, request().scene.seconds, session_->part().world, request(),
                               session_->visible(), session_->plan(), session_->figures().glCalls});
    if (frames_++ > 0 && !input.isPaused) // the first time includes loading
        times_.add(input.now, input.frameSeconds * 1e3, sceneMs_, session_->figures());
    return {};
}

Result<void> WorldView::draw() {
    const std::optional<frame::Highlight> pulse = selectionPulse();
    engine::DrawOptions options{.ids = switches_.ids || switches_.depth};
    if (pulse)
        options.highlights = std::span(&*pulse, 1);
    const Result<double> sceneMs = drawTimed(*session_, drawn_, options);
    if (!sceneMs)
        return Failure(sceneMs.error());
    sceneMs_ = *sceneMs;
    ids_ = switches_.ids ? session_->target().readIds() : std::vector<std::uint32_t>{};
    distances_ =
        switches_.depth ? session_->target().readDistances(session_->plan().constants) : std::vector<float>{};
    portals_ = !switches_.portals ? std::vector<PortalTrace>{} : frozen_ ? frozen_->portals : portalsNow();
    return {};
}

void WorldView::present() {
    device_.presentToWindow(session_->target().handle(), request().size.width, request().size.height);
}

std::string WorldView::doorInReach() const {
    const std::optional<std::size_t> door = play_.doorInReach();
    return door ? session_->part().world.doors[*door].name : std::string();
}

std::vector<std::string> WorldView::openDoors() const {
    std::vector<std::string> names;
    const std::vector<world::Door>& doors = session_->part().world.doors;
    for (std::size_t i = 0; i < doors.size(); ++i)
        if (request().scene.doors.value_or(i < request().scene.eachDoor.size() ? request().scene.eachDoor[i]
                                                                               : doors[i].open) > 0.0)
            names.push_back(doors[i].name);
    return names;
}

bool WorldView::press(Action action) {
    switch (action) {
    case Action::Ids:
        switches_.ids = !switches_.ids;
        return true;
    case Action::Depth:
        switches_.depth = !switches_.depth;
        return true;
    case Action::Gate:
        session_->setGate(nextGate(session_->options().gate));
        return true;
    case Action::Regions:
        switches_.regions = !switches_.regions;
        return true;
    case Action::Portals:
        switches_.portals = !switches_.portals;
        return true;
    case Action::Names:
        switches_.names = !switches_.names;
        return true;
    case Action::Panel:
        switches_.panel = !switches_.panel;
        return true;
    case Action::Check:
        wantsCheck_ = true;
        return true;
    case Action::Probe:
        probe_ = probe_ ? std::nullopt : std::make_optional<output::Probe>();
        return true;
    case Action::Freeze:
        freeze();
        return true;
    case Action::Walk:
        act({play::PlayActKind::Walk});
        return true;
    case Action::Chase:
        act({play::PlayActKind::Chase});
        return true;
    case Action::Doors:
        act({play::PlayActKind::Doors});
        return true;
    case Action::Use:
        act({play::PlayActKind::Use});
        return true;
    case Action::Rain:
        act({play::PlayActKind::Weather});
        return true;
    case Action::Later:
        act({play::PlayActKind::Time, std::fmod(request().scene.time + 1.0 / 24.0, 1.0)});
        return true;
    default:
        if (action < Action::Place1)
            return false;
        act({play::PlayActKind::Place, static_cast<double>(action) - static_cast<double>(Action::Place1)});
        return true;
    }
}

Result<std::filesystem::path> WorldView::keepPicture(const std::filesystem::path& directory) {
    if (Result<void> drawn = session_->draw(request(), {}); !drawn)
        return Failure(drawn.error());
    const output::Picture picture =
        output::pictureFromRgba(request().size.width, request().size.height, session_->target().readColour());
    const std::string command = commandOf(request());
    if (Result<void> drawn = draw(); !drawn) // with the pulse and the images of ids again
        return Failure(drawn.error());
    return keepScreenshot(absolutePath(directory), picture, command);
}

std::string WorldView::commandOf(const engine::FrameRequest& request) const {
    return engine::reproduction(session_->part().world, request, session_->source().datOption) +
           pictureOptions(*session_);
}

void WorldView::freeze() {
    if (frozen_)
        frozen_.reset();
    else
        frozen_ = FrozenFlood{engine::viewOf(request().camera, request().size, request().root),
                              session_->visible(), portalsNow()};
}

std::vector<PortalTrace> WorldView::portalsNow() {
    session_->tracePortals(request(), trace_);
    return portalTraces(trace_);
}

ResidencyMap WorldView::residency() const {
    const world::World& world = session_->part().world;
    const dat::BlockCoord here = blockOf(world, request().root, request().camera.eye);
    const dat::BlockCoord player =
        request().scene.body ? blockOf(world, request().scene.body->space, request().scene.body->feet) : here;
    return residencyMap(world, here, player, session_->options().load.radius + 1);
}

const play::PlayInput& WorldView::takeInput(const WorldInput& input) {
    const HeldInput held = input.isPaused ? HeldInput{} : input.held;
    for (const play::PlayAct& done : wheelActs(
             held.wheel, {walk().isOn(), walk().isChased(), walk().distance(), play::WalkingBody::kNearest}))
        act(done);
    input_ = inputOf(held, input.isPaused ? 0.0 : input.seconds);
    input_.isFrozen = verdict_.has_value() || input.isPaused; // the world stops while a verdict is shown
    input_.size = input.size;
    input_.acts = std::exchange(acts_, {});
    return input_;
}

Result<void> WorldView::pick(const PixelPlace& place) {
    if (place.x >= request().size.width || place.y >= request().size.height)
        return {}; // the window has shrunk since the frame
    Result<engine::Picked> picked = session_->pick(request(), place.x, place.y);
    if (!picked)
        return Failure(picked.error());
    const bool isSame = picked_ && picked->object != 0 && picked->object == picked_->object &&
                        picked->meaning.polygon == picked_->meaning.polygon;
    picked_ =
        isSame || picked->meaning.kind == "void" ? std::nullopt : std::make_optional(std::move(*picked));
    return {};
}

Result<void> WorldView::check() {
    wantsCheck_ = false;
    if (verdict_) {
        verdict_.reset();
        return {};
    }
    Result<ViewVerdict> verdict = viewCheck_.check(*session_, drawn_); // the pixels that are shown
    if (!verdict)
        return Failure(verdict.error());
    verdict_ = std::move(*verdict);
    checkedFrom_ = drawn_;
    return {};
}

std::optional<frame::Highlight> WorldView::selectionPulse() const {
    if (!picked_ || picked_->object == 0 || picked_->isLandscape)
        return {};
    return viewer::selectionPulse(picked_->object, request().scene.seconds);
}

void WorldView::take(const PanelChoice& choice) {
    if (choice.time != request().scene.time)
        act({play::PlayActKind::Time, choice.time});
    if (choice.dayGroup != request().scene.dayGroup)
        act({play::PlayActKind::Day, static_cast<double>(choice.dayGroup)});
    if (choice.weather != request().scene.weather)
        act({play::PlayActKind::Weather});
    if (choice.doors != request().scene.doors)
        act({play::PlayActKind::AllDoors, choice.doors.value_or(-1.0)});
    if (choice.quality && choice.quality != session_->options().quality)
        act({play::PlayActKind::Quality, static_cast<double>(*choice.quality)});
    if (choice.gate != session_->options().gate)
        session_->setGate(choice.gate);
    if (choice.place >= 0)
        act({play::PlayActKind::Place, static_cast<double>(choice.place)});
}

void WorldView::drawImages(Overlay& overlay, const PanelFacts& facts) const {
    const engine::PixelSize size = drawn_.size;
    if (facts.verdict != nullptr)
        overlay.drawOver(facts.verdict->picture, 190); // correct pixels stay visible, darkened
    else if (!facts.ids.empty())
        overlay.drawOver(output::pictureOfIds(size.width, size.height, facts.ids), 255);
    else if (!facts.distances.empty())
        overlay.drawOver(output::pictureOfDistances(size.width, size.height, facts.distances), 255);
}

std::optional<ScaleWish> WorldView::drawOverlay(Ui& ui, Overlay& overlay, const KeyBindings& bindings,
                                                const ScaleFacts& scale) {
    const std::optional<std::size_t> door = play_.doorInReach();
    names_ = switches_.names ? nameTags(session_->part().world, session_->dynamics(), session_->visible(),
                                        engine::viewOf(request().camera, request().size, request().root))
                             : std::vector<NameTag>{};
    const ResidencyMap blocks = switches_.panel ? residency() : ResidencyMap{};
    const PanelFacts facts{.world = session_->part().world,
                           .request = request(),
                           .visible = session_->visible(),
                           .plan = session_->plan(),
                           .figures = session_->figures(),
                           .times = times_,
                           .body = walk().isOn() ? &walk().body() : nullptr,
                           .door = door ? &session_->part().world.doors[*door] : nullptr,
                           .doorOpens = door && play_.opens(*door),
                           .isRefused = play_.isRefused(),
                           .picked = picked_ ? &*picked_ : nullptr,
                           .verdict = verdict_ ? &*verdict_ : nullptr,
                           .frozen = frozen_ ? &*frozen_ : nullptr,
                           .portals = portals_,
                           .names = names_,
                           .residency = blocks,
                           .quality = session_->options().quality,
                           .scale = scale,
                           .places = session_->source().file.places,
                           .ids = ids_,
                           .distances = distances_,
                           .bindings = bindings};
    drawImages(overlay, facts);
    panel::drawLines(facts, switches_);
    panel::drawNames(names_);
    panel::drawDoor(facts);
    if (!switches_.panel)
        return std::nullopt;
    PanelChoice choice;
    choice.time = facts.request.scene.time;
    choice.dayGroup = facts.request.scene.dayGroup;
    choice.weather = facts.request.scene.weather;
    choice.doors = facts.request.scene.doors;
    choice.quality = facts.quality;
    choice.gate = session_->options().gate;
    choice.scale = scale.wish;
    const PanelChoice made = panel::drawPanel(ui, facts, choice);
    take(made);
    return made.scale == scale.wish ? std::nullopt : std::make_optional(made.scale);
}

} // namespace limen::viewer
