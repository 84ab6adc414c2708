#include "cli/OpenWorld.h"
#include "cli/Parse.h"
#include "cli/PathArguments.h"
#include "cli/ReportFacts.h"
#include "cli/SessionArguments.h"
#include "cli/ShotRequest.h"
#include "cli/TourOutputs.h"
#include "cli/Verbs.h"
#include "engine/CheckView.h"
#include "engine/FrameMemory.h"
#include "play/FrameSource.h"
#include "play/TurnTable.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

struct TourOptions {
    engine::SessionOptions session;
    PathArguments path;
    TourOutputOptions outputs;
    std::string at, distance; ///< of a turn-table
    std::string command;      ///< as typed
    bool turnTable = false, json = false;
};

constexpr std::size_t kTourFrames = 120;      // default of --frames
constexpr std::size_t kTurnTableFrames = 240; // of a turn-table
constexpr double kFilmRate = 30.0;            // frames a second

/// One line of `--json`.
std::string statsLine(const engine::Session& session, const engine::FrameRequest& request,
                      std::size_t frame) {
    const engine::FrameFigures figures = session.figures();
    const auto number = [](double v) {
        return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const engine::StageFigures& stage : figures.stages)
        stages[stage.name] = {
            {"draws", stage.draws}, {"cpu_ms", number(stage.cpuMs)}, {"gpu_ms", number(stage.gpuMs)}};
    const nlohmann::ordered_json line{
        {"frame", frame},
        {"root", engine::spaceName(session.part().world, request.root)},
        {"visits", session.visible().visits.size()},
        {"cells", engine::cellsSeen(session.part().world, session.visible()).size()},
        {"drawn", session.plan().counts.instancesDrawn},
        {"gl_calls", figures.glCalls},
        {"flood_ms", number(figures.floodMs)},
        {"plan_ms", number(figures.planMs)},
        {"submit_ms", number(figures.submitMs)},
        {"stages", std::move(stages)},
        {"command", engine::reproduction(session.part().world, request, session.source().datOption)}};
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// The frames to draw: along a path, of a walk, or around a place.
struct TourFrames {
    std::optional<play::FramesRequest> path;
    std::optional<play::TurnTableRequest> turnTable;
    double framesPerSecond = kFilmRate;
};

/// The rate at which a walk was recorded: its frames divided by their time.
double rateOf(const play::WalkRecord& walk) {
    double seconds = 0.0;
    for (const play::RecordedFrame& frame : walk.frames)
        seconds += frame.input.seconds;
    return seconds > 0.0 ? std::clamp(static_cast<double>(walk.frames.size()) / seconds, 1.0, 240.0)
                         : kFilmRate;
}

Result<TourFrames> checkPathFrames(const TourOptions& options, const engine::WorldSource& source,
                                   const Console& console) {
    PathArguments arguments = options.path;
    const bool isSpaced = !arguments.frames.empty() || !arguments.fps.empty() || !arguments.walk.empty();
    if (!options.outputs.film.empty() && !isSpaced)
        arguments.fps = fmt::format("{:g}", kFilmRate); // a film shows the path at its own pace
    Result<play::FramesRequest> request = checkFrames(arguments, kTourFrames, source, console);
    if (!request)
        return Failure(request.error());
    TourFrames frames;
    if (request->walk)
        frames.framesPerSecond = rateOf(*request->walk);
    else if (request->path.fps > 0.0)
        frames.framesPerSecond = request->path.fps;
    frames.path = std::move(*request);
    return frames;
}

Result<TourFrames> checkTurnTable(const TourOptions& options, const engine::WorldSource& source) {
    PathArguments arguments = options.path;
    const Result<play::PathRequest> path = checkPath(arguments, kTurnTableFrames);
    if (!path)
        return Failure(path.error());
    play::TurnTableRequest request;
    if (!options.distance.empty()) {
        const Result<double> distance = parseNumberBetween("--distance", options.distance, 0.0, 500.0);
        if (!distance)
            return Failure(distance.error());
        request.distance = *distance;
    }
    if (!options.at.empty()) {
        ViewArguments place;
        place.at = options.at;
        Result<engine::ViewRequest> view = checkView(place);
        if (!view)
            return Failure(view.error());
        request.centre = std::move(*view);
    } else {
        request.centre.isAtStart = true;
    }
    const bool isObject = source.placed != nullptr && !request.centre.place.empty() &&
                          !engine::resolvePlace(request.centre, source.file);
    Result<engine::ViewRequest> resolved = engine::resolvePlace(request.centre, source);
    if (!resolved)
        return Failure(resolved.error());
    request.centre = std::move(*resolved);
    if (isObject) {                     // resolvePlace() gives a viewpoint before it
        constexpr double kMiddle = 1.0; // metres above the origin of a person, a door or a chest
        const Result<std::optional<Vec3>> position = source.placed->positionOf(options.at);
        if (!position)
            return Failure(position.error());
        if (*position)
            request.centre.eye = **position + Vec3(0.0, 0.0, kMiddle);
        // A camera at the centre would be within the object, so a circle is drawn even where a wall is near.
        constexpr double kAround = 2.0; // metres
        request.distance = request.distance.value_or(kAround);
    }
    request.centre.fov = path->fov;
    request.centre.size = path->size;
    request.centre.scene.time = path->time;
    request.frames = path->frames;
    request.framesPerSecond = path->fps > 0.0 ? path->fps : kFilmRate;
    TourFrames frames;
    frames.framesPerSecond = request.framesPerSecond;
    frames.turnTable = std::move(request);
    return frames;
}

Result<std::unique_ptr<play::FrameSource>> openTourFrames(engine::Session& session, TourFrames& frames) {
    if (frames.turnTable)
        return play::openTurnTable(session, std::move(*frames.turnTable));
    return play::openFrames(session, std::move(*frames.path));
}

/// The size of the first frame; a recorded walk has its own.
engine::PixelSize sizeOf(const TourFrames& frames) {
    if (frames.turnTable)
        return frames.turnTable->centre.size;
    if (frames.path->walk && !frames.path->walk->frames.empty())
        return frames.path->walk->frames.front().input.size;
    return frames.path->path.size;
}

/// After a signal: the pictures so far stay. A film and a report are not written.
void reportStop(const TourOutputOptions& options, std::size_t drawn, std::size_t count,
                const Console& console) {
    if (!options.directory.empty())
        console.wrote(options.directory, fmt::format("{} of {} frames, then stopped", drawn, count));
    if (!(options.film + options.report).empty())
        console.note(fmt::format("limen: stopped after {} of {} frames; no film and no report was written",
                                 drawn, count));
}

/// Draws all frames, or those before a signal.
Result<Exit> drawTour(engine::Session& session, play::FrameSource& frames, TourOutputs& outputs,
                      const TourOptions& options, const Console& console) {
    const std::size_t count = frames.count();
    Progress progress(console, "tour", count);
    console.interrupt().defer();
    for (std::size_t frame = 0; frame < count; ++frame) {
        if (console.interrupt().isRequested()) {
            reportStop(options.outputs, frame, count, console);
            return Exit::Interrupted;
        }
        const Result<const engine::FrameRequest*> next = frames.next();
        if (!next)
            return Failure(next.error());
        if (Result<void> drawn = session.draw(**next, {.ids = false}); !drawn)
            return Failure(drawn.error());
        if (Result<void> written = outputs.add(session, **next, frame); !written)
            return Failure(written.error());
        if (options.json)
            console.data(statsLine(session, **next, frame));
        progress.step(frame + 1);
    }
    return Exit::Done;
}

Result<Exit> runTour(const TourOptions& options, const Console& console) {
    if (!options.turnTable && !(options.at + options.distance).empty())
        return fail(ErrorCode::BadArgument, options.at.empty() ? "--distance" : "--at",
                    "belongs to a turn-table; add --turn-table");
    Result<TourOutputs> outputs = TourOutputs::open(options.outputs);
    if (!outputs)
        return Failure(outputs.error());
    Result<engine::WorldSource> source = openWorld(console, options.session.dat);
    if (!source)
        return Failure(source.error());
    Result<TourFrames> request =
        options.turnTable ? checkTurnTable(options, *source) : checkPathFrames(options, *source, console);
    if (!request)
        return Failure(request.error());
    Result<engine::HeadlessSession> headless = engine::openHeadless(
        std::make_shared<const engine::WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return Failure(headless.error());
    engine::Session& session = *headless->session;
    if (Result<void> fits = engine::checkFrameFits(
            sizeOf(*request), session.samples(), headless->device->capabilities(), engine::availableMemory());
        !fits)
        return Failure(fits.error());
    std::optional<Waiting> waiting(std::in_place, console, "loading the world");
    const Result<std::unique_ptr<play::FrameSource>> frames = openTourFrames(session, *request);
    waiting.reset();
    if (!frames)
        return Failure(frames.error());
    const std::string findings = engine::findingsLine(session.part().world);
    if (!findings.empty())
        console.note(findings);
    outputs->begin((*frames)->count(), request->framesPerSecond);
    Result<Exit> drawn = drawTour(session, **frames, *outputs, options, console);
    if (!drawn || *drawn == Exit::Interrupted)
        return drawn;
    const std::string difference = play::differenceLine(**frames);
    if (!difference.empty())
        console.note(difference);
    const Result<std::vector<WrittenOutput>> written =
        outputs->finish(session, options.command, {findings, difference});
    if (!written)
        return Failure(written.error());
    for (const WrittenOutput& output : *written)
        console.wrote(output.path, output.content);
    return Exit::Done;
}

void addTurnTableOptions(CLI::App& verb, TourOptions& options) {
    verb.add_flag("--turn-table", options.turnTable,
                  "circle a place once, looking at it, instead of following a path")
        ->group("Turn-table")
        ->excludes("--path")
        ->excludes("--walk");
    verb.add_option("--at", options.at,
                    "circle this place, in the notations of shot's --at (the first place of the world)")
        ->type_name("PLACE")
        ->group("Turn-table");
    verb.add_option("--distance", options.distance,
                    "set the distance of the camera in metres; 0: turn at the place (the largest free circle "
                    "up to 24; 2 around an object of world.db)")
        ->type_name("M")
        ->group("Turn-table");
}

} // namespace

void addTourVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("tour", "draw the frames along a camera path to pictures, a film or a report");
    const auto options = std::make_shared<TourOptions>();
    addTourOutputOptions(*verb, options->outputs);
    addPathOptions(*verb, options->path, kTourFrames);
    addTurnTableOptions(*verb, *options);
    verb->add_flag("--json", options->json, "print one JSON object per frame");
    addSessionOptions(*verb, options->session);
    addDrawing(*verb, options->session, gpu::Drawing::Fast, "fast");
    addGate(*verb, options->session);
    verb->footer("Examples:\n  limen tour --frames 12 --size 320x180 --report report\n"
                 "  limen tour --turn-table --at lane --size 320x180 --film lane.gif");
    verb->callback([&console, &choice, options, verb] {
        options->command = commandLineOf(*verb);
        choice.run = [&console, options] { return runTour(*options, console); };
    });
}

} // namespace limen::cli
