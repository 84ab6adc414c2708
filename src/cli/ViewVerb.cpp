#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/SessionArguments.h"
#include "cli/ShotRequest.h"
#include "cli/Verbs.h"
#include "cli/world/PlacedImport.h"
#include "output/OutputFile.h"
#include "viewer/Signals.h"
#include "viewer/StateJson.h"
#include "viewer/open/GameDirectories.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace limen::cli {
namespace {

struct ViewOptions {
    engine::SessionOptions session;
    ViewArguments view;
    std::vector<std::string> import; ///< sources of placed objects; empty: none
    std::string frames, step, screenshot, screenshots, record, keys, uiScale, scale, frameRate;
    bool json = false, tell = false, fly = false, chase = false;
    bool isQualityGiven = false;
    [[nodiscard]] bool isScript() const { return !frames.empty(); }
    [[nodiscard]] bool hasViewpoint() const { return !view.eye.empty() || !view.at.empty(); }
};

/// The view of the options, with a placeholder for the viewpoint if there is none.
Result<engine::ViewRequest> viewIn(const ViewOptions& options) {
    ViewArguments arguments = options.view;
    if (!options.hasViewpoint())
        arguments.eye = "0,0,0";
    return checkView(arguments);
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
            return Failure(frames.error());
        script.frames = static_cast<std::size_t>(*frames);
        script.step = kStep;
    }
    if (!options.step.empty()) {
        const Result<double> step = parseNumberBetween("--step", options.step, 0.001, 1.0);
        if (!step)
            return Failure(step.error());
        script.step = *step;
    }
    if (!options.screenshot.empty() && script.frames == 0)
        return fail(ErrorCode::BadArgument, "--screenshot", "needs a last frame; give --frames N as well");
    Result<viewer::ViewerKeys> keys = keysOf(options);
    if (!keys)
        return Failure(keys.error());
    script.keys = std::move(*keys);
    return script;
}

void printNotes(viewer::Application& application, const Console& console) {
    for (const std::string& note : application.takeNotes())
        console.note("limen: " + note);
}

/// Runs frames until the user or a signal ends the program, or the script is over. Counts them.
Result<void> loop(viewer::Window& window, viewer::Application& application, viewer::Signals& signals,
                  const Script& script, const ViewOptions& options, const Console& console,
                  std::size_t& frames) {
    while (!application.isLeaving() && !window.isLost() && !signals.arrived() &&
           (script.frames == 0 || frames < script.frames)) {
        if (script.frames == 0 && !window.isShown()) {
            application.rest();
            continue;
        }
        if (Result<void> drawn = application.frame(); !drawn)
            return drawn;
        if (window.isLost()) // Mesa would free the window's image while its threads still write to it
            return {};
        ++frames;
        printNotes(application, console);
        if (application.world() != nullptr && !application.world()->probed().empty())
            console.data(application.world()->probed());
        if (frames == script.frames && !options.screenshot.empty())
            if (Result<void> written = output::writePicture(options.screenshot, window.read()); !written)
                return written;
        window.show();
        if (options.tell) {
            console.data(viewer::stateJson(application, frames));
            (void)console.flush();
        }
    }
    return {};
}

/// Runs the window and saves all files, however it ends.
Result<Exit> runWindow(viewer::Window& window, viewer::Application& application, viewer::Signals& signals,
                       const Script& script, const ViewOptions& options, const Console& console) {
    application.open(options.session.dat);
    if (options.isScript()) // its frames must not depend on the machine's speed
        if (Result<void> opened = application.finishOpening(); !opened)
            return Failure(opened.error());
    std::size_t frames = 0;
    const Result<void> ran = loop(window, application, signals, script, options, console, frames);
    const Result<void> saved = application.save();
    printNotes(application, console);
    for (const Result<void>& result : {ran, saved})
        if (!result)
            return Failure(result.error());
    if (window.isLost())
        return fail(ErrorCode::Driver, "view", "the connection to the display was lost");
    if (options.json)
        console.data(viewer::stateJson(application, frames));
    if (const std::optional<int> signal = signals.arrived()) {
        console.note(fmt::format("limen: ended by {}", viewer::nameOfSignal(*signal)));
        return static_cast<Exit>(viewer::exitCodeOf(*signal));
    }
    return Exit::Done;
}

