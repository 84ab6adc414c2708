#include "cli/OpenWorld.h"
#include "cli/SessionArguments.h"
#include "cli/ShotFrames.h"
#include "cli/Verbs.h"
#include "engine/CheckView.h"
#include "engine/FrameMemory.h"
#include "engine/Session.h"
#include "engine/picture/LargePicture.h"
#include "output/FrameJson.h"
#include "output/Npy.h"
#include "output/OutputFile.h"
#include "output/TracedFrame.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace limen::cli {
namespace {

struct ShotOptions {
    engine::SessionOptions session;
    bool isDrawingGiven = false; ///< --draw
    ViewArguments view;
    OutputPaths outputs;
    std::string views;
    bool reference = false;        ///< trace instead of drawing
    std::uint32_t supersample = 1; ///< samples along a pixel's side
};

Result<std::vector<ListedView>> viewsOf(const ShotOptions& options) {
    if (options.views.empty()) {
        Result<engine::ViewRequest> view = checkView(options.view);
        if (!view)
            return Failure(view.error());
        return std::vector<ListedView>{{std::move(*view), options.outputs}};
    }
    OutputPaths common = options.outputs;
    common.frame.clear(); // with --views, -o is the directory
    return readViews(options.views, options.view, common, options.outputs.frame);
}

Result<void> checkAllOutputs(const ShotOptions& options, const std::vector<ListedView>& views) {
    if (!options.views.empty() && !options.outputs.frame.empty()) {
        if (Result<void> made = output::makeDirectory(options.outputs.frame); !made)
            return made;
    }
    std::vector<std::filesystem::path> outputs;
    for (const ListedView& view : views) {
        for (const std::filesystem::path& picture : {view.outputs.frame, view.outputs.overlay})
            if (Result<void> writable =
                    picture.empty() ? Result<void>{} : output::checkPictureWritable(picture);
                !writable)
                return writable;
        const std::vector<std::filesystem::path> all = view.outputs.all();
        outputs.insert(outputs.end(), all.begin(), all.end());
    }
    return checkOutputs(outputs);
}

/// The drawing order: views of one landblock together, so that each part of the world is loaded once.
std::vector<std::size_t> drawingOrder(const std::vector<ListedView>& views) {
    std::vector<std::size_t> order(views.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const dat::BlockCoord x = engine::centreOf(views[a].view), y = engine::centreOf(views[b].view);
        return std::pair(x.x, x.y) < std::pair(y.x, y.y);
    });
    return order;
}

/// Writes the bytes that `make` returns, unless the path is empty.
template <class Make>
Result<void> writeIfGiven(const std::filesystem::path& path, Make&& make) {
    return path.empty() ? Result<void>{} : output::writeFile(path, make());
}

/// Traces one view instead of drawing it.
Result<void> trace(engine::PartPlanner& loaded, reference::Scene& scene, const engine::WorldSource& source,
                   const ListedView& listed, const Console& console) {
    const engine::LoadedPart& part = *loaded.part;
    const Result<engine::FrameRequest> request = requestOf(part, source.file, listed.view, console);
    if (!request)
        return Failure(request.error());
    world::DynamicState dynamics;
    loaded.dynamics.build(engine::dynamicsInput(part.world, *request), dynamics);
    scene.setDynamics(dynamics);
    const output::TracedFrame frame = output::traceFrame(scene, *request);
    const OutputPaths& outputs = listed.outputs;
    const std::uint32_t width = request->size.width, height = request->size.height;
    if (!outputs.frame.empty()) {
        if (Result<void> written = output::writePicture(outputs.frame, frame.painting()); !written)
            return written;
    }
    if (Result<void> written = writeIfGiven(
            outputs.ids,
            [&] { return output::encodeNpy(width, height, std::span<const std::uint32_t>(frame.ids())); });
        !written)
        return written;
    if (Result<void> written = writeIfGiven(
            outputs.depth,
            [&] { return output::encodeNpy(width, height, std::span<const float>(frame.depth())); });
        !written)
        return written;
    return writeIfGiven(outputs.json, [&] {
        return output::tracedJson(part.world, part.ids, *request, dynamics, frame, source.datOption)
                   .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
               "\n";
    });
}

/// Prints the files that were written.
void report(const ShotOptions& options, const std::vector<ListedView>& views, const Console& console) {
    if (!options.views.empty()) {
        std::size_t files = 0;
        for (const ListedView& view : views)
            files += view.outputs.all().size();
        const std::filesystem::path directory = options.outputs.frame.empty() ? "." : options.outputs.frame;
        console.wrote(directory, fmt::format("{} files of {} views", files, views.size()));
        return;
    }
    for (const ListedView& view : views)
        for (const std::filesystem::path& path : view.outputs.all())
            console.wrote(path, fmt::format("{}x{}", view.view.size.width, view.view.size.height));
}

