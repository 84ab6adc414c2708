#pragma once

#include "output/Picture.h"

#include <filesystem>
#include <memory>

namespace limen::output {

enum class FilmFormat : std::uint8_t { Mp4, Webm, Gif, Webp };

/// The format that a file name's ending selects, in any case: .mp4, .webm, .gif, .webp. Errors: BadArgument
/// for another ending; the message lists the known ones.
[[nodiscard]] Result<FilmFormat> filmFormatOf(const std::filesystem::path& path);

/// Looks for the program `ffmpeg` in the directories of `searchPath` (form of PATH). Errors: NotFound, with
/// the name of the package.
[[nodiscard]] Result<std::filesystem::path> findFfmpeg(std::string_view searchPath);

/// A film that is written frame by frame by an ffmpeg process. ffmpeg writes into a file without a name (on Windows
/// a hidden one); only `finish` gives it the name of the film. Therefore no failure and no signal leaves a half film.
class Film {
public:
    /// Starts ffmpeg. `framesPerSecond` > 0. Sides of mp4 and webm are cut to even numbers of pixels. Errors:
    /// as filmFormatOf; the place cannot be written; the process cannot be started; a side below 2 pixels.
    [[nodiscard]] static Result<Film> start(const std::filesystem::path& ffmpeg,
                                            const std::filesystem::path& path, std::uint32_t width,
                                            std::uint32_t height, double framesPerSecond);
    ~Film(); ///< ends ffmpeg and drops the film unless it is finished
    Film(Film&&) noexcept;
    Film& operator=(Film&&) noexcept;

    /// Adds a frame. Errors: another size than at the start; ffmpeg ended, with the reason that it printed.
    [[nodiscard]] Result<void> add(const Picture& frame);
    /// Waits for ffmpeg and puts the film into its place. Errors: no frame; ffmpeg's; a full disk.
    [[nodiscard]] Result<void> finish();

private:
    struct Work;
    explicit Film(std::unique_ptr<Work> work);
    std::unique_ptr<Work> work_;
};

} // namespace limen::output
