#include "app/FlyCamera.h"
#include "app/OutputFile.h"
#include "app/Panel.h"
#include "app/Probe.h"
#include "app/RootTracker.h"
#include "app/Session.h"
#include "app/ShotRequest.h"
#include "app/Verbs.h"
#include "app/Walk.h"
#include "app/Window.h"
#include "motion/DoorUse.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

namespace limen::app {
namespace {

struct ViewOptions {
    SessionOptions session;
    ViewArguments view;
    std::string frames, screenshot;
    bool json = false, fly = false;
};

/// The window's frame loop: hands to camera, camera to frame, frame to window.
class Viewer {
public:
    Viewer(Window& window, gpu::GlDevice& device, Session& session, FrameEye start)
        : window_(window), device_(device), session_(session), panel_(window), eye_(std::move(start)),
          tracker_(eye_.root) {
        lastSeconds_ = window_.seconds();
        device_.restoreState(); // the panel has set up its own things
    }

    /// One frame; `fixedSeconds` > 0 takes that for the time since the last one.
    [[nodiscard]] Result<void> frame(double fixedSeconds) {
        window_.poll(panel_.takesMouse());
        const double now = window_.seconds();
        const double real = now - lastSeconds_;
        const double elapsed = fixedSeconds > 0.0 ? fixedSeconds : real;
        lastSeconds_ = now;
        frameSeconds_ = real;
        for (const Key key : window_.pressed())
            press(key);
        if (Result<void> moved = moveEye(elapsed); !moved)
            return moved;
        moveDoors(elapsed);
        findDoor();
        eye_.size = window_.size();
        if (!verdict_)
            eye_.seconds += elapsed; // the world stands still under a verdict
        if (const std::optional<PixelPlace> clicked = window_.clicked()) {
            if (Result<void> picked = pick(*clicked); !picked)
                return picked;
        }
        if (wantsCheck_) {
            if (Result<void> checked = check(); !checked)
                return checked;
        }
        if (verdict_ && !isSameView(eye_, checkedFrom_))
            verdict_.reset();
        const std::optional<frame::Highlight> pulse = selectionPulse();
        DrawOptions options{.ids = switches_.ids};
        if (pulse)
            options.highlights = std::span(&*pulse, 1);
        if (Result<void> drawn = session_.draw(eye_, options); !drawn)
            return drawn;
        probed_ = probe_ ? probe_->see({frames_, eye_.seconds, session_.loaded().world, eye_,
                                        session_.visible(), session_.plan(), session_.figures().glCalls})
                         : std::string();
        overlay();
        return {};
    }

    /// What changed with the last frame in what was decided, if that is to be told.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    [[nodiscard]] bool isLeaving() const { return leaving_ || window_.wantsToClose(); }
    [[nodiscard]] const FrameEye& eye() const { return eye_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const Walk& walk() const { return walk_; }
    /// Names of doors that stand open, as far as they are loaded.
    [[nodiscard]] std::vector<std::string> openDoors() const {
        std::vector<std::string> names;
        const std::vector<world::Door>& doors = session_.loaded().world.doors;
        for (std::size_t i = 0; i < doors.size(); ++i) {
            if (eye_.doors.value_or(i < eye_.eachDoor.size() ? eye_.eachDoor[i] : doors[i].open) > 0.0)
                names.push_back(doors[i].name);
        }
        return names;
    }
    /// Stands where the eye is, and falls to the ground. What cannot be walked on is flown over.
    void beginToWalk() {
        if (!walk_.begin(session_, eye_))
            walk_.end();
    }

private:
    void press(Key key) {
        switch (key) {
        case Key::Help:
            switches_.help = !switches_.help;
            return;
        case Key::Ids:
            switches_.ids = !switches_.ids;
            return;
        case Key::Regions:
            switches_.regions = !switches_.regions;
            return;
        case Key::Panel:
            switches_.panel = !switches_.panel;
            return;
        case Key::Check:
            wantsCheck_ = true;
            return;
        case Key::Probe:
            probe_ = probe_ ? std::nullopt : std::make_optional<Probe>();
            return;
        case Key::Walk:
            walk_.isOn() ? walk_.end() : beginToWalk();
            tracker_.place(eye_.root);
            return;
        case Key::Doors:
            swingDoors();
            return;
        case Key::Use:
            useDoor();
            return;
        case Key::Rain:
            eye_.weather = eye_.weather == Weather::Rain ? Weather::Clear : Weather::Rain;
            return;
        case Key::Later:
            eye_.time = std::fmod(eye_.time + 1.0 / 24.0, 1.0);
            return;
        case Key::Leave:
            leaving_ = true;
            return;
        default:
            goTo(static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::Place1));
        }
    }