Exit stopped(std::size_t done, std::size_t count, const Console& console) {
    console.note(fmt::format("limen: stopped after {} of {} views", done, count));
    return Exit::Interrupted;
}

Result<void> loadFor(engine::Session& session, const ListedView& listed, const Console& console) {
    const Waiting waiting(console, "loading the world");
    return session.load(engine::centreOf(listed.view));
}

Result<void> checkViewsFit(const std::vector<ListedView>& views, const ShotOptions& options,
                           const gpu::Capabilities& capabilities) {
    const std::optional<std::uint64_t> available = engine::availableMemory();
    for (const ListedView& view : views)
        if (Result<void> fits = engine::checkFrameFits(
                view.view.size, engine::samplesOn(capabilities, options.session), capabilities, available);
            !fits)
            return fits;
    return {};
}

/// Errors: a view without an output.
Result<void> checkSomethingIsWritten(const std::vector<ListedView>& views) {
    for (const ListedView& view : views)
        if (view.outputs.all().empty())
            return fail(ErrorCode::BadArgument, "shot",
                        "no output given, so nothing would be written; add -o FILE for the picture");
    return {};
}

/// Traces all views. Needs no device and no GL.
Result<Exit> runTraced(const engine::WorldSource& source, const ShotOptions& options,
                       const std::vector<ListedView>& views, const Console& console) {
    std::unique_ptr<engine::PartPlanner> loaded;
    std::optional<reference::Scene> scene;
    Progress progress(console, "shot", views.size());
    std::size_t done = 0;
    if (views.size() > 1)
        console.interrupt().defer();
    for (const std::size_t i : drawingOrder(views)) {
        if (console.interrupt().isRequested())
            return stopped(done, views.size(), console);
        const engine::PartTarget target{engine::centreOf(views[i].view), options.session.load};
        if (!loaded || !(loaded->part->target == target)) {
            const bool first = !loaded;
            scene.reset(); // it refers to the old world
            loaded.reset();
            const Waiting waiting(console, "loading the world");
            const Result<world::MovingEntries> moving =
                engine::movingAround(source, target.centre, target.options);
            if (!moving)
                return Failure(moving.error());
            Result<std::shared_ptr<const engine::LoadedPart>> next =
                engine::loadPart(source.archive, target, *moving);
            if (!next)
                return Failure(next.error());
            loaded = std::make_unique<engine::PartPlanner>(std::move(*next));
            scene.emplace(loaded->part->world);
            if (const std::string findings = engine::findingsLine(loaded->part->world);
                first && !findings.empty())
                console.note(findings);
        }
        if (Result<void> traced = trace(*loaded, *scene, source, views[i], console); !traced)
            return Failure(traced.error());
        progress.step(++done);
    }
    report(options, views, console);
    return Exit::Done;
}

/// Errors: an output that a traced frame does not have.
Result<void> checkTraceable(const std::vector<ListedView>& views) {
    for (const ListedView& view : views) {
        if (!view.outputs.overlay.empty())
            return fail(ErrorCode::BadArgument, "--overlay",
                        "needs the visits of a drawn frame; omit it or --reference");
    }
    return {};
}

/// Errors: outputs that have one sample a pixel; a picture with too many samples.
Result<void> checkSupersampling(const ShotOptions& options, const std::vector<ListedView>& views) {
    if (options.supersample == 1)
        return {};
    if (options.reference)
        return fail(ErrorCode::BadArgument, "--supersample",
                    "the reference traces one ray a pixel; leave out --supersample or --reference");
    for (const ListedView& view : views) {
        if (!view.outputs.ids.empty() || !view.outputs.depth.empty())
            return fail(
                ErrorCode::BadArgument, "--supersample",
                "ids and depth have one value a pixel and cannot be filtered; write them in a run without "
                "--supersample");
        if (Result<void> fits = engine::checkLargePicture(view.view.size, options.supersample); !fits)
            return fits;
    }
    return {};
}

/// Errors: a depth image of the depth gate, which overwrites depth within the frame.
Result<void> checkDepthRemains(const ShotOptions& options, const std::vector<ListedView>& views) {
    const bool wantsDepth = std::any_of(views.begin(), views.end(),
                                        [](const ListedView& view) { return !view.outputs.depth.empty(); });
    if (wantsDepth && !options.reference && options.session.gate == frame::Gate::Depth)
        return fail(
            ErrorCode::BadArgument, "--depth",
            "the depth gate overwrites depth within the frame and has no depth image; use another --gate");
    return {};
}

