#include "cli/SessionArguments.h"
#include "cli/ShotRequest.h"
#include "cli/Verbs.h"
#include "engine/CheckView.h"
#include "engine/Session.h"
#include "output/FrameJson.h"
#include "output/Npy.h"
#include "output/OutputFile.h"
#include "output/RegionOverlay.h"
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
    ViewArguments view;
    OutputPaths outputs;
    std::string views;
    bool reference = false; ///< trace instead of drawing
};

/// Distances for depth.npy: infinite only for sky, NaN for holes.
std::vector<float> depthOf(const engine::Session& session, std::span<const std::uint32_t> ids) {
    std::vector<float> depth = session.target().readDistances(session.plan().constants);
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (ids[i] == engine::kVoidPixel)
            depth[i] = std::numeric_limits<float>::quiet_NaN();
        else if (ids[i] == engine::kSkyPixel)
            depth[i] = std::numeric_limits<float>::infinity();
    return depth;
}

/// Writes the picture, and the picture with outlined visits.
Result<void> writePictures(engine::Session& session, const engine::FrameRequest& request,
                           const OutputPaths& outputs) {
    if (Result<void> drawn = session.draw(request, {.ids = false}); !drawn)
        return drawn;
    output::Picture picture =
        output::pictureFromRgba(request.size.width, request.size.height, session.target().readColour());
    if (!outputs.frame.empty()) {
        if (Result<void> written = output::writePicture(outputs.frame, picture); !written)
            return written;
    }
    if (outputs.overlay.empty())
        return {};
    output::drawRegions(picture, session.visible());
    return output::writePicture(outputs.overlay, picture);
}