    /// What is there is told in the panel; the same thing again, or the void: nothing is any more.
    Result<void> pick(const PixelPlace& place) {
        if (place.x >= eye_.size.width || place.y >= eye_.size.height)
            return {}; // the window has shrunk since
        Result<Picked> picked = session_.pick(eye_, place.x, place.y);
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
        Result<ViewVerdict> verdict = viewCheck_.check(session_, eye_);
        if (!verdict)
            return tl::unexpected(verdict.error());
        verdict_ = std::move(*verdict);
        checkedFrom_ = eye_;
        return {};
    }

    static bool isSameView(const FrameEye& a, const FrameEye& b) {
        return a.camera.eye == b.camera.eye && a.camera.heading.yaw == b.camera.heading.yaw &&
               a.camera.heading.pitch == b.camera.heading.pitch && a.size.width == b.size.width &&
               a.size.height == b.size.height && a.time == b.time && a.weather == b.weather &&
               a.doors == b.doors && a.eachDoor == b.eachDoor;
    }

    /// The picked object comes and goes in yellow. Not the landscape: one object is a block of it, and half the window.
    [[nodiscard]] std::optional<frame::Highlight> selectionPulse() const {
        constexpr double kPulse = 1.2; // seconds
        constexpr std::uint32_t kYellow = 0x0040D0FFu;
        if (!picked_ || picked_->object == 0 || picked_->isLandscape)
            return {};
        const double wave = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * eye_.seconds / kPulse);
        const auto strength = static_cast<std::uint32_t>(std::lround(40.0 + 120.0 * wave));
        return frame::Highlight{picked_->object, kYellow | strength << 24};
    }

    /// All doors open, or shut if they are open or opening. They take a second.
    void swingDoors() {
        const double towards = doorsTowards_.value_or(eye_.doors.value_or(0.0));
        doorsTowards_ = towards < 0.5 ? 1.0 : 0.0;
        if (!eye_.doors)
            eye_.doors = 1.0 - *doorsTowards_;
    }

    /// The one in reach of a body, which is told of.
    void findDoor() {
        const world::World& world = session_.loaded().world;
        const Vec3 forward = viewOf(eye_.camera, eye_.size, eye_.root).forward;
        door_ = walk_.isOn() ? motion::doorInReach(world, eye_.root, eye_.camera.eye, forward) : std::nullopt;
    }

    /// From here on doors stand each as it was left.
    void useDoor() {
        if (!door_)
            return;
        const world::World& world = session_.loaded().world;
        if (eye_.doors)
            doors_.putAll(world, *eye_.doors);
        eye_.doors.reset();
        doorsTowards_.reset();
        doors_.use(world.doors[*door_]);
    }

    void moveDoors(double seconds) {
        const world::World& world = session_.loaded().world;
        doors_.pass(verdict_ ? 0.0 : seconds, world,
                    walk_.isOn() ? std::make_optional(walk_.body().standing) : std::nullopt);
        doors_.write(world, eye_.eachDoor);
        if (!doorsTowards_ || !eye_.doors)
            return;
        const double way = *doorsTowards_ - *eye_.doors;
        eye_.doors = *eye_.doors + std::clamp(way, -seconds, seconds);
        if (*eye_.doors == *doorsTowards_)
            doorsTowards_.reset();
    }

    void take(const PanelChoice& choice) {
        eye_.time = choice.time;
        eye_.weather = choice.weather;
        if (choice.doors != eye_.doors)
            doorsTowards_.reset(); // a hand is on them
        eye_.doors = choice.doors;
        if (choice.place >= 0)
            goTo(static_cast<std::size_t>(choice.place));
    }

