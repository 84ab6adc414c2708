#include "app/Npy.h"
#include "app/OutputFile.h"
#include "app/RegionOverlay.h"
#include "app/Session.h"
#include "app/ShotRequest.h"
#include "app/TracedFrame.h"
#include "app/Verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace limen::app {
namespace {

struct ShotOptions {
    SessionOptions session;
    ViewArguments view;
    OutputPaths outputs;
    std::string views;
    bool reference = false; ///< trace instead of drawing
};

/// Distances as depth.npy has them: infinite only for sky, NaN for holes.
std::vector<float> depthOf(const Session& session, std::span<const std::uint32_t> ids) {
    std::vector<float> depth = session.target().readDistances(session.plan().constants);
    for (std::size_t i = 0; i < depth.size(); ++i)
        if (ids[i] == kVoidPixel)
            depth[i] = std::numeric_limits<float>::quiet_NaN();
        else if (ids[i] == kSkyPixel)
            depth[i] = std::numeric_limits<float>::infinity();
    return depth;
}

/// The picture for people, and the one with the visits outlined.
Result<void> writePictures(Session& session, const FrameEye& eye, const OutputPaths& outputs) {
    if (Result<void> drawn = session.draw(eye, {.ids = false}); !drawn)
        return drawn;
    Picture picture = pictureFromRgba(eye.size.width, eye.size.height, session.target().readColour());
    if (!outputs.frame.empty()) {
        if (Result<void> written = writePicture(outputs.frame, picture); !written)
            return written;
    }
    if (outputs.overlay.empty())
        return {};
    drawRegions(picture, session.visible());
    return writePicture(outputs.overlay, picture);
}

/// Ids, depth and the frame as JSON, from a picture of their own with cut-outs tested exactly.
Result<void> writeMeasurements(Session& session, const FrameEye& eye, const OutputPaths& outputs) {
    if (Result<void> drawn = session.draw(eye, {.ids = true}); !drawn)
        return drawn;
    const std::vector<std::uint32_t> ids = session.target().readIds();
    if (!outputs.ids.empty()) {
        if (Result<void> written =
                writeFile(outputs.ids, encodeNpy(eye.size.width, eye.size.height, std::span(ids)));
            !written)
            return written;
    }
    if (!outputs.depth.empty()) {
        const std::vector<float> depth = depthOf(session, ids);
        if (Result<void> written =
                writeFile(outputs.depth, encodeNpy(eye.size.width, eye.size.height, std::span(depth)));
            !written)
            return written;
    }
    if (outputs.json.empty())
        return {};
    nlohmann::ordered_json json =
        frameJson(session.loaded().world, session.loaded().ids, eye, session.dynamics(), session.visible(),
                  session.plan(), session.figures(), ids);
    json["command"] = reproduction(session.loaded().world, eye, session.source().datOption);
    return writeFile(outputs.json, json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

Result<FrameEye> eyeOf(const LoadedWorld& loaded, const world::WorldFile& file, const ListedView& listed,
                       const Viewpoint& stand, const Console& console) {
    Result<FrameEye> eye = placeEye(loaded, stand, listed.view.size);
    if (!eye)
        return eye;
    if (Result<void> applied = applyDynamics(loaded, file, listed.view, *eye); !applied)
        return tl::unexpected(applied.error());
    if (eye->rootAmbiguous)
        console.note(fmt::format("limen: several cells claim the eye; {} is taken, --root names another",
                                 spaceName(loaded.world, eye->root)));
    return eye;
}

Result<void> shoot(Session& session, const ListedView& listed, const Viewpoint& stand,
                   const Console& console) {
    const Result<FrameEye> eye = eyeOf(session.loaded(), session.source().file, listed, stand, console);
    if (!eye)
        return tl::unexpected(eye.error());
    const OutputPaths& outputs = listed.outputs;
    const bool measure = !outputs.ids.empty() || !outputs.depth.empty() || !outputs.json.empty();
    const bool paint = !outputs.frame.empty() || !outputs.overlay.empty() || !measure;
    if (paint) {
        if (Result<void> written = writePictures(session, *eye, outputs); !written)
            return written;
    }
    return measure ? writeMeasurements(session, *eye, outputs) : Result<void>{};
}

Result<std::vector<ListedView>> viewsOf(const ShotOptions& options) {
    if (options.views.empty()) {
        Result<ViewRequest> view = checkView(options.view);
        if (!view)
            return tl::unexpected(view.error());
        return std::vector<ListedView>{{std::move(*view), options.outputs}};
    }
    OutputPaths common = options.outputs;
    common.frame.clear(); // there it names the directory
    return readViews(options.views, options.view, common, options.outputs.frame);
}

Result<void> checkAllOutputs(const ShotOptions& options, const std::vector<ListedView>& views) {
    if (!options.views.empty() && !options.outputs.frame.empty()) {
        if (Result<void> made = makeDirectory(options.outputs.frame); !made)
            return made;
    }
    std::vector<std::filesystem::path> outputs;
    for (const ListedView& view : views) {
        const std::vector<std::filesystem::path> all = view.outputs.all();
        outputs.insert(outputs.end(), all.begin(), all.end());
    }
    return checkOutputs(outputs);
}

/// The order to draw in: views of one landblock together, so that each part of the world is loaded once.
std::vector<std::size_t> drawingOrder(const std::vector<Viewpoint>& stands) {
    std::vector<std::size_t> order(stands.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const dat::BlockCoord &x = stands[a].centre, &y = stands[b].centre;
        return std::pair(x.x, x.y) < std::pair(y.x, y.y);
    });
    return order;
}

/// Writes `bytes` made by `make` if the output is asked for.
template <class Make>
Result<void> writeIfAsked(const std::filesystem::path& path, Make&& make) {
    return path.empty() ? Result<void>{} : writeFile(path, make());
}

/// One view traced instead of drawn.
Result<void> trace(LoadedWorld& loaded, reference::Scene& scene, const WorldSource& source,
                   const ListedView& listed, const Viewpoint& stand, const Console& console) {
    const Result<FrameEye> eye = eyeOf(loaded, source.file, listed, stand, console);
    if (!eye)
        return tl::unexpected(eye.error());
    world::DynamicState dynamics;
    loaded.dynamicsBuilder.build(dynamicsInput(loaded.world, *eye), dynamics);
    scene.setDynamics(dynamics);
    const TracedFrame frame = traceFrame(scene, *eye);
    const OutputPaths& outputs = listed.outputs;
    const std::uint32_t width = eye->size.width, height = eye->size.height;
    if (!outputs.frame.empty()) {
        if (Result<void> written = writePicture(outputs.frame, frame.painting()); !written)
            return written;
    }
    if (Result<void> written = writeIfAsked(
            outputs.ids,
            [&] { return encodeNpy(width, height, std::span<const std::uint32_t>(frame.ids())); });
        !written)
        return written;
    if (Result<void> written = writeIfAsked(
            outputs.depth, [&] { return encodeNpy(width, height, std::span<const float>(frame.depth())); });
        !written)
        return written;
    return writeIfAsked(outputs.json, [&] {
        return tracedJson(loaded.world, loaded.ids, *eye, dynamics, frame, source.datOption)
                   .dump(1, ' ', false, nlohmann::json::error_handler_t::replace) +
               "\n";
    });
}

/// All views traced: no device, no GL.
Result<Exit> runTraced(const WorldSource& source, const ShotOptions& options,
                       const std::vector<ListedView>& views, const std::vector<Viewpoint>& stands,
                       const Console& console) {
    std::unique_ptr<LoadedWorld> loaded;
    std::optional<reference::Scene> scene;
    Progress progress(console, "shot", views.size());
    std::size_t done = 0;
    for (const std::size_t i : drawingOrder(stands)) {
        if (!loaded || loaded->centre != stands[i].centre) {
            const bool first = !loaded;
            scene.reset(); // it refers to the world that goes
            Result<std::unique_ptr<LoadedWorld>> next =
                LoadedWorld::load(source.archive, stands[i].centre, options.session.load, source.file.moving);
            if (!next)
                return tl::unexpected(next.error());
            loaded = std::move(*next);
            scene.emplace(loaded->world);
            if (const std::string findings = findingsLine(loaded->world); first && !findings.empty())
                console.note(findings);
        }
        if (Result<void> traced = trace(*loaded, *scene, source, views[i], stands[i], console); !traced)
            return tl::unexpected(traced.error());
        progress.step(++done);
    }
    return Exit::Done;
}

/// What a traced frame cannot be written to.
Result<void> checkTraceable(const std::vector<ListedView>& views) {
    for (const ListedView& view : views) {
        if (!view.outputs.overlay.empty())
            return fail(ErrorCode::BadArgument, "--overlay",
                        "outlines the visits of a drawn frame; leave it out with --reference");
    }
    return {};
}

Result<Exit> runShot(const ShotOptions& options, const Console& console) {
    const Result<std::vector<ListedView>> views = viewsOf(options);
    if (!views)
        return tl::unexpected(views.error());
    if (Result<void> traceable = options.reference ? checkTraceable(*views) : Result<void>{}; !traceable)
        return tl::unexpected(traceable.error());
    if (Result<void> checked = checkAllOutputs(options, *views); !checked)
        return tl::unexpected(checked.error());
    Result<WorldSource> source = openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    std::vector<Viewpoint> stands;
    for (const ListedView& listed : *views) {
        Result<Viewpoint> stand = viewpointOf(listed.view, source->file);
        if (!stand)
            return tl::unexpected(stand.error());
        stands.push_back(*stand);
    }
    if (options.reference)
        return runTraced(*source, options, *views, stands, console);
    Result<HeadlessSession> headless =
        openHeadless(std::make_shared<const WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return tl::unexpected(headless.error());
    Session& session = *headless->session;
    Progress progress(console, "shot", views->size());
    std::size_t done = 0;
    for (const std::size_t i : drawingOrder(stands)) {
        const bool first = !session.isLoaded();
        if (Result<void> loaded = session.load(stands[i].centre); !loaded)
            return tl::unexpected(loaded.error());
        if (const std::string findings = findingsLine(session.loaded().world); first && !findings.empty())
            console.note(findings);
        if (Result<void> shot = shoot(session, (*views)[i], stands[i], console); !shot)
            return tl::unexpected(shot.error());
        progress.step(++done);
    }
    return Exit::Done;
}

} // namespace

void addShotVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("shot", "draws one frame, or many, to files");
    const auto options = std::make_shared<ShotOptions>();
    addViewOptions(*verb, options->view);
    addOutputOptions(*verb, options->outputs);
    verb->add_option("--views", options->views,
                     "a file with one line of these options for each of many frames; -o is a directory then")
        ->type_name("FILE")
        ->group("Output");
    verb->add_flag(
            "--reference", options->reference,
            "trace the rule ray by ray instead of drawing, without GL: the picture is one colour an id, the "
            "JSON's cells are those that rays end in, its visits and stages are empty")
        ->group("Output");
    addSessionOptions(*verb, options->session);
    verb->footer("Nothing is written unless asked for.");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runShot(*options, console); };
    });
}

} // namespace limen::app
