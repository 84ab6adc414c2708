#include "cli/PathArguments.h"
#include "cli/SessionArguments.h"
#include "cli/Verbs.h"
#include "engine/CheckView.h"
#include "engine/FrameMemory.h"
#include "output/OutputFile.h"
#include "output/Picture.h"
#include "play/FrameSource.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace limen::cli {
namespace {

struct TourOptions {
    engine::SessionOptions session;
    PathArguments path;
    std::string directory;
    bool json = false;
};

constexpr std::size_t kTourFrames = 120; // default of --frames
constexpr std::size_t kSheetTiles = 24;

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

Result<Exit> drawFrames(engine::Session& session, play::FrameSource& frames, const TourOptions& options,
                        const Console& console) {
    const std::size_t count = frames.count();
    const std::filesystem::path directory = options.directory;
    output::ContactSheet sheet(count, kSheetTiles, 6, 320);
    Progress progress(console, "tour", count);
    console.interrupt().defer();
    for (std::size_t frame = 0; frame < count; ++frame) {
        if (console.interrupt().isRequested()) {
            console.wrote(directory, fmt::format("{} of {} frames, then stopped", frame, count));
            return Exit::Interrupted;
        }
        const Result<const engine::FrameRequest*> next = frames.next();
        if (!next)
            return tl::unexpected(next.error());
        const engine::FrameRequest& request = **next;
        if (Result<void> drawn = session.draw(request, {.ids = false}); !drawn)
            return tl::unexpected(drawn.error());
        const output::Picture picture =
            output::pictureFromRgba(request.size.width, request.size.height, session.target().readColour());
        if (Result<void> written =
                output::writePicture(directory / fmt::format("frame-{:05}.png", frame), picture);
            !written)
            return tl::unexpected(written.error());
        if (sheet.wants(frame))
            sheet.add(picture,
                      fmt::format("{} {}", frame, engine::spaceName(session.part().world, request.root)));
        if (options.json)
            console.data(statsLine(session, request, frame));
        progress.step(frame + 1);
    }
    if (Result<void> written = output::writePicture(directory / "contact.png", sheet.compose()); !written)
        return tl::unexpected(written.error());
    console.wrote(directory, fmt::format("{} frames and contact.png", count));
    return Exit::Done;
}

Result<engine::HeadlessSession> openTour(const TourOptions& options,
                                         std::optional<play::FramesRequest>& request) {
    if (Result<void> made = output::makeDirectory(options.directory); !made)
        return tl::unexpected(made.error());
    if (Result<void> writable =
            output::checkWritable(std::filesystem::path(options.directory) / "contact.png");
        !writable)
        return tl::unexpected(writable.error());
    Result<engine::WorldSource> source = engine::openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    Result<play::FramesRequest> checked = checkFrames(options.path, kTourFrames, source->file);
    if (!checked)
        return tl::unexpected(checked.error());
    request = std::move(*checked);
    return engine::openHeadless(std::make_shared<const engine::WorldSource>(std::move(*source)),
                                options.session);
}

Result<Exit> runTour(const TourOptions& options, const Console& console) {
    std::optional<play::FramesRequest> request;
    Result<engine::HeadlessSession> headless = openTour(options, request);
    if (!headless)
        return tl::unexpected(headless.error());
    engine::Session& session = *headless->session;
    engine::PixelSize size = request->path.size;
    if (request->walk && !request->walk->frames.empty())
        size = request->walk->frames.front().input.size;
    if (Result<void> fits = engine::checkFrameFits(
            size, options.session.samples, headless->device->capabilities(), engine::availableMemory());
        !fits)
        return tl::unexpected(fits.error());
    std::optional<Waiting> waiting(std::in_place, console, "loading the world");
    const Result<std::unique_ptr<play::FrameSource>> frames = play::openFrames(session, std::move(*request));
    waiting.reset();
    if (!frames)
        return tl::unexpected(frames.error());
    if (const std::string findings = engine::findingsLine(session.part().world); !findings.empty())
        console.note(findings);
    const Result<Exit> drawn = drawFrames(session, **frames, options, console);
    if (!drawn)
        return drawn;
    if (const std::string difference = play::differenceLine(**frames); !difference.empty())
        console.note(difference);
    return drawn;
}

} // namespace

void addTourVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("tour", "draw the frames along a camera path to files");
    const auto options = std::make_shared<TourOptions>();
    verb->add_option("-o,--output", options->directory,
                     "write frame-NNNNN.png and contact.png to this directory; create it if missing")
        ->required()
        ->type_name("DIR");
    addPathOptions(*verb, options->path, kTourFrames);
    verb->add_flag("--json", options->json, "print one JSON object per frame");
    addSessionOptions(*verb, options->session);
    verb->footer("Examples:\n  limen tour -o tour --frames 12 --size 320x180\n"
                 "  limen tour -o noon --frames 12 --size 320x180 --time 0.5");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runTour(*options, console); };
    });
}

} // namespace limen::cli
