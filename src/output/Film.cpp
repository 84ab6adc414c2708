#include "output/Film.h"

#include "core/platform/Environment.h"
#include "output/FilmProcess.h"
#include "output/OutputFile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <span>
#include <string>

namespace limen::output {
namespace {

/// Arguments of ffmpeg between input and output.
std::vector<std::string> encodingOf(FilmFormat format) {
    const std::string even = "crop=trunc(iw/2)*2:trunc(ih/2)*2";
    switch (format) {
    case FilmFormat::Mp4:
        return {"-vf",  even, "-c:v",    "libx264", "-pix_fmt", "yuv420p",
                "-crf", "20", "-preset", "medium",  "-f",       "mp4"};
    case FilmFormat::Webm:
        return {"-vf", even,   "-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p", "-crf",
                "32",  "-b:v", "0",    "-row-mt",    "1",        "-f",      "webm"};
    case FilmFormat::Gif:
        return {"-vf",
                "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
                "-loop",
                "0",
                "-f",
                "gif"};
    case FilmFormat::Webp:
        return {"-c:v", "libwebp_anim", "-quality", "70", "-compression_level",
                "4",    "-loop",        "0",        "-f", "webp"};
    }
    return {};
}

} // namespace

Result<FilmFormat> filmFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    constexpr std::array<std::string_view, 4> kEndings{".mp4", ".webm", ".gif", ".webp"};
    for (std::size_t i = 0; i < kEndings.size(); ++i)
        if (ending == kEndings[i])
            return static_cast<FilmFormat>(i);
    return fail(ErrorCode::BadArgument, path.string(),
                fmt::format("{} names no known film format; use .mp4, .webm, .gif or .webp",
                            ending.empty() ? "a name without ending" : "the ending " + ending));
}

Result<std::filesystem::path> findFfmpeg(std::string_view searchPath) {
    for (const std::filesystem::path& directory : platform::directoriesOf(searchPath))
        if (std::filesystem::path program = directory / platform::programFileName("ffmpeg");
            platform::isProgram(program))
            return program;
    return fail(
        ErrorCode::NotFound, "ffmpeg",
        fmt::format("is not installed, and films need it; {}, or write pictures with -o DIR", kFfmpegAdvice));
}

struct Film::Work {
    std::filesystem::path path;
    std::uint32_t width = 0, height = 0;
    FilmProcess process;
    std::size_t count = 0;

    [[nodiscard]] Failure failure() const {
        const std::string reason = process.lastMessage();
        return fail(ErrorCode::Unreadable, path.string(),
                    fmt::format("ffmpeg could not write the film: {}",
                                reason.empty() ? "it gave no reason" : reason));
    }
};

Film::Film(std::unique_ptr<Work> work) : work_(std::move(work)) {}
Film::~Film() = default;
Film::Film(Film&&) noexcept = default;
Film& Film::operator=(Film&&) noexcept = default;

Result<Film> Film::start(const std::filesystem::path& ffmpeg, const std::filesystem::path& path,
                         std::uint32_t width, std::uint32_t height, double framesPerSecond) {
    const Result<FilmFormat> format = filmFormatOf(path);
    if (!format)
        return Failure(format.error());
    if (Result<void> writable = checkWritable(path); !writable)
        return Failure(writable.error());
    if (width < 2 || height < 2)
        return fail(ErrorCode::BadArgument, path.string(),
                    "a film needs at least 2x2 pixels; choose a larger --size");
    std::vector<std::string> arguments{"ffmpeg",       "-nostdin",
                                       "-hide_banner", "-loglevel",
                                       "error",        "-y",
                                       "-f",           "rawvideo",
                                       "-pix_fmt",     "rgb24",
                                       "-s",           fmt::format("{}x{}", width, height),
                                       "-framerate",   fmt::format("{}", framesPerSecond),
                                       "-i",           "pipe:0"};
    for (std::string& argument : encodingOf(*format))
        arguments.push_back(std::move(argument));
    Result<FilmProcess> process = FilmProcess::start(ffmpeg, path, std::move(arguments));
    if (!process)
        return Failure(process.error());
    return Film(std::make_unique<Work>(Work{path, width, height, std::move(*process)}));
}

Result<void> Film::add(const Picture& frame) {
    Work& work = *work_;
    if (frame.width != work.width || frame.height != work.height)
        return fail(ErrorCode::BadArgument, work.path.string(),
                    fmt::format("frame {} has another size than the first; give one --size for all frames",
                                work.count));
    if (!work.process.write(std::as_bytes(std::span(frame.rgb)))) {
        (void)work.process.wait();
        return work.failure();
    }
    ++work.count;
    return {};
}

Result<void> Film::finish() {
    Work& work = *work_;
    if (work.count == 0)
        return fail(ErrorCode::BadArgument, work.path.string(), "a film without frames is not written");
    if (!work.process.wait() || work.process.isEmpty())
        return work.failure();
    return work.process.keep();
}

} // namespace limen::output
