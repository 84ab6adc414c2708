#include "app/CameraPath.h"
#include "app/OutputFile.h"
#include "app/Picture.h"
#include "app/RootTracker.h"
#include "app/Session.h"
#include "app/ShotRequest.h"
#include "app/Verbs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::app {
namespace {

struct TourOptions {
    SessionOptions session;
    std::string directory, path, size = "960x540", fov = "60", time = "0.5", frames, fps;
    bool json = false;
};

/// What a tour is asked for, checked.
struct TourRequest {
    PixelSize size;
    double fov = 60.0, time = 0.5, fps = 0.0;
    std::size_t frames = 120; ///< unless fps > 0
};

constexpr std::size_t kMaxFrames = 100000;
constexpr std::size_t kSheetTiles = 24;

Result<TourRequest> checkTour(const TourOptions& options) {
    TourRequest request;
    const Result<PixelSize> size = parseSize("--size", options.size);
    if (!size)
        return tl::unexpected(size.error());
    request.size = *size;
    if (!options.frames.empty() && !options.fps.empty())
        return fail(ErrorCode::BadArgument, "--fps", "give either --frames or --fps, not both");
    struct Number {
        const char* option;
        const std::string& text;
        double low, high;
        double& value;
    };
    double frames = static_cast<double>(request.frames);
    for (const Number& n : {Number{"--fov", options.fov, 0.1, 179.0, request.fov},
                            Number{"--time", options.time, 0.0, 1.0, request.time},
                            Number{"--frames", options.frames, 1.0, kMaxFrames, frames},
                            Number{"--fps", options.fps, 0.01, 1000.0, request.fps}}) {
        if (n.text.empty())
            continue;
        const Result<double> number = parseNumberBetween(n.option, n.text, n.low, n.high);
        if (!number)
            return tl::unexpected(number.error());
        n.value = *number;
    }
    if (frames != std::floor(frames))
        return fail(ErrorCode::BadArgument, "--frames",
                    fmt::format("'{}' is not a whole number", options.frames));
    request.frames = static_cast<std::size_t>(frames);
    return request;
}

/// The way points: of a file in the form of `shot`'s views files, or the world's own tour.
Result<std::vector<Standpoint>> wayPointsOf(const TourOptions& options, const world::WorldFile& file) {
    std::vector<Standpoint> points;
    if (options.path.empty()) {
        for (const world::Place& place : file.tour)
            points.push_back(standpointAt(place));
        if (points.empty())
            return fail(ErrorCode::NotFound, "tour",
                        "this world's world.json has no tour; give way points with --path FILE");
        return points;
    }
    const Result<std::vector<ListedView>> views = readViews(options.path, {}, {}, "");
    if (!views)
        return tl::unexpected(views.error());
    for (const ListedView& listed : *views) {
        Result<Standpoint> stand = standpointOf(listed.view, file);
        if (!stand)
            return tl::unexpected(stand.error());
        points.push_back(*stand);
    }
    return points;
}

/// The camera on its way: where it is, and the space it was swept into. A path that leads through a wall is followed
/// all the same (RootTracker).
class Walk {
public:
    Walk(Session& session, const CameraPath& path, FrameEye start)
        : session_(session), path_(path), eye_(std::move(start)), tracker_(eye_.root) {}