Result<void> checkFiles(const ViewOptions& options) {
    if (Result<void> writable =
            options.screenshot.empty() ? Result<void>{} : output::checkPictureWritable(options.screenshot);
        !writable)
        return writable;
    if (Result<void> writable =
            options.record.empty() ? Result<void>{} : output::checkWritable(options.record);
        !writable)
        return writable;
    return options.screenshots.empty() ? Result<void>{} : output::makeDirectory(options.screenshots);
}

/// The scale of the options; a script's pictures have full size by default.
Result<void> takeScale(const ViewOptions& options, viewer::ApplicationOptions& application) {
    if (!options.scale.empty()) {
        const Result<std::optional<double>> percent =
            parseNumberOrAuto("--scale", options.scale, viewer::kLeastScale, viewer::kFullScale);
        if (!percent)
            return Failure(percent.error());
        application.scale = static_cast<std::uint32_t>(percent->value_or(0.0)); // 0: automatic
    } else if (options.isScript()) {
        application.scale = viewer::kFullScale;
    }
    if (options.frameRate.empty())
        return {};
    return parseNumberBetween("--fps", options.frameRate, viewer::kLeastRate, viewer::kMostRate)
        .map([&](double rate) { application.frameRate = rate; });
}

/// The options of the application. The settings file applies to people: a script's frames do not depend on it.
Result<viewer::ApplicationOptions> applicationOptions(const ViewOptions& options, Script& script) {
    Result<engine::ViewRequest> view = viewIn(options);
    if (!view)
        return Failure(view.error());
    viewer::ApplicationOptions application;
    application.session = options.session;
    application.session.givesMemoryBack = true;
    application.isQualityFixed = options.isQualityGiven;
    application.isLookFixed = options.isScript() || !options.view.look.empty();
    application.isFovFixed = options.isScript() || !options.view.fov.empty();
    application.flies = options.fly;
    application.isChased = options.chase;
    application.step = script.step;
    application.keys = std::move(script.keys);
    application.screenshots = options.screenshots;
    application.record = options.record;
    application.version = LIMEN_VERSION;
    application.gameDirectories = viewer::gameDirectories();
    if (!options.uiScale.empty()) {
        const Result<double> scale = parseNumberBetween("--ui-scale", options.uiScale, 0.5, 4.0);
        if (!scale)
            return Failure(scale.error());
        application.uiScale = *scale;
    }
    if (Result<void> scaled = takeScale(options, application); !scaled)
        return Failure(scaled.error());
    if (!options.isScript()) {
        application.settingsFile = viewer::settingsPath();
        application.settings = viewer::readSettings(application.settingsFile);
        const viewer::Settings& settings = application.settings.settings;
        if (options.view.size.empty())
            view->size = {settings.width, settings.height};
        if (!application.isFovFixed)
            view->fov = settings.fieldOfView;
        if (!application.isLookFixed)
            view->scene.look = settings.look;
    }
    application.view = *view;
    if (options.hasViewpoint())
        application.start = [view = *view](const engine::WorldSource& source) {
            return engine::resolvePlace(view, source);
        };
    return application;
}

/// Writes a world.db beside the dat files before the window opens.
Result<Exit> importFirst(const ViewOptions& options, const Console& console) {
    if (options.import.empty())
        return Exit::Done;
    if (options.session.dat.empty())
        return fail(ErrorCode::BadArgument, "--import",
                    "writes a world.db beside your dat files; give their directory with --dat DIR");
    return importPlaced({options.import, options.session.dat, {}, {}}, console);
}

