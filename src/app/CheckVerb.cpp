#include "app/CheckDrawer.h"
#include "app/CheckPicture.h"
#include "app/DayGroup.h"
#include "app/FrameSource.h"
#include "app/OutputFile.h"
#include "app/Verbs.h"
#include "app/ViewOfEye.h"
#include "check/Run.h"
#include "gpu/NullDevice.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <memory>
#include <thread>

namespace limen::app {
namespace {

struct CheckOptions {
    SessionOptions session;
    std::string kinds, size, block, directory, resume, walk, doors = "rest", day, weather = "clear";
    std::size_t views = 1000;
    std::uint64_t seed = 1;
    bool apart = false, json = false;
};

constexpr std::size_t kMostViews = 100'000'000;
constexpr std::uint64_t kMostPictures = 500; ///< of findings; a broken world would fill the disk
constexpr std::size_t kStateLimit = 16u << 20;

Result<std::vector<check::ViewKind>> kindsOf(const std::string& list) {
    std::vector<check::ViewKind> kinds;
    for (std::size_t begin = 0; begin <= list.size() && !list.empty();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        const std::string_view name = trimmed(std::string_view(list).substr(begin, end - begin));
        const std::optional<check::ViewKind> kind = check::kindNamed(name);
        if (!kind)
            return fail(ErrorCode::BadArgument, "--kinds",
                        fmt::format("'{}' is none of random, outside, path, sweep, still", name));
        kinds.push_back(*kind);
        begin = end + 1;
    }
    if (kinds.empty())
        for (std::size_t i = 0; i < check::kKindCount; ++i)
            kinds.push_back(static_cast<check::ViewKind>(i));
    return kinds;
}

/// Leaves only the block that was asked for.
Result<void> restrictTo(const std::string& text, std::vector<check::BlockSummary>& blocks) {
    if (text.empty())
        return {};
    const Result<dat::RecordId> word = parseRecordId("--block", text);
    if (!word)
        return tl::unexpected(word.error());
    if (*word > 0xFFFFu)
        return fail(ErrorCode::BadArgument, "--block",
                    fmt::format("'{}' is not a landblock's four hexadecimal digits", text));
    std::erase_if(blocks,
                  [&](const check::BlockSummary& b) { return dat::blockWord(b.block) != *word << 16; });
    if (blocks.empty())
        return fail(ErrorCode::NotFound, "--block",
                    fmt::format("landblock {:04X} holds no cells and no buildings in this world", *word));
    return {};
}

/// Plays a walk again without a picture; each of its frames is looked at.
Result<check::RunRequest> addWalk(const CheckOptions& options,
                                  const std::shared_ptr<const WorldSource>& source, const Console& console,
                                  check::RunRequest request) {
    Result<WalkRecord> record = readWalk(options.walk);
    if (!record)
        return tl::unexpected(record.error());
    gpu::NullDevice device;
    Session session(source, options.session, device);
    const Result<std::unique_ptr<ReplayedFrames>> frames = ReplayedFrames::open(session, std::move(*record));
    if (!frames)
        return tl::unexpected(frames.error());
    std::vector<check::View> views;
    for (std::size_t i = 0; i < (*frames)->count(); ++i) {
        const Result<const FrameEye*> eye = (*frames)->next();
        if (!eye)
            return tl::unexpected(eye.error());
        if (Result<void> drawn = session.draw(**eye, {}); !drawn)
            return tl::unexpected(drawn.error());
        views.push_back(viewOf(**eye, session.loaded().world));
        views.back().kind = check::ViewKind::Path;
        views.back().width = request.width;
        views.back().height = request.height;
        views.back().about = fmt::format("frame {} of the walk", i);
    }
    if (const std::string difference = differenceLine(**frames); !difference.empty())
        console.note(difference);
    request.tasks = check::tasksOf(views);
    return request;
}

Result<check::RunRequest> requestOf(const CheckOptions& options,
                                    const std::shared_ptr<const WorldSource>& source,
                                    const Console& console) {
    const Result<std::vector<check::ViewKind>> kinds = kindsOf(options.kinds);
    if (!kinds)
        return tl::unexpected(kinds.error());
    check::RunRequest request;
    request.seed = options.seed;
    request.tour = source->file.tour;
    const Result<std::optional<double>> doors = parseDoors("--doors", options.doors);
    if (!doors)
        return tl::unexpected(doors.error());
    request.doors = *doors;
    const Result<Weather> weather = parseWeather("--weather", options.weather);
    if (!weather)
        return tl::unexpected(weather.error());
    request.rain = *weather == Weather::Rain;
    const Result<dat::Region> region = source->archive.load<dat::Region>(dat::kRegionId);
    const Result<std::uint32_t> day = dayGroupOf(region ? region->sky : dat::SkyDesc(), options.day);
    if (!day)
        return tl::unexpected(day.error());
    request.dayGroup = *day;
    request.threads = std::max(1u, std::thread::hardware_concurrency());
    if (!options.size.empty()) {
        const Result<PixelSize> size = parseSize("--size", options.size);
        if (!size)
            return tl::unexpected(size.error());
        request.width = request.sweepWidth = size->width;
        request.height = request.sweepHeight = size->height;
    }
    if (!options.walk.empty())
        return addWalk(options, source, console, request);
    Result<std::vector<check::BlockSummary>> blocks = check::blocksOf(source->archive);
    if (!blocks)
        return tl::unexpected(blocks.error());
    if (Result<void> left = restrictTo(options.block, *blocks); !left)
        return tl::unexpected(left.error());
    const std::vector<check::ViewKind> placed = check::kindsWithPlaces(*kinds, *blocks);
    request.tasks =
        check::planTasks(*blocks, source->file.tour, check::shareAmongKinds(options.views, placed));
    if (request.tasks.empty())
        return fail(ErrorCode::NotFound, "check", "this world has nothing that these kinds of view look at");
    return request;
}

/// What `limen shot` needs to load the same world.
std::string worldOptions(const CheckOptions& options, const WorldSource& source) {
    std::string text = source.datOption;
    if (!options.session.load.mergeZones)
        text += " --zones cells";
    if (options.session.load.radius != world::LoadOptions{}.radius)
        text += fmt::format(" --radius {}", options.session.load.radius);
    return text;
}

/// Everything that decides which views are checked and how.
std::string nameOfRun(const CheckOptions& options, const std::string& world) {
    return fmt::format("views {} kinds '{}' seed {} size '{}' block '{}' doors '{}' day '{}' weather '{}' "
                       "world '{}' samples {}{}",
                       options.views, options.kinds, options.seed, options.size, options.block, options.doors,
                       options.day, options.weather, world, options.session.samples,
                       options.walk.empty() ? "" : " walk '" + options.walk + "'");
}

Result<check::Progress> progressOf(const CheckOptions& options, const std::string& run) {
    check::Progress progress;
    progress.run = run;
    if (options.resume.empty() || !std::filesystem::exists(options.resume))
        return progress;
    const Result<std::string> text = readTextFile(options.resume, kStateLimit);
    if (!text)
        return tl::unexpected(text.error());
    Result<check::Progress> before = check::parseProgress(*text);
    if (!before)
        return fail(before.error().code, options.resume, before.error().what);
    if (before->run != run)
        return fail(ErrorCode::BadArgument, options.resume,
                    "is the state of another run (" + before->run +
                        "); ask for that again, or name another file");
    return before;
}

Result<void> checkOutputPlaces(const CheckOptions& options) {
    if (!options.directory.empty()) {
        if (Result<void> made = makeDirectory(options.directory); !made)
            return made;
        if (Result<void> writable =
                checkWritable(std::filesystem::path(options.directory) / "finding-00000000.png");
            !writable)
            return writable;
    }
    return options.resume.empty() ? Result<void>{} : checkWritable(options.resume);
}

check::RunEvents eventsOf(const CheckOptions& options, const Console& console, Progress& bar) {
    check::RunEvents events;
    events.step = [&bar](std::size_t done) { bar.step(done); };
    events.leftOut = [&console](dat::BlockCoord block, const Error& error) {
        console.note(
            fmt::format("limen: landblock {:02X}{:02X} is left out: {}", block.x, block.y, error.message()));
    };
    if (!options.resume.empty())
        events.saved = [&options](const check::Progress& state) {
            return writeFile(options.resume, check::progressJson(state));
        };
    if (!options.directory.empty()) {
        const auto written = std::make_shared<std::atomic<std::uint64_t>>(0);
        events.picture = [&options, written](const check::FindingPicture& finding) -> Result<void> {
            if ((*written)++ >= kMostPictures)
                return {};
            const std::string name =
                fmt::format("finding-{:08}-{}.png", finding.number, check::nameOf(finding.view.kind));
            return writePicture(std::filesystem::path(options.directory) / name, pictureOfFinding(finding));
        };
    }
    return events;
}

Result<Exit> runCheckVerb(CheckOptions options, const Console& console) {
    if (options.apart)
        options.session.load.mergeZones = false;
    if (Result<void> places = checkOutputPlaces(options); !places)
        return tl::unexpected(places.error());
    Result<WorldSource> source = openWorldSource(options.session.dat);
    if (!source)
        return tl::unexpected(source.error());
    const check::ReportContext context{options.seed, worldOptions(options, *source)};
    Result<check::Progress> progress = progressOf(options, nameOfRun(options, context.worldOptions));
    if (!progress)
        return tl::unexpected(progress.error());
    Result<HeadlessSession> headless =
        openHeadless(std::make_shared<const WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return tl::unexpected(headless.error());
    const Result<check::RunRequest> request = requestOf(options, headless->session->shareSource(), console);
    if (!request)
        return tl::unexpected(request.error());
    CheckDrawer drawer(*headless->session, !options.directory.empty(), options.session.samples > 1);
    {
        Progress bar(console, "check", check::viewsAsked(*request));
        const check::RunEvents events = eventsOf(options, console, bar);
        if (Result<void> done = check::runCheck(*request, drawer, events, *progress); !done)
            return tl::unexpected(done.error());
    }
    const check::Totals& totals = progress->totals;
    if (totals.sum().views == 0)
        return fail(ErrorCode::NotFound, "check", "no view could be taken of this world");
    console.data(options.json ? check::reportJson(totals, context) : check::reportText(totals, context));
    return totals.sum().findings() > 0 ? Exit::Finding : Exit::Done;
}

} // namespace

void addCheckVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("check", "draws and traces the same views and says where the pictures differ");
    const auto options = std::make_shared<CheckOptions>();
    verb->add_option("--views", options->views, "how many views, shared out among the kinds (1000)")
        ->type_name("N")
        ->check(CLI::Range(std::size_t{1}, kMostViews));
    verb->add_option("--kinds", options->kinds, "some of random,outside,path,sweep,still; all unless said")
        ->type_name("LIST");
    verb->add_option("--seed", options->seed, "another number gives other views (1)")->type_name("N");
    verb->add_option("--size", options->size, "picture size in pixels (640x360; of sweeps 160x90)")
        ->type_name("WxH");
    verb->add_option("--block", options->block, "one landblock only, as four hexadecimal digits")
        ->type_name("XXYY");
    verb->add_option("--doors", options->doors,
                     "how far all doors stand open: rest, closed, half, open or 0..1 (rest)")
        ->type_name("STATE");
    verb->add_option("--day", options->day, "the kind of day, of those that the data has (0)")
        ->type_name("NUMBER|NAME");
    verb->add_option("--weather", options->weather, "clear or rain (clear)")->type_name("WEATHER");
    CLI::Option* walk =
        verb->add_option("--walk", options->walk,
                         "every frame of a walk that limen view --record has written, instead")
            ->type_name("FILE");
    for (const char* other : {"--views", "--kinds", "--seed", "--block", "--doors", "--day", "--weather"})
        walk->excludes(other);
    verb->add_flag("--apart", options->apart, "every cell its own zone, as --zones cells");
    verb->add_option("-o,--output", options->directory,
                     "a directory for a picture of each view with a finding; made if it is missing")
        ->type_name("DIR");
    verb->add_option("--resume", options->resume,
                     "keeps the state of the run in this file, and continues from it if it is there")
        ->type_name("FILE");
    verb->add_flag("--json", options->json, "the result as one JSON object");
    addSessionOptions(*verb, options->session);
    verb->footer("With --msaa 4 pictures are drawn flat by id and judged by colour, sample by sample.\n"
                 "Exit codes: 0 every pixel is right, 1 some are not, 2 it could not be done.");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runCheckVerb(*options, console); };
    });
}

} // namespace limen::app
