#include "cli/Choices.h"
#include "cli/OpenWorld.h"
#include "cli/PathArguments.h"
#include "cli/SessionArguments.h"
#include "cli/Verbs.h"
#include "gpu/device/NullDevice.h"
#include "output/OutputFile.h"
#include "play/FootWalk.h"
#include "play/PathWalk.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <optional>

namespace limen::cli {
namespace {

struct WalkOptions {
    engine::SessionOptions session;
    PathArguments path;
    std::string output;
    play::FootWalkOptions foot;
};

template <class List>
std::string listed(const char* title, const List& list) {
    return list.empty() ? std::string() : fmt::format("{}{}", title, fmt::join(list, ", "));
}

Result<Exit> runWalk(const WalkOptions& options, const Console& console) {
    const Result<play::PathRequest> request = checkPath(options.path, 1);
    if (!request)
        return Failure(request.error());
    if (Result<void> writable = output::checkWritable(options.output); !writable)
        return Failure(writable.error());
    Result<engine::WorldSource> source = openWorld(console, options.session.dat);
    if (!source)
        return Failure(source.error());
    const Result<std::vector<engine::ViewRequest>> points = wayPointsOf(options.path, *source, console);
    if (!points)
        return Failure(points.error());
    gpu::NullDevice device; // the walk needs no pictures
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), options.session,
                            device);
    std::optional<Waiting> waiting(std::in_place, console, "loading the world");
    const Result<play::PathStart> start = play::startPath(session, *points, *request);
    waiting.reset();
    if (!start)
        return Failure(start.error());
    Progress progress(console, "walk", points->size());
    const Result<play::FootWalk> walk = play::walkOnFoot(session, start->frame, *points, options.foot,
                                                         [&](std::size_t done) { progress.step(done); });
    if (!walk)
        return Failure(walk.error());
    std::string text = play::beginningLine(walk->record.start);
    for (const play::RecordedFrame& frame : walk->record.frames)
        text += play::frameLine(frame);
    if (Result<void> written = output::writeFile(options.output, text); !written)
        return Failure(written.error());
    console.wrote(options.output,
                  fmt::format("{} frames to {} way points{}{}", walk->record.frames.size(), points->size(),
                              listed("; not reached: ", walk->missed), listed("; jumped to ", walk->jumps)));
    return Exit::Done;
}

} // namespace

void addWalkVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("walk", "walk a path on foot and record the input of each frame");
    const auto options = std::make_shared<WalkOptions>();
    verb->add_option("-o,--output", options->output,
                     "write the walk to this file, for --walk of tour, probe and check")
        ->required()
        ->type_name("FILE");
    verb->add_option("--path", options->path.path,
                     "follow these way points, one line of shot's options each, e.g. --at hill (the world's "
                     "tour, else one made from its records)")
        ->type_name("FILE");
    verb->add_option("--size", options->path.size, "set the picture size in pixels (960x540)")
        ->type_name("WxH");
    verb->add_option("--fov", options->path.fov, "set the vertical field of view in degrees (60)")
        ->type_name("DEG");
    verb->add_option("--time", options->path.time, "set the time of day; 0 and 1 are midnight (0.5)")
        ->type_name("0..1");
    verb->add_option("--fps", options->foot.fps, "record this many frames per second (30)")
        ->type_name("F")
        ->check(within(5.0, 1000.0));
    verb->add_flag("--chase", options->foot.chase, "use the third-person camera");
    verb->add_flag("--run", options->foot.run, "run instead of walking");
    addSessionOptions(*verb, options->session);
    verb->footer("Walks straight between way points, opens doors and goes around obstacles. If there is no "
                 "way on foot,\n"
                 "jumps to the next named place at a way point. Draws nothing and needs no driver.\n"
                 "Examples:\n  limen walk -o tour.walk\n  limen walk --run --chase -o tour.walk");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runWalk(*options, console); };
    });
}

} // namespace limen::cli
