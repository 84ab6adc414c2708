#include "cli/TourOutputs.h"

#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/ReportFacts.h"
#include "core/platform/Environment.h"
#include "output/OutputFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace limen::cli {
namespace {

constexpr std::size_t kTilesOfSheet = 24;

std::filesystem::path contactSheetOf(const TourOutputOptions& options, output::PictureFormat format) {
    return std::filesystem::path(options.directory) / fmt::format("contact.{}", output::endingOf(format));
}

Result<void> checkPictureDirectory(const TourOutputOptions& options, output::PictureFormat format) {
    if (options.directory.empty())
        return {};
    if (Result<void> made = output::makeDirectory(options.directory); !made)
        return made;
    return output::checkWritable(contactSheetOf(options, format));
}

} // namespace

void addTourOutputOptions(CLI::App& command, TourOutputOptions& options) {
    const auto add = [&command](const char* name, std::string& value, const char* type, const char* help) {
        return command.add_option(name, value, help)->type_name(type)->group("Output");
    };
    add("-o,--output", options.directory, "DIR",
        "write frame-NNNNN.png and contact.png to this directory; create it if missing (none)");
    add("--format", options.format, "png|jpg|webp", "set the format of these pictures (png)")
        ->check(oneOf({"png", "jpg", "webp"}));
    add("--film", options.film, "FILE",
        "write a film through ffmpeg; the ending selects the format: .mp4, .webm, .gif or .webp (none)");
    add("--film-rate", options.filmRate, "F",
        "show this many frames a second in the film (--fps, or as a walk was recorded, or 30)");
    add("--report", options.report, "DIR",
        "write index.html, one page with pictures, timings and visible spaces, to this directory (none)");
}

Result<TourOutputs> TourOutputs::open(const TourOutputOptions& options) {
    TourOutputs outputs(options);
    if (options.directory.empty() && options.film.empty() && options.report.empty())
        return fail(ErrorCode::BadArgument, "tour",
                    "no output is given; use -o DIR for pictures, --film FILE or --report DIR");
    const Result<output::PictureFormat> format = output::pictureFormatOf("frame." + options.format);
    if (!format)
        return Failure(format.error());
    outputs.format_ = *format;
    if (!options.filmRate.empty()) {
        const Result<double> rate = parseNumberBetween("--film-rate", options.filmRate, 0.1, 240.0);
        if (!rate)
            return Failure(rate.error());
        outputs.filmRate_ = *rate;
    }
    if (!options.film.empty()) {
        if (const auto film = output::filmFormatOf(options.film); !film)
            return Failure(film.error());
        Result<std::filesystem::path> ffmpeg = output::findFfmpeg(platform::environmentVariable("PATH"));
        if (!ffmpeg)
            return Failure(ffmpeg.error());
        outputs.ffmpeg_ = std::move(*ffmpeg);
        if (Result<void> writable = output::checkWritable(options.film); !writable)
            return Failure(writable.error());
    }
    if (Result<void> place = checkPictureDirectory(options, *format); !place)
        return Failure(place.error());
    if (Result<void> place = checkReportPlace(options.report); !place)
        return Failure(place.error());
    return outputs;
}

void TourOutputs::begin(std::size_t frameCount, double framesPerSecond) {
    framesPerSecond_ = framesPerSecond;
    if (!options_.directory.empty())
        sheet_.emplace(frameCount, kTilesOfSheet, 6, 320);
    if (!options_.report.empty())
        recorder_.emplace(frameCount);
}

Result<void> TourOutputs::addPicture(const output::Picture& picture, std::size_t frame,
                                     const std::string& label) {
    const std::filesystem::path path = std::filesystem::path(options_.directory) /
                                       fmt::format("frame-{:05}.{}", frame, output::endingOf(format_));
    if (sheet_->wants(frame))
        sheet_->add(picture, label);
    return output::writePicture(path, picture);
}

Result<void> TourOutputs::addToFilm(const output::Picture& picture) {
    if (!film_) { // the size of a walk's frames is known with the first frame
        Result<output::Film> film = output::Film::start(ffmpeg_, options_.film, picture.width, picture.height,
                                                        filmRate_.value_or(framesPerSecond_));
        if (!film)
            return Failure(film.error());
        film_.emplace(std::move(*film));
    }
    return film_->add(picture);
}

Result<void> TourOutputs::add(const engine::Session& session, const engine::FrameRequest& request,
                              std::size_t frame) {
    ++frames_;
    const output::Picture picture =
        output::pictureFromRgba(request.size.width, request.size.height, session.target().readColour());
    if (sheet_) {
        const std::string label =
            fmt::format("{} {}", frame, engine::spaceName(session.part().world, request.root));
        if (Result<void> written = addPicture(picture, frame, label); !written)
            return written;
    }
    if (!options_.film.empty()) {
        if (Result<void> written = addToFilm(picture); !written)
            return written;
    }
    return recorder_ ? recorder_->add(session, request, frame, picture) : Result<void>{};
}

Result<std::vector<WrittenOutput>> TourOutputs::finish(const engine::Session& session,
                                                       const std::string& command,
                                                       const std::vector<std::string>& findings) {
    std::vector<WrittenOutput> outputs;
    if (sheet_) {
        const std::filesystem::path sheet = contactSheetOf(options_, format_);
        if (Result<void> written = output::writePicture(sheet, sheet_->compose()); !written)
            return Failure(written.error());
        outputs.push_back(
            {options_.directory, fmt::format("{} frames and {}", frames_, sheet.filename().string())});
    }
    if (film_) {
        if (Result<void> finished = film_->finish(); !finished)
            return Failure(finished.error());
        const double rate = filmRate_.value_or(framesPerSecond_);
        outputs.push_back({options_.film, fmt::format("a film of {} frames ({:.1f} s at {:g} a second)",
                                                      frames_, static_cast<double>(frames_) / rate, rate)});
    }
    if (recorder_) {
        for (const std::string& finding : findings)
            if (!finding.empty())
                recorder_->addFinding(finding);
        output::TourReport report = std::move(*recorder_).finish(reportHead(session, command));
        report.framesPerSecond = framesPerSecond_;
        const Result<std::string> page = writeReport(options_.report, output::tourPage(report));
        if (!page)
            return Failure(page.error());
        outputs.push_back({*page, "the report"});
    }
    return outputs;
}

} // namespace limen::cli