Result<Exit> runView(const ViewOptions& options, const Console& console) {
    if (Result<Exit> imported = importFirst(options, console); !imported || *imported != Exit::Done)
        return imported;
    viewer::Signals signals; // before threads start
    Result<Script> script = scriptOf(options);
    if (!script)
        return Failure(script.error());
    if (Result<void> checked = checkFiles(options); !checked)
        return Failure(checked.error());
    Result<viewer::ApplicationOptions> application = applicationOptions(options, *script);
    if (!application)
        return Failure(application.error());
    const Result<std::unique_ptr<viewer::Window>> window =
        viewer::Window::open("Limen", application->view.size);
    if (!window)
        return Failure(window.error());
    const Result<std::unique_ptr<gpu::GlDevice>> device = gpu::GlDevice::create();
    if (!device)
        return Failure(device.error());
    viewer::Application shown(**window, **device, std::move(*application));
    return runWindow(**window, shown, signals, *script, options, console);
}

/// The default keys as text.
std::string keysFooter() {
    std::string text =
        "Escape opens the menu: other worlds, places, settings, quit. A directory dropped onto the window is "
        "opened.\nA world that does not open leads to the page Open a world, with the reason; with --frames "
        "the "
        "program ends with exit code 2.\nSettings: limen/settings.json in the user's configuration "
        "directory; "
        "options of the command line win. With --frames they do not apply.\n"
        "Ctrl-C and SIGTERM save the recorded walk and the settings; the exit code is 128 and the signal's "
        "number.\n"
        "\nDefault keys, with the action names for --keys:\n";
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
    verb->add_option(
            "--import", options->import,
            "first read doors, people and signs from these directories, archives or files of SQL, or this "
            "server, into world.db beside the files of --dat; needed once (none)")
        ->type_name("SOURCE")
        ->check(notEmpty())
        ->group("World");
    verb->add_flag("--fly", options->fly, "start flying; the key G switches")->group("View");
    verb->add_flag("--chase", options->chase, "start in third person; the key C switches")
        ->group("View")
        ->excludes("--fly");
    verb->add_option("--ui-scale", options->uiScale,
                     "scale letters and controls by this factor, on top of the screen's scale (1)")
        ->type_name("F")
        ->group("View");
    verb->add_option(
            "--scale", options->scale,
            "draw the 3-D picture with this percentage of the window's pixels each way; auto: as many as "
            "keep the frame rate (auto; 100 with --frames)")
        ->type_name("auto|50..100")
        ->group("View");
    verb->add_option(
            "--fps", options->frameRate,
            "set the frames a second that --scale auto keeps (30 without a graphics card, else those of the "
            "display)")
        ->type_name("N")
        ->group("View");
    verb->add_flag("--json", options->json, "print the final state (eye, root, overlays, ...) as JSON")
        ->group("Scripts");
    verb->add_flag("--tell", options->tell, "print the state after every frame, one line each")
        ->group("Scripts");
    addSessionOptions(*verb, options->session);
    addDrawing(*verb, options->session, gpu::Drawing::Fast, "fast");
    addGate(*verb, options->session);
    verb->add_option(
            "--keys", options->keys,
            "read key bindings from this JSON file, e.g. {\"use\": \"F\"}; the window's help page writes it "
            "(limen/keys.json in the user's configuration directory)")
        ->type_name("FILE")
        ->group("View");
    verb->footer(keysFooter() + "Examples:\n  limen view --at inn.hall --fly\n"
                                "  limen view --dat DIR --at Holtburg --import core patches");
    verb->callback([&console, &choice, options, verb] {
        for (const char* name : {"--quality", "--radius", "--far", "--detail", "--msaa"})
            options->isQualityGiven = options->isQualityGiven || verb->count(name) > 0;
        choice.runsForHours = true;
        choice.run = [&console, options] { return runView(*options, console); };
    });
}

} // namespace limen::cli