/// Writes ids, depth and JSON from a separate frame, in which cut-outs are tested at the finest mip level.
Result<void> writeMeasurements(engine::Session& session, const engine::FrameRequest& request,
                               const OutputPaths& outputs) {
    if (Result<void> drawn = session.draw(request, {.ids = true}); !drawn)
        return drawn;
    const std::vector<std::uint32_t> ids = session.target().readIds();
    if (!outputs.ids.empty()) {
        if (Result<void> written = output::writeFile(
                outputs.ids, output::encodeNpy(request.size.width, request.size.height, std::span(ids)));
            !written)
            return written;
    }
    if (!outputs.depth.empty()) {
        const std::vector<float> depth = depthOf(session, ids);
        if (Result<void> written = output::writeFile(
                outputs.depth, output::encodeNpy(request.size.width, request.size.height, std::span(depth)));
            !written)
            return written;
    }
    if (outputs.json.empty())
        return {};
    nlohmann::ordered_json json =
        output::frameJson(session.part().world, session.part().ids, request, session.dynamics(),
                          session.visible(), session.plan(), session.figures(), ids);
    json["command"] = engine::reproduction(session.part().world, request, session.source().datOption);
    return output::writeFile(outputs.json,
                             json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<engine::FrameRequest> requestOf(const engine::LoadedPart& part, const world::WorldFile& file,
                                       const engine::ViewRequest& view, const Console& console) {
    Result<engine::FrameRequest> request = engine::frameRequest(part.world, file, view);
    if (request && request->isRootAmbiguous)
        console.note(fmt::format("limen: several cells contain the eye; using {}; choose another with --root",
                                 engine::spaceName(part.world, request->root)));
    return request;
}

Result<void> shoot(engine::Session& session, const ListedView& listed, const Console& console) {
    const Result<engine::FrameRequest> request =
        requestOf(session.part(), session.source().file, listed.view, console);
    if (!request)
        return tl::unexpected(request.error());
    const OutputPaths& outputs = listed.outputs;
    const bool measure = !outputs.ids.empty() || !outputs.depth.empty() || !outputs.json.empty();
    const bool paint = !outputs.frame.empty() || !outputs.overlay.empty() || !measure;
    if (paint) {
        if (Result<void> written = writePictures(session, *request, outputs); !written)
            return written;
    }
    return measure ? writeMeasurements(session, *request, outputs) : Result<void>{};
}

Result<std::vector<ListedView>> viewsOf(const ShotOptions& options) {
    if (options.views.empty()) {
        Result<engine::ViewRequest> view = checkView(options.view);
        if (!view)
            return tl::unexpected(view.error());
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
        return tl::unexpected(request.error());
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

/// Traces all views. Needs no device and no GL.
Result<Exit> runTraced(const engine::WorldSource& source, const ShotOptions& options,
                       const std::vector<ListedView>& views, const Console& console) {
    std::unique_ptr<engine::PartPlanner> loaded;
    std::optional<reference::Scene> scene;
    Progress progress(console, "shot", views.size());
    std::size_t done = 0;
    for (const std::size_t i : drawingOrder(views)) {
        const engine::PartTarget target{engine::centreOf(views[i].view), options.session.load};
        if (!loaded || !(loaded->part->target == target)) {
            const bool first = !loaded;
            scene.reset(); // it refers to the old world
            loaded.reset();
            Result<std::shared_ptr<const engine::LoadedPart>> next =
                engine::loadPart(source.archive, target, source.file.moving);
            if (!next)
                return tl::unexpected(next.error());
            loaded = std::make_unique<engine::PartPlanner>(std::move(*next));
            scene.emplace(loaded->part->world);
            if (const std::string findings = engine::findingsLine(loaded->part->world);
                first && !findings.empty())
                console.note(findings);
        }
        if (Result<void> traced = trace(*loaded, *scene, source, views[i], console); !traced)
            return tl::unexpected(traced.error());
        progress.step(++done);
    }
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

Result<Exit> runShot(const ShotOptions& options, const Console& console) {
    Result<std::vector<ListedView>> views = viewsOf(options);
    if (!views)
        return tl::unexpected(views.error());
    if (Result<void> traceable = options.reference ? checkTraceable(*views) : Result<void>{}; !traceable)
        return tl::unexpected(traceable.error());
    if (Result<void> checked = checkAllOutputs(options, *views); !checked)
        return tl::unexpected(checked.error());
    const bool namesPlaces = std::any_of(views->begin(), views->end(),
                                         [](const ListedView& listed) { return !listed.view.place.empty(); });
    Result<engine::WorldSource> source = engine::openWorldSource(
        options.session.dat, namesPlaces ? engine::PlaceSearch::Find : engine::PlaceSearch::Skip);
    if (!source)
        return tl::unexpected(source.error());
    for (ListedView& listed : *views) {
        Result<engine::ViewRequest> resolved = engine::resolvePlace(std::move(listed.view), source->file);
        if (!resolved)
            return tl::unexpected(resolved.error());
        listed.view = std::move(*resolved);
    }
    if (options.reference)
        return runTraced(*source, options, *views, console);
    Result<engine::HeadlessSession> headless = engine::openHeadless(
        std::make_shared<const engine::WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return tl::unexpected(headless.error());
    engine::Session& session = *headless->session;
    Progress progress(console, "shot", views->size());
    std::size_t done = 0;
    for (const std::size_t i : drawingOrder(*views)) {
        const bool first = !session.isLoaded();
        if (Result<void> loaded = session.load(engine::centreOf((*views)[i].view)); !loaded)
            return tl::unexpected(loaded.error());
        if (const std::string findings = engine::findingsLine(session.part().world);
            first && !findings.empty())
            console.note(findings);
        if (Result<void> shot = shoot(session, (*views)[i], console); !shot)
            return tl::unexpected(shot.error());
        progress.step(++done);
    }
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
                     "-o is then a directory")
        ->type_name("FILE")
        ->group("Output");
    verb->add_flag("--reference", options->reference,
                   "trace rays on the CPU by the ray rule instead of drawing; the picture has one colour per "
                   "id, the JSON lists the cells in which rays end and has no visits or stages")
        ->group("Output");
    addSessionOptions(*verb, options->session);
    verb->footer("Writes only the outputs that are given.\n"
                 "Example: limen shot --at hill --yaw 90 --size 640x360 -o hill.png --json hill.json");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runShot(*options, console); };
    });
}

} // namespace limen::cli
