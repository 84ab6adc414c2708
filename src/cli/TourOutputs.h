#pragma once

#include "output/Encode.h"
#include "output/Film.h"
#include "output/report/TourRecorder.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

// The files that `limen tour` writes: numbered pictures with a contact sheet, a film, a report.
namespace limen::cli {

/// The options as typed; empty: not given.
struct TourOutputOptions {
    std::string directory, format = "png", film, filmRate, report;
};
void addTourOutputOptions(CLI::App& command, TourOutputOptions& options);

/// A file or directory that was written, for Console::wrote.
struct WrittenOutput {
    std::filesystem::path path;
    std::string content;
};

/// The outputs of one tour, checked and ready to be written.
class TourOutputs {
public:
    /// Checks that each output can be written. Errors: no output is given; an unknown ending; a place that
    /// cannot be written; a film without ffmpeg; a frame rate out of bounds.
    [[nodiscard]] static Result<TourOutputs> open(const TourOutputOptions& options);

    /// Begins. `framesPerSecond`: of the frames' own time; --film-rate overrides it for the film.
    void begin(std::size_t frameCount, double framesPerSecond);
    /// Writes a frame that the session has just drawn. Errors: those of the outputs.
    [[nodiscard]] Result<void> add(const engine::Session& session, const engine::FrameRequest& request,
                                   std::size_t frame);
    /// Completes all outputs. `findings`: faults that belong to no frame; empty ones are left out.
    /// Errors: those of the outputs.
    [[nodiscard]] Result<std::vector<WrittenOutput>> finish(const engine::Session& session,
                                                            const std::string& command,
                                                            const std::vector<std::string>& findings);

private:
    explicit TourOutputs(TourOutputOptions options) : options_(std::move(options)) {}
    [[nodiscard]] Result<void> addPicture(const output::Picture& picture, std::size_t frame,
                                          const std::string& label);
    [[nodiscard]] Result<void> addToFilm(const output::Picture& picture);

    TourOutputOptions options_;
    output::PictureFormat format_ = output::PictureFormat::Png;
    std::filesystem::path ffmpeg_;
    std::optional<double> filmRate_;
    double framesPerSecond_ = 30.0;
    std::size_t frames_ = 0;
    std::optional<output::ContactSheet> sheet_;
    std::optional<output::Film> film_;
    std::optional<output::TourRecorder> recorder_;
};

} // namespace limen::cli
