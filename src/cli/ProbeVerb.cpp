#include "cli/OpenWorld.h"
#include "cli/PathArguments.h"
#include "cli/SessionArguments.h"
#include "cli/Verbs.h"
#include "gpu/device/NullDevice.h"
#include "output/Probe.h"
#include "play/FrameSource.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace limen::cli {
namespace {

struct ProbeOptions {
    engine::SessionOptions session;
    PathArguments path;
};

constexpr std::size_t kProbeFrames = 2000; // default of --frames

Result<Exit> runProbe(const ProbeOptions& options, const Console& console) {
    Result<engine::WorldSource> source = openWorld(console, options.session.dat);
    if (!source)
        return Failure(source.error());
    Result<play::FramesRequest> request = checkFrames(options.path, kProbeFrames, *source, console);
    if (!request)
        return Failure(request.error());
    gpu::NullDevice device; // the decisions do not depend on a driver
    engine::Session session(std::make_shared<const engine::WorldSource>(std::move(*source)), options.session,
                            device);
    std::optional<Waiting> waiting(std::in_place, console, "loading the world");
    const Result<std::unique_ptr<play::FrameSource>> frames = play::openFrames(session, std::move(*request));
    waiting.reset();
    if (!frames)
        return Failure(frames.error());
    const std::size_t count = (*frames)->count();
    output::Probe probe;
    Progress progress(console, "probe", count);
    console.interrupt().defer();
    for (std::size_t frame = 0; frame < count; ++frame) {
        if (console.interrupt().isRequested()) {
            console.note(fmt::format("limen: stopped after {} of {} frames", frame, count));
            return Exit::Interrupted;
        }
        const Result<const engine::FrameRequest*> next = (*frames)->next();
        if (!next)
            return Failure(next.error());
        if (Result<void> drawn = session.draw(**next, {}); !drawn)
            return Failure(drawn.error());
        const std::string lines = probe.see({frame, (*next)->scene.seconds, session.part().world, **next,
                                             session.visible(), session.plan(), session.figures().glCalls});
        if (!lines.empty())
            console.data(lines);
        progress.step(frame + 1);
    }
    const std::string difference = play::differenceLine(**frames);
    if (!difference.empty())
        console.note(difference);
    return difference.empty() ? Exit::Done : Exit::Finding;
}

} // namespace

void addProbeVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand(
        "probe", "print changes of visibility and drawing along a camera path as JSON lines");
    const auto options = std::make_shared<ProbeOptions>();
    addPathOptions(*verb, options->path, kProbeFrames);
    addSessionOptions(*verb, options->session);
    addGate(*verb, options->session);
    verb->footer(
        "Prints one line for every change: root (with the path of the eye), visits, spaces seen, outside,\n"
        "stages, blocks loaded, budgets. Draws nothing and needs no driver.\n"
        "With --walk the exit code is 1 if the replay differs from the recording.\n"
        "Examples:\n  limen probe --frames 50\n  limen probe --frames 20 --size 64x36");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runProbe(*options, console); };
    });
}

} // namespace limen::cli