    /// Moves to a later time on the path, through every corner on the way.
    const FrameEye& moveTo(double time) {
        eye_.seconds = time;
        path_.cornersBetween(time_, time, corners_);
        const Camera camera = path_.at(time);
        corners_.push_back(camera.eye);
        const double seconds = (time - time_) / static_cast<double>(corners_.size());
        for (const Vec3& corner : corners_) {
            eye_.root = tracker_.move(session_.loaded().world, eye_.camera.eye, corner, seconds);
            eye_.camera.eye = corner;
        }
        eye_.camera.heading = camera.heading;
        eye_.player = eye_.camera.eye;
        if (session_.follow(eye_.camera.eye, eye_.root))
            tracker_.place(eye_.root);
        time_ = time;
        return eye_;
    }

private:
    Session& session_;
    const CameraPath& path_;
    FrameEye eye_;
    RootTracker tracker_;
    double time_ = 0.0;
    std::vector<Vec3> corners_;
};

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

Result<void> drawFrames(Session& session, const CameraPath& path, const FrameEye& start,
                        const TourRequest& request, const TourOptions& options, const Console& console) {
    const std::size_t count =
        request.fps > 0.0 ? std::min(kMaxFrames, static_cast<std::size_t>(path.seconds() * request.fps) + 1)
                          : request.frames;
    const std::filesystem::path directory = options.directory;
    ContactSheet sheet(count, kSheetTiles, 6, 320);
    Walk walk(session, path, start);
    Progress progress(console, "tour", count);
    for (std::size_t frame = 0; frame < count; ++frame) {
        const double time =
            request.fps > 0.0 ? static_cast<double>(frame) / request.fps : path.timeOfFrame(frame, count);
        const FrameEye& eye = walk.moveTo(time);
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

Result<CameraPath> makePath(const LoadedWorld& loaded, const std::vector<Standpoint>& points,
                            PixelSize size) {
    std::vector<world::Place> places;
    for (const Standpoint& point : points) {
        Standpoint free =
            point; // only the position matters here; cells of later way points may not be loaded yet
        free.root = {RootChoice::Kind::Outside, 0};
        const Result<FrameEye> eye = placeEye(loaded, free, size);
        if (!eye)
            return tl::unexpected(eye.error());
        world::Place place;
        place.eye = eye->camera.eye;
        place.yaw = eye->camera.heading.yaw;
        place.pitch = eye->camera.heading.pitch;
        places.push_back(std::move(place));
    }
    return CameraPath(places);
}

/// Everything that a tour needs before its first frame.
struct OpenTour {
    HeadlessSession headless;
    std::vector<Standpoint> points;
};

Result<OpenTour> openTour(const TourOptions& options) {
    if (Result<void> made = makeDirectory(options.directory); !made)
        return tl::unexpected(made.error());
    if (Result<void> writable = checkWritable(std::filesystem::path(options.directory) / "contact.png");
        !writable)
        return tl::unexpected(writable.error());
    Result<WorldSource> source = openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    Result<std::vector<Standpoint>> points = wayPointsOf(options, source->file);
    if (!points)
        return tl::unexpected(points.error());
    Result<HeadlessSession> headless =
        openHeadless(std::make_shared<const WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return tl::unexpected(headless.error());
    if (Result<void> loaded = headless->session->load(points->front().centre); !loaded)
        return tl::unexpected(loaded.error());
    return OpenTour{std::move(*headless), std::move(*points)};
}

Result<Exit> runTour(const TourOptions& options, const Console& console) {
    const Result<TourRequest> request = checkTour(options);
    if (!request)
        return tl::unexpected(request.error());
    Result<OpenTour> tour = openTour(options);
    if (!tour)
        return tl::unexpected(tour.error());
    Session& session = *tour->headless.session;
    if (const std::string findings = findingsLine(session.loaded().world); !findings.empty())
        console.note(findings);
    Standpoint first = tour->points.front();
    first.camera.fovDegrees = request->fov;
    Result<FrameEye> start = placeEye(session.loaded(), first, request->size);
    if (!start)
        return tl::unexpected(start.error());
    start->time = request->time;
    const Result<CameraPath> path = makePath(session.loaded(), tour->points, request->size);
    if (!path)
        return tl::unexpected(path.error());
    if (Result<void> drawn = drawFrames(session, *path, *start, *request, options, console); !drawn)
        return tl::unexpected(drawn.error());
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
    verb->add_option("--path", options->path,
                     "way points, one line of shot's options each; the world's own tour unless said")
        ->type_name("FILE");
    verb->add_option("--size", options->size, "picture size in pixels (960x540)")->type_name("WxH");
    verb->add_option("--frames", options->frames, "how many frames, spread evenly (120)")->type_name("N");
    verb->add_option("--fps", options->fps, "or how many for each second of walking")->type_name("F");
    verb->add_option("--fov", options->fov, "vertical field of view (60)")->type_name("DEG");
    verb->add_option("--time", options->time, "time of day, 0 and 1 midnight (0.5)")->type_name("0..1");
    verb->add_flag("--json", options->json, "one JSON object for each frame on standard output");
    addSessionOptions(*verb, options->session);
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runTour(*options, console); };
    });
}

} // namespace limen::app
