#include "app/FrameSource.h"
#include "app/OutputFile.h"
#include "app/Picture.h"
#include "app/Verbs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::app {
namespace {

struct TourOptions {
    SessionOptions session;
    PathArguments path;
    std::string directory;
    bool json = false;
};

constexpr std::size_t kTourFrames = 120; // unless said
constexpr std::size_t kSheetTiles = 24;

/// One line of `--json`.
std::string statsLine(const Session& session, const FrameEye& eye, std::size_t frame) {
    const FrameFigures figures = session.figures();
    const auto number = [](double v) {
        return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
    };
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const StageFigures& stage : figures.stages)
        stages[stage.name] = {
            {"draws", stage.draws}, {"cpu_ms", number(stage.cpuMs)}, {"gpu_ms", number(stage.gpuMs)}};
    const nlohmann::ordered_json line{
        {"frame", frame},
        {"root", spaceName(session.loaded().world, eye.root)},
        {"visits", session.visible().visits.size()},
        {"cells", cellsSeen(session.loaded().world, session.visible()).size()},
        {"drawn", session.plan().counts.instancesDrawn},
        {"gl_calls", figures.glCalls},
        {"flood_ms", number(figures.floodMs)},
        {"plan_ms", number(figures.planMs)},
        {"submit_ms", number(figures.submitMs)},
        {"stages", std::move(stages)},
        {"command", reproduction(session.loaded().world, eye, session.source().datOption)}};
    return line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<void> drawFrames(Session& session, FrameSource& frames, const TourOptions& options,
                        const Console& console) {
    const std::size_t count = frames.count();
    const std::filesystem::path directory = options.directory;
    ContactSheet sheet(count, kSheetTiles, 6, 320);
    Progress progress(console, "tour", count);
    for (std::size_t frame = 0; frame < count; ++frame) {
        const Result<const FrameEye*> next = frames.next();
        if (!next)
            return tl::unexpected(next.error());
        const FrameEye& eye = **next;
        if (Result<void> drawn = session.draw(eye, {.ids = false}); !drawn)
            return drawn;
        const Picture picture =
            pictureFromRgba(eye.size.width, eye.size.height, session.target().readColour());
        if (Result<void> written = writePicture(directory / fmt::format("frame-{:05}.png", frame), picture);
            !written)
            return written;
        if (sheet.wants(frame))
            sheet.add(picture, fmt::format("{} {}", frame, spaceName(session.loaded().world, eye.root)));
        if (options.json)
            console.data(statsLine(session, eye, frame));
        progress.step(frame + 1);
    }
    return writePicture(directory / "contact.png", sheet.compose());
}

Result<HeadlessSession> openTour(const TourOptions& options, std::optional<FramesRequest>& request) {
    if (Result<void> made = makeDirectory(options.directory); !made)
        return tl::unexpected(made.error());
    if (Result<void> writable = checkWritable(std::filesystem::path(options.directory) / "contact.png");
        !writable)
        return tl::unexpected(writable.error());
    Result<WorldSource> source = openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    Result<FramesRequest> checked = checkFrames(options.path, kTourFrames, source->file);
    if (!checked)
        return tl::unexpected(checked.error());
    request = std::move(*checked);
    return openHeadless(std::make_shared<const WorldSource>(std::move(*source)), options.session);
}

Result<Exit> runTour(const TourOptions& options, const Console& console) {
    std::optional<FramesRequest> request;
    Result<HeadlessSession> headless = openTour(options, request);
    if (!headless)
        return tl::unexpected(headless.error());
    Session& session = *headless->session;
    const Result<std::unique_ptr<FrameSource>> frames = openFrames(session, std::move(*request));
    if (!frames)
        return tl::unexpected(frames.error());
    if (const std::string findings = findingsLine(session.loaded().world); !findings.empty())
        console.note(findings);
    if (Result<void> drawn = drawFrames(session, **frames, options, console); !drawn)
        return tl::unexpected(drawn.error());
    if (const std::string difference = differenceLine(**frames); !difference.empty())
        console.note(difference);
    console.note(fmt::format("The frames and contact.png are in {}", options.directory));
    return Exit::Done;
}

} // namespace

void addTourVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("tour", "walks a camera path and writes its frames");
    const auto options = std::make_shared<TourOptions>();
    verb->add_option("-o,--output", options->directory,
                     "the directory for frame-NNNNN.png and contact.png; made if it is missing")
        ->required()
        ->type_name("DIR");
    addPathOptions(*verb, options->path, kTourFrames);
    verb->add_flag("--json", options->json, "one JSON object for each frame on standard output");
    addSessionOptions(*verb, options->session);
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runTour(*options, console); };
    });
}

} // namespace limen::app