    void goTo(std::size_t place) {
        const std::vector<world::Place>& places = session_.source().file.places;
        if (place >= places.size())
            return;
        const Standpoint stand = standpointAt(places[place]);
        if (!session_.load(stand.centre))
            return; // its part of the world cannot be loaded: stay
        Result<FrameEye> eye = placeEye(session_.loaded(), stand, eye_.size);
        if (!eye)
            return;
        eye->camera.fovDegrees = eye_.camera.fovDegrees;
        eye->time = eye_.time;
        eye->weather = eye_.weather;
        eye->seconds = eye_.seconds;
        eye->doors = eye_.doors;
        doors_.write(session_.loaded().world, eye->eachDoor);
        eye_ = std::move(*eye);
        tracker_.place(eye_.root);
        if (walk_.isOn())
            beginToWalk();
    }

    Result<void> moveEye(double seconds) {
        constexpr double kDegreesPerPixel = 0.15;
        const HeldInput& held = window_.held();
        const auto axis = [](bool plus, bool minus) { return (plus ? 1.0 : 0.0) - (minus ? 1.0 : 0.0); };
        FlyInput input;
        input.forward = axis(held.forward, held.back);
        input.right = axis(held.right, held.left);
        input.up = walk_.isOn() ? 0.0 : axis(held.up, held.down);
        input.turnRight = held.lookX * kDegreesPerPixel;
        input.turnUp = -held.lookY * kDegreesPerPixel;
        input.fast = held.fast;
        input.seconds = seconds;
        if (walk_.isOn()) {
            eye_.camera = fly(eye_.camera, {.turnRight = input.turnRight, .turnUp = input.turnUp});
            if (Result<void> stepped =
                    walk_.step(session_, {input.forward, input.right, input.fast, held.jump, seconds}, eye_);
                !stepped)
                return stepped;
        } else {
            const Vec3 from = eye_.camera.eye;
            eye_.camera = fly(eye_.camera, input);
            eye_.player = eye_.camera.eye;
            eye_.root = tracker_.move(session_.loaded().world, from, eye_.camera.eye, seconds);
        }
        if (session_.follow(eye_.camera.eye, eye_.root)) {
            tracker_.place(eye_.root);
            if (walk_.isOn())
                return walk_.step(session_, {}, eye_); // its space has another number now
        }
        return {};
    }

    /// The overlay stage, over the frame in the window.
    void overlay() {
        const std::vector<std::uint32_t> ids =
            switches_.ids ? session_.target().readIds() : std::vector<std::uint32_t>{};
        device_.presentToWindow(session_.target().handle(), eye_.size.width, eye_.size.height);
        const FrameFigures figures = session_.figures();
        if (frames_++ > 0) // the first is no frame: it began when the window opened
            times_.add(lastSeconds_, frameSeconds_ * 1e3, figures);
        const PanelFacts facts{.world = session_.loaded().world,
                               .eye = eye_,
                               .visible = session_.visible(),
                               .plan = session_.plan(),
                               .figures = figures,
                               .times = times_,
                               .body = walk_.isOn() ? &walk_.body() : nullptr,
                               .door = door_ ? &session_.loaded().world.doors[*door_] : nullptr,
                               .doorOpens = door_ && doors_.opens(session_.loaded().world.doors[*door_]),
                               .picked = picked_ ? &*picked_ : nullptr,
                               .verdict = verdict_ ? &*verdict_ : nullptr,
                               .places = session_.source().file.places,
                               .ids = ids};
        const PanelChoice choice = panel_.draw(facts, switches_);
        device_.restoreState();
        take(choice);
    }

