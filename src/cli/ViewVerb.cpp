#include "cli/Parse.h"
#include "cli/SessionArguments.h"
#include "cli/ShotRequest.h"
#include "cli/Verbs.h"
#include "engine/CheckView.h"
#include "engine/HeapTuning.h"
#include "engine/report/DecisionHash.h"
#include "output/OutputFile.h"
#include "play/WalkRecord.h"
#include "viewer/ViewerState.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace limen::cli {
namespace {

struct ViewOptions {
    engine::SessionOptions session;
    ViewArguments view;
    std::string frames, step, screenshot, screenshots, record, keys;
    bool json = false, tell = false, fly = false, chase = false;
};

/// The first view: that of the options, or without a viewpoint the world's first place.
Result<engine::ViewRequest> openingOf(const ViewOptions& options, const world::WorldFile& file) {
    ViewArguments arguments = options.view;
    if (!arguments.eye.empty() || !arguments.at.empty())
        return checkView(arguments).and_then(
            [&](engine::ViewRequest view) { return engine::resolvePlace(std::move(view), file); });
    const world::Place* place = engine::firstPlace(file);
    if (place == nullptr)
        return fail(
            ErrorCode::BadArgument, "--eye",
            "no viewpoint given, and world.json has no place to start at; use --eye X,Y,Z or --at PLACE");
    arguments.eye = "0,0,0"; // a placeholder while the other options are checked
    Result<engine::ViewRequest> view = checkView(arguments);
    if (!view)
        return view;
    const engine::ViewRequest there = engine::requestAt(*place);
    view->eye = there.eye;
    view->yaw = there.yaw;
    view->pitch = there.pitch;
    view->root = there.root;
    view->player.reset();
    return view;
}

/// Reads the keys from the file of --keys, else from the user's configuration if that file exists.
Result<viewer::ViewerKeys> keysOf(const ViewOptions& options) {
    const bool isNamed = !options.keys.empty();
    std::filesystem::path file = isNamed ? std::filesystem::path(options.keys) : viewer::keysPath();
    return viewer::readKeyBindings(file, isNamed).map([&](viewer::KeyBindings bindings) {
        return viewer::ViewerKeys{std::move(bindings), std::move(file)};
    });
}

/// Number and duration of the window's frames, and its keys.
struct Script {
    std::size_t frames = 0; ///< quits after this many; 0: when the user quits
    double step = 0.0;      ///< duration of each frame in seconds; 0: measured
    viewer::ViewerKeys keys;
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
        return fail(ErrorCode::BadArgument, "--screenshot", "needs a last frame; give --frames N as well");
    Result<viewer::ViewerKeys> keys = keysOf(options);
    if (!keys)
        return tl::unexpected(keys.error());
    script.keys = std::move(*keys);
    return script;
}

Result<Exit> loop(viewer::Window& window, gpu::GlDevice& device, engine::Session& session,
                  const engine::FrameRequest& start, Script script, const ViewOptions& options,
                  const Console& console) {
    viewer::Viewer viewer(window, device, session, start, std::move(script.keys), options.screenshots);
    if (!options.fly)
        viewer.act({play::PlayActKind::Walk});
    if (options.chase)
        viewer.act({play::PlayActKind::Chase});
    std::size_t frames = 0;
    std::string record = play::beginningLine(check::shotOptions(engine::viewOf(start, session.part().world)),
                                             session.options().load);
    while (!viewer.isLeaving() && !window.isLost() && (script.frames == 0 || frames < script.frames)) {
        if (script.frames == 0 && !window.isShown()) {
            viewer.rest();
            continue;
        }
        if (Result<void> drawn = viewer.frame(script.step); !drawn)
            return tl::unexpected(drawn.error());
        ++frames;
        if (!options.record.empty())
            record += play::frameLine(
                {viewer.input(),
                 engine::decisionHash(viewer.request(), session.visible(), session.dynamics()),
                 viewer.stream().shown(), viewer.stream().hasRefused()});
        if (const std::string fault = viewer.stream().takeFault(); !fault.empty())
            console.note("limen: cannot load nearby blocks: " + fault);
        if (!viewer.probed().empty())
            console.data(viewer.probed());
        if (frames == script.frames && !options.screenshot.empty()) {
            if (Result<void> written = output::writePicture(options.screenshot, window.read()); !written)
                return tl::unexpected(written.error());
        }
        window.show();
        if (options.tell) {
            console.data(viewer::stateJson(session, viewer, frames));
            (void)console.flush();
        }
    }
    if (!options.record.empty()) {
        if (Result<void> written = output::writeFile(options.record, record); !written)
            return tl::unexpected(written.error());
    }
    if (window.isLost())
        return fail(ErrorCode::Driver, "view", "the connection to the display was lost");
    if (options.json)
        console.data(viewer::stateJson(session, viewer, frames));
    return Exit::Done;
}

Result<Exit> runView(const ViewOptions& options, const Console& console) {
    engine::tuneHeap();
    Result<Script> script = scriptOf(options);
    if (!script)
        return tl::unexpected(script.error());
    if (Result<void> writable =
            options.screenshot.empty() ? Result<void>{} : output::checkPictureWritable(options.screenshot);
        !writable)
        return tl::unexpected(writable.error());
    if (Result<void> writable =
            options.record.empty() ? Result<void>{} : output::checkWritable(options.record);
        !writable)
        return tl::unexpected(writable.error());
    if (Result<void> made =
            options.screenshots.empty() ? Result<void>{} : output::makeDirectory(options.screenshots);
        !made)
        return tl::unexpected(made.error());
    Result<engine::WorldSource> source = engine::openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    const Result<engine::ViewRequest> opening = openingOf(options, source->file);
    if (!opening)
        return tl::unexpected(opening.error());
    const Result<std::unique_ptr<viewer::Window>> window = viewer::Window::open("Limen", opening->size);
    if (!window)
        return tl::unexpected(window.error());
    const Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return tl::unexpected(device.error());
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), options.session,
                            **device);
    if (Result<void> loaded = session.load(engine::centreOf(*opening)); !loaded)
        return tl::unexpected(loaded.error());
    const Result<engine::FrameRequest> start =
        engine::frameRequest(session.part().world, session.source().file, *opening);
    if (!start)
        return tl::unexpected(start.error());
    return loop(**window, **device, session, *start, std::move(*script), options, console);
}

