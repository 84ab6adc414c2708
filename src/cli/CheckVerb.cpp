#include "cli/CheckPlan.h"
#include "cli/Choices.h"
#include "cli/OpenWorld.h"
#include "cli/Parse.h"
#include "cli/PathArguments.h"
#include "cli/ReportFacts.h"
#include "cli/SessionArguments.h"
#include "cli/Verbs.h"
#include "engine/CheckDrawer.h"
#include "engine/CheckView.h"
#include "engine/DayGroup.h"
#include "engine/FrameMemory.h"
#include "gpu/device/NullDevice.h"
#include "output/CheckPicture.h"
#include "output/Encode.h"
#include "output/OutputFile.h"
#include "output/report/CheckRecorder.h"
#include "play/FrameSource.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <memory>
#include <thread>

namespace limen::cli {
namespace {

constexpr std::size_t kMostViews = 100'000'000;
constexpr std::uint64_t kMostPictures = 500; ///< of findings; a broken world would fill the disk
constexpr std::size_t kStateLimit = 16u << 20;

/// Options with which `limen shot` loads the same world.
std::string worldOptions(const CheckOptions& options, const engine::WorldSource& source) {
    std::string text = source.datOption + engine::readingsOption(options.session.load.readings);
    if (!options.session.load.mergeZones)
        text += " --zones cells";
    if (options.session.gate != frame::Gate::Ownership)
        text += fmt::format(" --gate {}", frame::nameOf(options.session.gate));
    if (options.session.load.radius != world::LoadOptions{}.radius)
        text += fmt::format(" --radius {}", options.session.load.radius);
    return text;
}

/// All settings that affect the views and the check, as text. A run resumes only with equal settings.
std::string nameOfRun(const CheckOptions& options, const std::string& world) {
    return fmt::format("views {} kinds '{}' seed {} size '{}' block '{}' doors '{}' day '{}' weather '{}' "
                       "look '{}' world '{}' samples {}{}{}",
                       options.views, options.kinds, options.seed, options.size, options.block, options.doors,
                       options.day, options.weather, options.look, world, options.session.samples,
                       engine::readingsOption(options.session.load.readings),
                       options.walk.empty() ? "" : " walk '" + options.walk + "'");
}

Result<check::Progress> progressOf(const CheckOptions& options, const std::string& run) {
    check::Progress progress;
    progress.run = run;
    std::error_code ignored;
    if (options.resume.empty() || !std::filesystem::exists(options.resume, ignored))
        return progress;
    const Result<std::string> text = output::readTextFile(options.resume, kStateLimit);
    if (!text)
        return Failure(text.error());
    Result<check::Progress> before = check::parseProgress(*text);
    if (!before)
        return fail(before.error().code, options.resume, before.error().what);
    if (before->run != run)
        return fail(ErrorCode::BadArgument, options.resume,
                    "holds the state of a run with other options (" + before->run +
                        "); repeat those options, or name another file");
    return before;
}

Result<void> checkOutputPlaces(const CheckOptions& options) {
    if (!options.directory.empty()) {
        if (Result<void> made = output::makeDirectory(options.directory); !made)
            return made;
        if (Result<void> writable =
                output::checkWritable(std::filesystem::path(options.directory) / "finding-00000000.png");
            !writable)
            return writable;
    }
    if (Result<void> place = checkReportPlace(options.report); !place)
        return place;
    return options.resume.empty() ? Result<void>{} : output::checkWritable(options.resume);
}

/// Writes one picture file for a finding.
Result<void> writeFinding(const CheckOptions& options, const check::FindingPicture& finding) {
    const std::string name =
        fmt::format("finding-{:08}-{}.{}", finding.number, check::nameOf(finding.view.kind), options.format);
    return output::writePicture(std::filesystem::path(options.directory) / name,
                                output::pictureOfFinding(finding));
}

check::RunEvents eventsOf(const CheckOptions& options, const Console& console, Progress& bar,
                          std::optional<output::CheckRecorder>& recorder) {
    check::RunEvents events;
    events.step = [&bar](std::size_t done) { bar.step(done); };
    events.stopped = [&console] { return console.interrupt().isRequested(); };
    events.leftOut = [&console](dat::BlockCoord block, const Error& error) {
        console.note(
            fmt::format("limen: landblock {:02X}{:02X} is skipped: {}", block.x, block.y, error.message()));
    };
    if (!options.resume.empty())
        events.saved = [&options](const check::Progress& state) {
            return output::writeFile(options.resume, check::progressJson(state));
        };
    if (!options.directory.empty() || recorder) {
        const auto written = std::make_shared<std::atomic<std::uint64_t>>(0);
        events.picture = [&options, &recorder, written](const check::FindingPicture& finding) {
            Result<void> done = recorder ? recorder->addFinding(finding) : Result<void>{};
            if (done && !options.directory.empty() && (*written)++ < kMostPictures)
                done = writeFinding(options, finding);
            return done;
        };
    }
    if (recorder)
        events.right = [&recorder](const check::FindingPicture& view) { return recorder->addSample(view); };
    return events;
}

/// After a signal: saves the state, and reports the views judged so far.
Result<Exit> stopEarly(const CheckOptions& options, const check::Progress& progress,
                       const check::ReportContext& context, std::size_t asked, const Console& console) {
    if (!options.resume.empty()) {
        if (Result<void> saved = output::writeFile(options.resume, check::progressJson(progress)); !saved)
            return Failure(saved.error());
    }
    console.note(fmt::format("limen: stopped after {} of {} views{}", progress.totals.sum().views, asked,
                             options.resume.empty() ? "" : "; the same command with --resume continues"));
    if (progress.totals.sum().views > 0)
        console.data(options.json ? check::reportJson(progress.totals, context)
                                  : check::reportText(progress.totals, context));
    return Exit::Interrupted;
}

Result<void> writeCheckReport(const CheckOptions& options, engine::Session& session,
                              output::CheckRecorder recorder, const check::Totals& totals,
                              const Console& console) {
    if (Result<void> drawn = recorder.addLitPictures(session); !drawn)
        return drawn;
    output::ReportHead head = reportHead(session, options.command);
    head.facts.emplace_back("Seed", fmt::format("{}", options.seed));
    head.facts.emplace_back("Time", fmt::format("{:.1f} s", totals.seconds));
    const output::CheckReport report = std::move(recorder).finish(std::move(head), totals);
    const Result<std::string> page = writeReport(options.report, output::checkPage(report));
    if (!page)
        return Failure(page.error());
    console.wrote(*page, "the report");
    return {};
}

Result<Exit> runCheckVerb(CheckOptions options, const Console& console) {
    if (options.apart)
        options.session.load.mergeZones = false;
    if (Result<void> fits =
            engine::checkMemory("--views", fmt::format("a list of {} views", options.views),
                                options.views * sizeof(check::View), engine::availableMemory());
        !fits)
        return Failure(fits.error());
    if (Result<void> places = checkOutputPlaces(options); !places)
        return Failure(places.error());
    Result<engine::WorldSource> source = openWorld(console, options.session.dat);
    if (!source)
        return Failure(source.error());
    if (options.walk.empty()) {
        Result<std::vector<world::Place>> tour = tourOf(console, *source);
        if (!tour)
            return Failure(tour.error());
        source->file.tour = std::move(*tour);
    }
    const check::ReportContext context{options.seed, worldOptions(options, *source)};
    Result<check::Progress> progress = progressOf(options, nameOfRun(options, context.worldOptions));
    if (!progress)
        return Failure(progress.error());
    Result<engine::HeadlessSession> headless = engine::openHeadless(
        std::make_shared<const engine::WorldSource>(std::move(*source)), options.session);
    if (!headless)
        return Failure(headless.error());
    const Result<check::RunRequest> request = planCheck(options, headless->session->shareSource(), console);
    if (!request)
        return Failure(request.error());
    if (Result<void> fits =
            engine::checkFrameFits({request->width, request->height}, options.session.samples,
                                   headless->device->capabilities(), engine::availableMemory());
        !fits)
        return Failure(fits.error());
    std::optional<output::CheckRecorder> recorder;
    if (!options.report.empty())
        recorder.emplace(context.worldOptions);
    engine::CheckDrawer drawer(*headless->session, !options.directory.empty() || recorder.has_value(),
                               options.session.samples > 1);
    {
        Progress bar(console, "check", check::viewsAsked(*request));
        const check::RunEvents events = eventsOf(options, console, bar, recorder);
        console.interrupt().defer();
        const Result<void> done = check::runCheck(*request, drawer, events, *progress);
        if (!done && console.interrupt().isRequested())
            return stopEarly(options, *progress, context, check::viewsAsked(*request), console);
        if (!done)
            return Failure(done.error());
    }
    const check::Totals& totals = progress->totals;
    if (totals.sum().views == 0)
        return fail(ErrorCode::NotFound, "check",
                    "no viewpoint was found in this world; choose other --kinds or another --seed");
    if (!options.directory.empty()) {
        const std::uint64_t pictures = std::min(totals.sum().findings(), kMostPictures);
        console.wrote(options.directory, pictures == 0
                                             ? "no picture, as there is no finding"
                                             : fmt::format("pictures of the findings, at most {}", pictures));
    }
    console.data(options.json ? check::reportJson(totals, context) : check::reportText(totals, context));
    if (recorder) {
        if (Result<void> written =
                writeCheckReport(options, *headless->session, std::move(*recorder), totals, console);
            !written)
            return Failure(written.error());
    }
    return totals.sum().findings() > 0 ? Exit::Finding : Exit::Done;
}

} // namespace

void addCheckVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb =
        program.add_subcommand("check", "draw and trace the same views, and report pixels that differ");
    const auto options = std::make_shared<CheckOptions>();
    verb->add_option("--views", options->views, "check this many views, shared among the kinds (1000)")
        ->type_name("N")
        ->check(within(1, static_cast<double>(kMostViews)));
    verb->add_option("--kinds", options->kinds,
                     "check these kinds of view, e.g. random,path; also straddle, telephoto, wide "
                     "(random,outside,path,sweep,still)")
        ->type_name("LIST");
    verb->add_option("--seed", options->seed, "choose the views with this seed (1)")->type_name("N");
    verb->add_option(
            "--size", options->size,
            "set the picture size in pixels, or any: a size of its own for each view, 16x16 to 2000x1200 "
            "(640x360, for sweeps 160x90)")
        ->type_name("WxH|any");
    verb->add_option("--block", options->block,
                     "check only this landblock, four hexadecimal digits, e.g. A9B4 (all)")
        ->type_name("XXYY");
    verb->add_option(
            "--doors", options->doors,
            "set the openness of all doors: rest, closed, half, open or 0..1 (rest: each as in the data)")
        ->type_name("rest|closed|half|open|0..1");
    verb->add_option("--day", options->day,
                     "choose a day group of the data by number or name, e.g. Snow (that of 10-1-2)")
        ->type_name("NUMBER|NAME");
    verb->add_option("--weather", options->weather, "set the weather: clear or rain (clear)")
        ->type_name("clear|rain");
    verb->add_option("--look", options->look,
                     "draw as the original did, or with light per pixel and smooth animations (retail)")
        ->type_name("retail|enhanced");
    CLI::Option* walk =
        verb->add_option("--walk", options->walk,
                         "check every frame of a walk recorded with limen view --record or limen walk (none)")
            ->type_name("FILE");
    for (const char* other :
         {"--views", "--kinds", "--seed", "--block", "--doors", "--day", "--weather", "--look"})
        walk->excludes(other);
    verb->add_flag("--apart", options->apart, "give every cell its own zone, as --zones cells does");
    verb->add_option(
            "-o,--output", options->directory,
            "write a picture of each view with a finding to this directory; create it if missing (none)")
        ->type_name("DIR");
    verb->add_option("--format", options->format, "set the format of these pictures (png)")
        ->type_name("png|jpg|webp")
        ->check(oneOf({"png", "jpg", "webp"}));
    verb->add_option(
            "--report", options->report,
            "write index.html, one page with totals, findings and pictures, to this directory (none)")
        ->type_name("DIR");
    verb->add_option("--resume", options->resume,
                     "save the state of the run in this file; if it exists, continue from it (none)")
        ->type_name("FILE");
    verb->add_flag("--json", options->json, "print the result as one JSON object");
    addSessionOptions(*verb, options->session);
    addDrawing(*verb, options->session, gpu::Drawing::Exact, "exact");
    addGate(*verb, options->session);
    verb->footer(
        "With --msaa 4 pictures are drawn in one colour per id and compared sample by sample.\n"
        "Exit codes: 0: every pixel is correct; 1: some pixels are wrong; 2: the check failed to run.\n"
        "Examples:\n  limen check --views 20 --size 160x90\n"
        "  limen check --views 100 --kinds random,path -o findings");
    verb->callback([&console, &choice, options, verb] {
        options->command = commandLineOf(*verb);
        choice.run = [&console, options] { return runCheckVerb(*options, console); };
    });
}

} // namespace limen::cli