    Window& window_;
    gpu::GlDevice& device_;
    Session& session_;
    Panel panel_;
    FrameEye eye_;
    RootTracker tracker_;
    Walk walk_;
    OverlaySwitches switches_;
    std::optional<Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false;
    std::optional<Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< on the view from checkedFrom_
    FrameEye checkedFrom_;
    std::optional<double> doorsTowards_; ///< where all doors are swinging to, 0 or 1
    motion::DoorUse doors_;
    std::optional<std::size_t> door_; ///< in reach of the body
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

Result<std::size_t> frameLimit(const ViewOptions& options) {
    if (options.frames.empty())
        return std::size_t{0};
    const Result<double> frames = parseNumberBetween("--frames", options.frames, 1.0, 1e9);
    if (!frames)
        return tl::unexpected(frames.error());
    return static_cast<std::size_t>(*frames);
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

std::string stateJson(const Session& session, const Viewer& viewer, std::size_t frames) {
    const FrameEye& eye = viewer.eye();
    const nlohmann::ordered_json json{
        {"frames", frames},
        {"eye", {eye.camera.eye.x, eye.camera.eye.y, eye.camera.eye.z}},
        {"yaw", eye.camera.heading.yaw},
        {"pitch", eye.camera.heading.pitch},
        {"root", spaceName(session.loaded().world, eye.root)},
        {"time", eye.time},
        {"weather", eye.weather == Weather::Rain ? "rain" : "clear"},
        {"doors", eye.doors ? nlohmann::ordered_json(*eye.doors) : nlohmann::ordered_json(nullptr)},
        {"open_doors", viewer.openDoors()},
        {"visits", session.visible().visits.size()},
        {"overlays",
         {{"help", viewer.switches().help},
          {"ids", viewer.switches().ids},
          {"regions", viewer.switches().regions},
          {"panel", viewer.switches().panel}}},
        {"walking", viewer.walk().isOn()},
        {"on_ground", viewer.walk().isOn() && viewer.walk().body().isOnGround},
        {"picked", pickedJson(viewer.picked())},
        {"checked", verdictJson(viewer.verdict())},
        {"gl_calls", session.figures().glCalls}};
    return json.dump() + "\n";
}

Result<Exit> loop(Window& window, gpu::GlDevice& device, Session& session, const FrameEye& start,
                  std::size_t limit, const ViewOptions& options, const Console& console) {
    constexpr double kScriptStep =
        1.0 / 60.0; // with --frames the result must not depend on the machine's speed
    Viewer viewer(window, device, session, start);
    if (!options.fly)
        viewer.beginToWalk();
    std::size_t frames = 0;
    while (!viewer.isLeaving() && (limit == 0 || frames < limit)) {
        if (Result<void> drawn = viewer.frame(limit > 0 ? kScriptStep : 0.0); !drawn)
            return tl::unexpected(drawn.error());
        ++frames;
        if (!viewer.probed().empty())
            console.data(viewer.probed());
        if (frames == limit && !options.screenshot.empty()) {
            if (Result<void> written = writePicture(options.screenshot, window.read()); !written)
                return tl::unexpected(written.error());
        }
        window.show();
    }
    if (options.json)
        console.data(stateJson(session, viewer, frames));
    return Exit::Done;
}

Result<Exit> runView(const ViewOptions& options, const Console& console) {
    const Result<std::size_t> limit = frameLimit(options);
    if (!limit)
        return tl::unexpected(limit.error());
    if (!options.screenshot.empty() && *limit == 0)
        return fail(ErrorCode::BadArgument, "--screenshot",
                    "is taken of the last frame; give --frames N as well");
    if (!options.screenshot.empty()) {
        if (Result<void> writable = checkWritable(options.screenshot); !writable)
            return tl::unexpected(writable.error());
    }
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
    start->time = opening->view.time;
    start->weather = opening->view.weather;
    start->seconds = opening->view.seconds;
    start->doors = opening->view.doors;
    return loop(**window, **device, session, *start, *limit, options, console);
}

} // namespace

void addViewVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("view", "opens a window to walk through a world");
    const auto options = std::make_shared<ViewOptions>();
    addViewOptions(*verb, options->view);
    verb->add_option("--frames", options->frames, "leaves after N frames, for scripts")
        ->type_name("N")
        ->group("Scripts");
    verb->add_option("--screenshot", options->screenshot, "the window's last frame, PNG")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_flag("--fly", options->fly, "begins flying; G changes that")->group("View");
    verb->add_flag("--json", options->json, "prints eye, root and overlays on leaving")->group("Scripts");
    addSessionOptions(*verb, options->session);
    verb->footer(
        "Keys: W A S D walk, shift run, space jump, E use a door, G fly (E Q up and down), drag to "
        "look, click to "
        "ask, O doors, 1..9 places, F1 help, F2 ids, F3 regions, F4 panel, F5 check, F6 probe, Esc leaves.");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runView(*options, console); };
    });
}

} // namespace limen::app
