#include "app/DecisionHash.h"
#include "app/OutputFile.h"
#include "app/Panel.h"
#include "app/Play.h"
#include "app/Probe.h"
#include "app/Screenshots.h"
#include "app/SessionStream.h"
#include "app/ShotRequest.h"
#include "app/Verbs.h"
#include "app/ViewOfEye.h"
#include "app/WalkRecord.h"
#include "app/Window.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

namespace limen::app {
namespace {

struct ViewOptions {
    SessionOptions session;
    ViewArguments view;
    std::string frames, step, screenshot, screenshots, record, keys;
    bool json = false, tell = false, fly = false, chase = false;
};

/// The options of `shot` that are the session's and change pictures.
std::string pictureOptions(const SessionOptions& options) {
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

/// Which keys do what, and the file that says so.
struct Keys {
    KeyBindings bindings;
    std::filesystem::path file; ///< empty: there is no place for one
};

/// The window's frame loop: hands to play, its eye to the frame, the frame to the window.
class Viewer {
public:
    /// Pictures are kept in `screenshots`.
    Viewer(Window& window, gpu::GlDevice& device, Session& session, FrameEye start, Keys keys,
           std::filesystem::path screenshots)
        : window_(window), device_(device), session_(session), panel_(window), stream_(session),
          play_(session, std::move(start), &stream_), bindings_(std::move(keys.bindings)),
          keysFile_(std::move(keys.file)), screenshots_(std::move(screenshots)) {
        lastSeconds_ = window_.seconds();
        device_.restoreState(); // the panel has set up its own things
    }

    /// What is to be done at the beginning of the next frame.
    void act(PlayAct act) { acts_.push_back(act); }

    /// One frame; `fixedSeconds` > 0 takes that for the time since the last one.
    [[nodiscard]] Result<void> frame(double fixedSeconds) {
        window_.poll(panel_.takes(), bindings_);
        const double now = window_.seconds();
        frameSeconds_ = now - lastSeconds_;
        lastSeconds_ = now;
        takeKeys();
        if (Result<void> moved = play_.step(takeInput(fixedSeconds > 0.0 ? fixedSeconds : frameSeconds_));
            !moved)
            return moved;
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
        if (verdict_ && !isSameView(eye(), checkedFrom_))
            verdict_.reset();
        const std::optional<frame::Highlight> pulse = selectionPulse();
        DrawOptions options{.ids = switches_.ids};
        if (pulse)
            options.highlights = std::span(&*pulse, 1);
        if (Result<void> drawn = session_.draw(eye(), options); !drawn)
            return drawn;
        probed_ = probe_ ? probe_->see({frames_, eye().seconds, session_.loaded().world, eye(),
                                        session_.visible(), session_.plan(), session_.figures().glCalls})
                         : std::string();
        overlay();
        return {};
    }

    /// Nobody sees the window: nothing is drawn and no time passes until something happens to it.
    void rest() {
        window_.rest();
        lastSeconds_ = window_.seconds();
    }

    /// What changed with the last frame in what was decided, if that is to be told.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    [[nodiscard]] bool isLeaving() const { return leaving_ || window_.wantsToClose(); }
    [[nodiscard]] const FrameEye& eye() const { return play_.eye(); }
    [[nodiscard]] const PlayInput& input() const { return input_; }
    [[nodiscard]] SessionStream& stream() { return stream_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const Walk& walk() const { return play_.walk(); }
    /// The name of the door that a key would open or shut; empty: none.
    [[nodiscard]] std::string doorInReach() const {
        const std::optional<std::size_t> door = play_.doorInReach();
        return door ? session_.loaded().world.doors[*door].name : std::string();
    }
    /// What is said over the picture just now.
    [[nodiscard]] std::string noticeText() const {
        return lastSeconds_ < notice_.until ? notice_.text : std::string();
    }
    [[nodiscard]] const std::optional<Rebinding>& rebinding() const { return rebinding_; }
    [[nodiscard]] const KeyBindings& bindings() const { return bindings_; }
    [[nodiscard]] std::span<const PortalSight> portals() const { return portals_; }
    [[nodiscard]] WindowSizes sizes() const { return window_.sizes(); }
    /// Of the flood that is kept; none is: 0.
    [[nodiscard]] std::size_t frozenVisits() const { return frozen_ ? frozen_->visible.visits.size() : 0; }
    /// Names of doors that stand open, as far as they are loaded.
    [[nodiscard]] std::vector<std::string> openDoors() const {
        std::vector<std::string> names;
        const std::vector<world::Door>& doors = session_.loaded().world.doors;
        for (std::size_t i = 0; i < doors.size(); ++i) {
            if (eye().doors.value_or(i < eye().eachDoor.size() ? eye().eachDoor[i] : doors[i].open) > 0.0)
                names.push_back(doors[i].name);
        }
        return names;
    }

private:
    /// What keys and buttons ask for; while a key is waited for, the next one is that.
    void takeKeys() {
        if (rebinding_ && !window_.pressedKeys().empty()) {
            rebind(window_.pressedKeys().front());
            return;
        }
        for (const Action action : window_.pressed())
            press(action);
    }

    void press(Action action) {
        switch (action) {
        case Action::Help:
            switches_.help = !switches_.help;
            return;
        case Action::Ids:
            switches_.ids = !switches_.ids;
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
            probe_ = probe_ ? std::nullopt : std::make_optional<Probe>();
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
            return act({PlayAct::Kind::Walk});
        case Action::Chase:
            return act({PlayAct::Kind::Chase});
        case Action::Doors:
            return act({PlayAct::Kind::Doors});
        case Action::Use:
            return act({PlayAct::Kind::Use});
        case Action::Rain:
            return act({PlayAct::Kind::Weather});
        case Action::Later:
            return act({PlayAct::Kind::Time, std::fmod(eye().time + 1.0 / 24.0, 1.0)});
        case Action::Leave:
            leaving_ = true;
            return;
        default:
            if (action >= Action::Place1)
                act({PlayAct::Kind::Place,
                     static_cast<double>(action) - static_cast<double>(Action::Place1)});
        }
    }

    /// The key that was waited for does that from now on, in the file as well. Escape: nothing changes.
    void rebind(KeyCode key) {
        const Rebinding wanted = *std::exchange(rebinding_, std::nullopt);
        if (key == keyNamed("Escape"))
            return;
        KeyBindings changed = bindings_;
        changed.bind(wanted.action, key, wanted.adds);
        keepBindings(std::move(changed));
    }

    void keepBindings(KeyBindings bindings) {
        bindings_ = std::move(bindings);
        const Result<void> written = writeKeyBindings(keysFile_, bindings_);
        notice(written ? "keys kept in " + keysFile_.string() : written.error().message());
    }

    /// The frame without what lies over it, in a file, and what draws it again.
    Result<void> keepPicture() {
        wantsPicture_ = false;
        if (Result<void> drawn = session_.draw(eye(), {}); !drawn)
            return drawn;
        const Picture picture =
            pictureFromRgba(eye().size.width, eye().size.height, session_.target().readColour());
        const Result<std::filesystem::path> kept =
            keepScreenshot(screenshots_, picture,
                           reproduction(session_.loaded().world, eye(), session_.source().datOption) +
                               pictureOptions(session_.options()));
        notice(kept ? kept->string() : kept.error().message()); // a full disk is no reason to leave
        return {};
    }

    /// Says something over the picture for a while.
    void notice(std::string text) {
        constexpr double kShown = 4.0; // seconds
        notice_ = {std::move(text), lastSeconds_ + kShown};
    }

    /// The last frame's flood is kept, to be flown around; once more: no longer.
    void freeze() {
        if (frozen_)
            frozen_.reset();
        else
            frozen_ =
                FrozenFlood{viewOf(eye().camera, eye().size, eye().root), session_.visible(), portalsNow()};
    }

    /// What becomes of portals in the last frame's flood.
    std::vector<PortalSight> portalsNow() {
        session_.tracePortals(eye(), trace_);
        return portalSights(trace_);
    }

    /// The landblocks around eye and player.
    [[nodiscard]] ResidencyMap residency() const {
        const world::World& world = session_.loaded().world;
        const dat::BlockCoord here = blockOf(world, eye().root, eye().camera.eye);
        const dat::BlockCoord player =
            eye().body ? blockOf(world, eye().body->space, eye().body->feet) : here;
        return residencyMap(world, here, player, session_.options().load.radius + 1);
    }

    /// What hands ask of this frame.
    const PlayInput& takeInput(double seconds) {
        const HeldInput& held = window_.held();
        for (const PlayAct& done :
             wheelActs(held.wheel, {walk().isOn(), walk().isChased(), walk().distance(), Walk::kNearest}))
            act(done);
        input_ = inputOf(held, seconds);
        input_.isFrozen = verdict_.has_value(); // the world stands still under a verdict
        input_.size = window_.size();
        input_.acts = std::exchange(acts_, {});
        return input_;
    }

    /// What is there is told in the panel; the same thing again, or the void: nothing is any more.
    Result<void> pick(const PixelPlace& place) {
        if (place.x >= eye().size.width || place.y >= eye().size.height)
            return {}; // the window has shrunk since
        Result<Picked> picked = session_.pick(eye(), place.x, place.y);
        if (!picked)
            return tl::unexpected(picked.error());
        const bool isSame = picked_ && picked->object != 0 && picked->object == picked_->object &&
                            picked->meaning.polygon == picked_->meaning.polygon;
        picked_ =
            isSame || picked->meaning.kind == "void" ? std::nullopt : std::make_optional(std::move(*picked));
        return {};
    }

    /// Holds what is seen against the ray rule and shows what that says, until that changes; once more: no longer.
    Result<void> check() {
        wantsCheck_ = false;
        if (verdict_) {
            verdict_.reset();
            return {};
        }
        Result<ViewVerdict> verdict = viewCheck_.check(session_, eye());
        if (!verdict)
            return tl::unexpected(verdict.error());
        verdict_ = std::move(*verdict);
        checkedFrom_ = eye();
        return {};
    }

    static bool isSameView(const FrameEye& a, const FrameEye& b) {
        return a.camera.eye == b.camera.eye && a.camera.heading.yaw == b.camera.heading.yaw &&
               a.camera.heading.pitch == b.camera.heading.pitch && a.size.width == b.size.width &&
               a.size.height == b.size.height && a.time == b.time && a.weather == b.weather &&
               a.doors == b.doors && a.eachDoor == b.eachDoor && a.body == b.body;
    }

    /// The picked object comes and goes in yellow. Not the landscape: one object is a block of it, and half the window.
    [[nodiscard]] std::optional<frame::Highlight> selectionPulse() const {
        constexpr double kPulse = 1.2; // seconds
        constexpr std::uint32_t kYellow = 0x0040D0FFu;
        if (!picked_ || picked_->object == 0 || picked_->isLandscape)
            return {};
        const double wave = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * eye().seconds / kPulse);
        const auto strength = static_cast<std::uint32_t>(std::lround(40.0 + 120.0 * wave));
        return frame::Highlight{picked_->object, kYellow | strength << 24};
    }

    /// What was chosen in the panel is done in the next frame.
    void take(const PanelChoice& choice) {
        if (choice.time != eye().time)
            act({PlayAct::Kind::Time, choice.time});
        if (choice.weather != eye().weather)
            act({PlayAct::Kind::Weather});
        if (choice.doors != eye().doors)
            act({PlayAct::Kind::AllDoors, choice.doors.value_or(-1.0)});
        if (choice.quality && choice.quality != session_.options().quality)
            act({PlayAct::Kind::Quality, static_cast<double>(*choice.quality)});
        if (choice.place >= 0)
            act({PlayAct::Kind::Place, static_cast<double>(choice.place)});
        if (choice.rebinding)
            rebinding_ = choice.rebinding;
        if (choice.keysAsAtFirst)
            keepBindings(KeyBindings());
    }

    /// The overlay stage, over the frame in the window.
    void overlay() {
        const std::vector<std::uint32_t> ids =
            switches_.ids ? session_.target().readIds() : std::vector<std::uint32_t>{};
        device_.presentToWindow(session_.target().handle(), eye().size.width, eye().size.height);
        const FrameFigures figures = session_.figures();
        if (frames_++ > 0) // the first is no frame: it began when the window opened
            times_.add(lastSeconds_, frameSeconds_ * 1e3, figures);
        const std::optional<std::size_t> door = play_.doorInReach();
        const std::string said = noticeText();
        portals_ = !switches_.portals ? std::vector<PortalSight>{}
                   : frozen_          ? frozen_->portals
                                      : portalsNow();
        const ResidencyMap blocks = residency();
        const PanelFacts facts{.world = session_.loaded().world,
                               .eye = eye(),
                               .visible = session_.visible(),
                               .plan = session_.plan(),
                               .figures = figures,
                               .times = times_,
                               .body = walk().isOn() ? &walk().body() : nullptr,
                               .door = door ? &session_.loaded().world.doors[*door] : nullptr,
                               .doorOpens = door && play_.opens(*door),
                               .picked = picked_ ? &*picked_ : nullptr,
                               .verdict = verdict_ ? &*verdict_ : nullptr,
                               .frozen = frozen_ ? &*frozen_ : nullptr,
                               .portals = portals_,
                               .residency = blocks,
                               .quality = session_.options().quality,
                               .places = session_.source().file.places,
                               .ids = ids,
                               .bindings = bindings_,
                               .rebinding = rebinding_,
                               .notice = said};
        const PanelChoice choice = panel_.draw(facts, switches_);
        device_.restoreState();
        take(choice);
    }

    Window& window_;
    gpu::GlDevice& device_;
    Session& session_;
    Panel panel_;
    SessionStream stream_;
    Play play_;
    PlayInput input_;
    std::vector<PlayAct> acts_; ///< of the next frame
    KeyBindings bindings_;
    std::filesystem::path keysFile_;
    std::optional<Rebinding> rebinding_; ///< a key is waited for
    struct Notice {
        std::string text;
        double until = 0.0; ///< as Window::seconds
    };
    Notice notice_;
    OverlaySwitches switches_;
    std::optional<Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false, wantsPicture_ = false;
    std::filesystem::path screenshots_; ///< the directory for pictures
    std::optional<Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< on the view from checkedFrom_
    FrameEye checkedFrom_;
    std::optional<FrozenFlood> frozen_;
    visibility::FloodTrace trace_;
    std::vector<PortalSight> portals_; ///< that are shown
    double lastSeconds_ = 0.0;
    double frameSeconds_ = 0.0; ///< since the last frame
    FrameWindows times_;
    std::uint64_t frames_ = 0;
    bool leaving_ = false;
};

/// Where and how the window opens.
struct Opening {
    ViewRequest view;
    Standpoint stand;
};

/// As the options say; without a position at the world's first place.
Result<Opening> openingOf(const ViewOptions& options, const world::WorldFile& file) {
    ViewArguments arguments = options.view;
    const bool nowhere = arguments.eye.empty() && arguments.at.empty();
    const world::Place* place = nowhere ? firstPlace(file) : nullptr;
    if (nowhere && place == nullptr)
        return fail(ErrorCode::BadArgument, "--eye",
                    "this world's world.json names no place to begin at; give --eye X,Y,Z or --at PLACE");
    if (nowhere)
        arguments.eye = "0,0,0"; // stands for the place while the rest is checked
    Result<ViewRequest> view = checkView(arguments);
    if (!view)
        return tl::unexpected(view.error());
    Result<Standpoint> stand = nowhere ? standpointAt(*place) : standpointOf(*view, file);
    if (!stand)
        return tl::unexpected(stand.error());
    stand->camera.fovDegrees = view->fov;
    return Opening{std::move(*view), std::move(*stand)};
}

/// Of the file that was named, or the one in the user's configuration, if that is there.
Result<Keys> keysOf(const ViewOptions& options) {
    const bool isNamed = !options.keys.empty();
    std::filesystem::path file = isNamed ? std::filesystem::path(options.keys) : keysPath();
    return readKeyBindings(file, isNamed).map([&](KeyBindings bindings) {
        return Keys{std::move(bindings), std::move(file)};
    });
}

/// How the window's frames go on.
struct Script {
    std::size_t frames = 0; ///< leaves after so many; 0: when somebody does
    double step = 0.0;      ///< seconds that each takes; 0: what the clock says
    Keys keys;
};

Result<Script> scriptOf(const ViewOptions& options) {
    constexpr double kStep = 1.0 / 60.0; // with --frames the result must not depend on the machine's speed
    Script script;
    if (!options.frames.empty()) {
        const Result<double> frames = parseNumberBetween("--frames", options.frames, 1.0, 1e9);
        if (!frames)
            return tl::unexpected(frames.error());
        script.frames = static_cast<std::size_t>(*frames);
        script.step = kStep;
    }
    if (!options.step.empty()) {
        const Result<double> step = parseNumberBetween("--step", options.step, 0.001, 1.0);
        if (!step)
            return tl::unexpected(step.error());
        script.step = *step;
    }
    if (!options.screenshot.empty() && script.frames == 0)
        return fail(ErrorCode::BadArgument, "--screenshot",
                    "is taken of the last frame; give --frames N as well");
    Result<Keys> keys = keysOf(options);
    if (!keys)
        return tl::unexpected(keys.error());
    script.keys = std::move(*keys);
    return script;
}

nlohmann::ordered_json pickedJson(const std::optional<Picked>& picked) {
    if (!picked)
        return nullptr;
    const IdMeaning& meaning = picked->meaning;
    return {{"kind", meaning.kind},       {"record", meaning.record}, {"object", meaning.object},
            {"polygon", meaning.polygon}, {"space", meaning.space},   {"chain", picked->chain}};
}

nlohmann::ordered_json verdictJson(const std::optional<ViewVerdict>& verdict) {
    if (!verdict)
        return nullptr;
    return {{"pixels", verdict->comparison.verdicts.size()}, {"wrong", verdict->comparison.findings()}};
}

/// How many portals came to what, as far as they are shown.
nlohmann::ordered_json fatesJson(std::span<const PortalSight> portals) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    const auto counts = countFates(portals);
    for (std::size_t i = counts.size(); i-- > 0;) {
        if (counts[i] > 0)
            json[std::string(nameOf(static_cast<visibility::PortalFate>(i)))] = counts[i];
    }
    return json;
}

std::string stateJson(const Session& session, const Viewer& viewer, std::size_t frames) {
    const FrameEye& eye = viewer.eye();
    const nlohmann::ordered_json json{
        {"frames", frames},
        {"eye", {eye.camera.eye.x, eye.camera.eye.y, eye.camera.eye.z}},
        {"yaw", eye.camera.heading.yaw},
        {"pitch", eye.camera.heading.pitch},
        {"root", spaceName(session.loaded().world, eye.root)},
        {"seconds", eye.seconds},
        {"time", eye.time},
        {"weather", eye.weather == Weather::Rain ? "rain" : "clear"},
        {"doors", eye.doors ? nlohmann::ordered_json(*eye.doors) : nlohmann::ordered_json(nullptr)},
        {"open_doors", viewer.openDoors()},
        {"visits", session.visible().visits.size()},
        {"overlays",
         {{"help", viewer.switches().help},
          {"ids", viewer.switches().ids},
          {"regions", viewer.switches().regions},
          {"portals", viewer.switches().portals},
          {"panel", viewer.switches().panel}}},
        {"walking", viewer.walk().isOn()},
        {"chased", viewer.walk().isChased()},
        {"frozen_visits", viewer.frozenVisits()},
        {"portals", fatesJson(viewer.portals())},
        {"ui_scale", uiScaleOf(viewer.sizes()).units},
        {"body", bodyJson(session.loaded().world, eye.body)},
        {"on_ground", viewer.walk().isOn() && viewer.walk().body().isOnGround},
        {"picked", pickedJson(viewer.picked())},
        {"checked", verdictJson(viewer.verdict())},
        {"size", {eye.size.width, eye.size.height}},
        {"distance", viewer.walk().distance()},
        {"door", viewer.doorInReach()},
        {"notice", viewer.noticeText()},
        {"rebinding", viewer.rebinding() ? nlohmann::ordered_json(factsOf(viewer.rebinding()->action).name)
                                         : nlohmann::ordered_json(nullptr)},
        {"keys", nlohmann::ordered_json::parse(keyBindingsJson(viewer.bindings()))},
        {"gl_calls", session.figures().glCalls}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n"; // paths are any bytes
}

Result<Exit> loop(Window& window, gpu::GlDevice& device, Session& session, const FrameEye& start,
                  Script script, const ViewOptions& options, const Console& console) {
    Viewer viewer(window, device, session, start, std::move(script.keys), options.screenshots);
    if (!options.fly)
        viewer.act({PlayAct::Kind::Walk});
    if (options.chase)
        viewer.act({PlayAct::Kind::Chase});
    std::size_t frames = 0;
    std::string record =
        beginningLine(check::shotOptions(viewOf(start, session.loaded().world)), session.options().load);
    while (!viewer.isLeaving() && !window.isLost() && (script.frames == 0 || frames < script.frames)) {
        if (script.frames == 0 && !window.isShown()) {
            viewer.rest();
            continue;
        }
        if (Result<void> drawn = viewer.frame(script.step); !drawn)
            return tl::unexpected(drawn.error());
        ++frames;
        if (!options.record.empty())
            record +=
                frameLine({viewer.input(), decisionHash(viewer.eye(), session.visible(), session.moment()),
                           viewer.stream().shown()});
        if (const std::string fault = viewer.stream().takeFault(); !fault.empty())
            console.note("limen: what is near cannot be loaded: " + fault);
        if (!viewer.probed().empty())
            console.data(viewer.probed());
        if (frames == script.frames && !options.screenshot.empty()) {
            if (Result<void> written = writePicture(options.screenshot, window.read()); !written)
                return tl::unexpected(written.error());
        }
        window.show();
        if (options.tell) {
            console.data(stateJson(session, viewer, frames));
            (void)console.flush();
        }
    }
    if (!options.record.empty()) {
        if (Result<void> written = writeFile(options.record, record); !written)
            return tl::unexpected(written.error());
    }
    if (window.isLost())
        return fail(ErrorCode::Driver, "view", "the display has gone away");
    if (options.json)
        console.data(stateJson(session, viewer, frames));
    return Exit::Done;
}

Result<Exit> runView(const ViewOptions& options, const Console& console) {
    Result<Script> script = scriptOf(options);
    if (!script)
        return tl::unexpected(script.error());
    for (const std::string& output : {options.screenshot, options.record}) {
        if (Result<void> writable = output.empty() ? Result<void>{} : checkWritable(output); !writable)
            return tl::unexpected(writable.error());
    }
    if (Result<void> made = options.screenshots.empty() ? Result<void>{} : makeDirectory(options.screenshots);
        !made)
        return tl::unexpected(made.error());
    Result<WorldSource> source = openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    const Result<Opening> opening = openingOf(options, source->file);
    if (!opening)
        return tl::unexpected(opening.error());
    const Result<std::unique_ptr<Window>> window = Window::open("Limen", opening->view.size);
    if (!window)
        return tl::unexpected(window.error());
    const Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return tl::unexpected(device.error());
    Session session(std::make_shared<const WorldSource>(std::move(*source)), options.session, **device);
    if (Result<void> loaded = session.load(opening->stand.centre); !loaded)
        return tl::unexpected(loaded.error());
    Result<FrameEye> start = placeEye(session.loaded(), opening->stand, opening->view.size);
    if (!start)
        return tl::unexpected(start.error());
    if (Result<void> applied = applyMoment(session.loaded(), session.source().file, opening->view, *start);
        !applied)
        return tl::unexpected(applied.error());
    return loop(**window, **device, session, *start, std::move(*script), options, console);
}

/// The keys as they are without a file.
std::string keysFooter() {
    std::string text = "What keys do, with the names for --keys:\n";
    for (const HelpLine& line : helpLines(KeyBindings()))
        text += fmt::format("  {:<24}{:<12}{}\n", line.keys, line.action ? factsOf(*line.action).name : "",
                            line.does);
    return text;
}

} // namespace

void addViewVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("view", "opens a window to walk through a world");
    const auto options = std::make_shared<ViewOptions>();
    options->session.load.farRadius = 12;
    addViewOptions(*verb, options->view);
    verb->add_option("--frames", options->frames, "leaves after N frames, for scripts")
        ->type_name("N")
        ->group("Scripts");
    verb->add_option("--step", options->step,
                     "every frame takes so long, however long it takes (default: what the clock says; with "
                     "--frames 1/60)")
        ->type_name("SECONDS")
        ->group("Scripts");
    verb->add_option("--screenshots", options->screenshots,
                     "directory for the pictures that a key keeps (default: the current one)")
        ->type_name("DIR")
        ->group("View");
    verb->add_option("--screenshot", options->screenshot, "the window's last frame, PNG")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_option("--record", options->record,
                     "what was done in each frame, for the --walk of tour, probe and check")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_flag("--fly", options->fly, "begins flying; G changes that")->group("View");
    verb->add_flag("--chase", options->chase, "begins with the eye behind the body; C changes that")
        ->group("View")
        ->excludes("--fly");
    verb->add_flag("--json", options->json, "prints eye, root and overlays on leaving")->group("Scripts");
    verb->add_flag("--tell", options->tell, "prints the same after every frame, a line each")
        ->group("Scripts");
    addSessionOptions(*verb, options->session);
    verb->add_option("--keys", options->keys,
                     "which keys do what, JSON; the help page in the window writes it (default: "
                     "limen/keys.json in the user's configuration)")
        ->type_name("FILE")
        ->group("View");
    verb->footer(keysFooter());
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runView(*options, console); };
    });
}

} // namespace limen::app
