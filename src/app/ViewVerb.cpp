#include "app/DecisionHash.h"
#include "app/OutputFile.h"
#include "app/Panel.h"
#include "app/Play.h"
#include "app/Probe.h"
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
    std::string frames, screenshot, record;
    bool json = false, fly = false, chase = false;
};

/// The window's frame loop: hands to play, its eye to the frame, the frame to the window.
class Viewer {
public:
    Viewer(Window& window, gpu::GlDevice& device, Session& session, FrameEye start)
        : window_(window), device_(device), session_(session), panel_(window),
          play_(session, std::move(start)) {
        lastSeconds_ = window_.seconds();
        device_.restoreState(); // the panel has set up its own things
    }

    /// What is to be done at the beginning of the next frame.
    void act(PlayAct act) { acts_.push_back(act); }

    /// One frame; `fixedSeconds` > 0 takes that for the time since the last one.
    [[nodiscard]] Result<void> frame(double fixedSeconds) {
        window_.poll(panel_.takesMouse());
        const double now = window_.seconds();
        frameSeconds_ = now - lastSeconds_;
        lastSeconds_ = now;
        for (const Key key : window_.pressed())
            press(key);
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

    /// What changed with the last frame in what was decided, if that is to be told.
    [[nodiscard]] const std::string& probed() const { return probed_; }
    [[nodiscard]] bool isLeaving() const { return leaving_ || window_.wantsToClose(); }
    [[nodiscard]] const FrameEye& eye() const { return play_.eye(); }
    [[nodiscard]] const PlayInput& input() const { return input_; }
    [[nodiscard]] const OverlaySwitches& switches() const { return switches_; }
    [[nodiscard]] const std::optional<Picked>& picked() const { return picked_; }
    [[nodiscard]] const std::optional<ViewVerdict>& verdict() const { return verdict_; }
    [[nodiscard]] const Walk& walk() const { return play_.walk(); }
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
        case Key::Freeze:
            freeze();
            return;
        case Key::FullScreen:
            window_.switchFullScreen();
            return;
        case Key::Walk:
            return act({PlayAct::Kind::Walk});
        case Key::Chase:
            return act({PlayAct::Kind::Chase});
        case Key::Doors:
            return act({PlayAct::Kind::Doors});
        case Key::Use:
            return act({PlayAct::Kind::Use});
        case Key::Rain:
            return act({PlayAct::Kind::Weather});
        case Key::Later:
            return act({PlayAct::Kind::Time, std::fmod(eye().time + 1.0 / 24.0, 1.0)});
        case Key::Leave:
            leaving_ = true;
            return;
        default:
            act({PlayAct::Kind::Place, static_cast<double>(key) - static_cast<double>(Key::Place1)});
        }
    }

    /// The last frame's flood is kept, to be flown around; once more: no longer.
    void freeze() {
        if (frozen_)
            frozen_.reset();
        else
            frozen_ = FrozenFlood{viewOf(eye().camera, eye().size, eye().root), session_.visible()};
    }

    /// What hands ask of this frame.
    const PlayInput& takeInput(double seconds) {
        constexpr double kDegreesPerPixel = 0.15;
        constexpr double kStep = 0.5; // metres that the wheel moves the eye behind the body
        const HeldInput& held = window_.held();
        const auto axis = [](bool plus, bool minus) { return (plus ? 1.0 : 0.0) - (minus ? 1.0 : 0.0); };
        if (held.wheel != 0.0 && walk().isChased())
            act({PlayAct::Kind::Distance, walk().distance() - held.wheel * kStep});
        input_ = {};
        input_.seconds = seconds;
        input_.forward = axis(held.forward, held.back);
        input_.right = axis(held.right, held.left);
        input_.up = axis(held.up, held.down);
        input_.turnRight = held.lookX * kDegreesPerPixel;
        input_.turnUp = -held.lookY * kDegreesPerPixel;
        input_.fast = held.fast;
        if (held.sticks)
            addSticks(inputOf(*held.sticks, seconds));
        input_.jump = held.jump;
        input_.isFrozen = verdict_.has_value(); // the world stands still under a verdict
        input_.size = window_.size();
        input_.acts = std::exchange(acts_, {});
        return input_;
    }

    void addSticks(const StickInput& sticks) {
        input_.forward = std::clamp(input_.forward + sticks.forward, -1.0, 1.0);
        input_.right = std::clamp(input_.right + sticks.right, -1.0, 1.0);
        input_.turnRight += sticks.turnRight;
        input_.turnUp += sticks.turnUp;
        input_.fast = input_.fast || sticks.fast;
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
        if (choice.place >= 0)
            act({PlayAct::Kind::Place, static_cast<double>(choice.place)});
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
    Play play_;
    PlayInput input_;
    std::vector<PlayAct> acts_; ///< of the next frame
    OverlaySwitches switches_;
    std::optional<Picked> picked_;
    ViewCheck viewCheck_;
    bool wantsCheck_ = false;
    std::optional<Probe> probe_;
    std::string probed_;
    std::optional<ViewVerdict> verdict_; ///< on the view from checkedFrom_
    FrameEye checkedFrom_;
    std::optional<FrozenFlood> frozen_;
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
        {"chased", viewer.walk().isChased()},
        {"frozen_visits", viewer.frozenVisits()},
        {"body", bodyJson(session.loaded().world, eye.body)},
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
        viewer.act({PlayAct::Kind::Walk});
    if (options.chase)
        viewer.act({PlayAct::Kind::Chase});
    std::size_t frames = 0;
    std::string record = beginningLine(check::shotOptions(viewOf(start, session.loaded().world)));
    while (!viewer.isLeaving() && (limit == 0 || frames < limit)) {
        if (Result<void> drawn = viewer.frame(limit > 0 ? kScriptStep : 0.0); !drawn)
            return tl::unexpected(drawn.error());
        ++frames;
        if (!options.record.empty())
            record +=
                frameLine({viewer.input(), decisionHash(viewer.eye(), session.visible(), session.moment())});
        if (!viewer.probed().empty())
            console.data(viewer.probed());
        if (frames == limit && !options.screenshot.empty()) {
            if (Result<void> written = writePicture(options.screenshot, window.read()); !written)
                return tl::unexpected(written.error());
        }
        window.show();
    }
    if (!options.record.empty()) {
        if (Result<void> written = writeFile(options.record, record); !written)
            return tl::unexpected(written.error());
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
    for (const std::string& output : {options.screenshot, options.record}) {
        if (Result<void> writable = output.empty() ? Result<void>{} : checkWritable(output); !writable)
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
    if (Result<void> applied = applyMoment(session.loaded(), session.source().file, opening->view, *start);
        !applied)
        return tl::unexpected(applied.error());
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
    verb->add_option("--record", options->record,
                     "what was done in each frame, for the --walk of tour, probe and check")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_flag("--fly", options->fly, "begins flying; G changes that")->group("View");
    verb->add_flag("--chase", options->chase, "begins with the eye behind the body; C changes that")
        ->group("View")
        ->excludes("--fly");
    verb->add_flag("--json", options->json, "prints eye, root and overlays on leaving")->group("Scripts");
    addSessionOptions(*verb, options->session);
    verb->footer("Keys: W A S D walk, shift run, space jump, E use a door, C the eye behind the body, G fly "
                 "(E Q up and "
                 "down), drag to look, click to ask, O doors, 1..9 places, F1 help, F2 ids, F3 regions, F4 "
                 "panel, F5 check, F6 probe, F7 freeze the flood, F11 full screen, Esc leaves.");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runView(*options, console); };
    });
}

} // namespace limen::app