/// The default keys as text.
std::string keysFooter() {
    std::string text = "Default keys, with the action names for --keys:\n";
    for (const viewer::HelpLine& line : viewer::helpLines(viewer::KeyBindings()))
        text += fmt::format("  {:<24}{:<12}{}\n", line.keys,
                            line.action ? viewer::factsOf(*line.action).name : "", line.does);
    return text;
}

} // namespace

void addViewVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("view", "open a window to walk through a world");
    const auto options = std::make_shared<ViewOptions>();
    options->session.load.farRadius = 12;
    addViewOptions(*verb, options->view);
    verb->add_option("--frames", options->frames, "quit after N frames (run until the user quits)")
        ->type_name("N")
        ->group("Scripts");
    verb->add_option("--step", options->step,
                     "set the world's time per frame (measured time; 1/60 with --frames)")
        ->type_name("SECONDS")
        ->group("Scripts");
    verb->add_option("--screenshots", options->screenshots,
                     "save screenshots to this directory (the current one)")
        ->type_name("DIR")
        ->group("View");
    verb->add_option("--screenshot", options->screenshot,
                     "write the last frame to this picture file; needs --frames (none)")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_option("--record", options->record,
                     "record the input of each frame, for --walk of tour, probe and check (none)")
        ->type_name("FILE")
        ->group("Scripts");
    verb->add_flag("--fly", options->fly, "start flying; the key G switches")->group("View");
    verb->add_flag("--chase", options->chase, "start in third person; the key C switches")
        ->group("View")
        ->excludes("--fly");
    verb->add_flag("--json", options->json, "print the final state (eye, root, overlays, ...) as JSON")
        ->group("Scripts");
    verb->add_flag("--tell", options->tell, "print the state after every frame, one line each")
        ->group("Scripts");
    addSessionOptions(*verb, options->session);
    verb->add_option(
            "--keys", options->keys,
            "read key bindings from this JSON file, e.g. {\"use\": \"F\"}; the window's help page writes it "
            "(limen/keys.json in the user's configuration directory)")
        ->type_name("FILE")
        ->group("View");
    verb->footer(keysFooter() + "Examples:\n  limen view\n  limen view --at inn.hall --fly");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runView(*options, console); };
    });
}

} // namespace limen::cli