/// Ids and depth are for proofs: exact, unless the user asks otherwise.
engine::SessionOptions sessionOptionsFor(const ShotOptions& options, const std::vector<ListedView>& views) {
    engine::SessionOptions session = options.session;
    const bool anyProof = std::any_of(views.begin(), views.end(), [](const ListedView& view) {
        return !view.outputs.ids.empty() || !view.outputs.depth.empty();
    });
    if (anyProof && !options.isDrawingGiven)
        session.drawing = gpu::Drawing::Exact;
    return session;
}

Result<Exit> runShot(const ShotOptions& options, const Console& console) {
    Result<std::vector<ListedView>> views = viewsOf(options);
    if (!views)
        return Failure(views.error());
    if (Result<void> written = checkSomethingIsWritten(*views); !written)
        return Failure(written.error());
    if (Result<void> traceable = options.reference ? checkTraceable(*views) : Result<void>{}; !traceable)
        return Failure(traceable.error());
    if (Result<void> remains = checkDepthRemains(options, *views); !remains)
        return Failure(remains.error());
    if (Result<void> checked = checkSupersampling(options, *views); !checked)
        return Failure(checked.error());
    if (Result<void> checked = checkAllOutputs(options, *views); !checked)
        return Failure(checked.error());
    const bool namesPlaces = std::any_of(views->begin(), views->end(), [](const ListedView& listed) {
        return listed.view.isAtStart || !listed.view.place.empty();
    });
    Result<engine::WorldSource> source = openWorld(
        console, options.session.dat, namesPlaces ? engine::PlaceSearch::Find : engine::PlaceSearch::Skip);
    if (!source)
        return Failure(source.error());
    for (ListedView& listed : *views) {
        Result<engine::ViewRequest> resolved = engine::resolvePlace(std::move(listed.view), *source);
        if (!resolved)
            return Failure(resolved.error());
        listed.view = std::move(*resolved);
    }
    if (options.reference)
        return runTraced(*source, options, *views, console);
    Result<engine::HeadlessSession> headless = engine::openHeadless(
        std::make_shared<const engine::WorldSource>(std::move(*source)), sessionOptionsFor(options, *views));
    if (!headless)
        return Failure(headless.error());
    engine::Session& session = *headless->session;
    if (Result<void> fit = checkViewsFit(*views, options, headless->device->capabilities()); !fit)
        return Failure(fit.error());
    Progress progress(console, "shot", views->size());
    std::size_t done = 0;
    if (views->size() > 1)
        console.interrupt().defer();
    for (const std::size_t i : drawingOrder(*views)) {
        if (console.interrupt().isRequested())
            return stopped(done, views->size(), console);
        const bool first = !session.isLoaded();
        if (Result<void> loaded = loadFor(session, (*views)[i], console); !loaded)
            return Failure(loaded.error());
        if (const std::string findings = engine::findingsLine(session.part().world);
            first && !findings.empty())
            console.note(findings);
        if (Result<void> shot = shoot(session, (*views)[i], options.supersample, console); !shot)
            return Failure(shot.error());
        progress.step(++done);
    }
    report(options, *views, console);
    return Exit::Done;
}

} // namespace

void addShotVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("shot", "draw one frame, or many, to files");
    const auto options = std::make_shared<ShotOptions>();
    addViewOptions(*verb, options->view);
    addOutputOptions(*verb, options->outputs);
    verb->add_option("--views", options->views,
                     "draw one frame per line of this file; a line holds options such as --at hill --yaw 90; "
                     "-o is then a directory (none)")
        ->type_name("FILE")
        ->group("Output");
    verb->add_flag("--reference", options->reference,
                   "trace rays on the CPU by the ray rule instead of drawing; the picture has one colour per "
                   "id, the JSON lists the cells in which rays end and has no visits or stages")
        ->group("Output");
    verb->add_option(
            "--supersample", options->supersample,
            "draw N x N samples a pixel and filter them in linear light, 1 to 8; the picture's longer side "
            "times N can be 16384 (1)")
        ->type_name("N")
        ->check(CLI::Range(1u, engine::kMostSupersampling))
        ->group("Output");
    addSessionOptions(*verb, options->session);
    addDrawing(*verb, options->session, gpu::Drawing::Fast, "fast; exact with --ids or --depth");
    addGate(*verb, options->session);
    verb->footer("Writes only the outputs that are given.\n"
                 "Examples:\n  limen shot --at hill -o hill.png\n"
                 "  limen shot --at inn.hall --yaw 90 --size 640x360 -o hall.png --json hall.json");
    verb->callback([&console, &choice, options, verb] {
        options->isDrawingGiven = verb->count("--draw") > 0;
        choice.run = [&console, options] { return runShot(*options, console); };
    });
}

} // namespace limen::cli
