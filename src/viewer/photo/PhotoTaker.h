#pragma once

#include "engine/picture/LargePicture.h"

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>

namespace limen::viewer {

/// Takes one picture at a time: draws a tile each frame, then writes the file on a thread.
class PhotoTaker {
public:
    /// Waits for a file that is being written.
    ~PhotoTaker();

    [[nodiscard]] bool isBusy() const { return picture_ != nullptr || file_.valid(); }
    /// Begins a picture of `request`. `command`: draws it again; saved beside it. Requires that no picture is
    /// being taken. Errors: LargePicture::begin's.
    [[nodiscard]] Result<void> begin(engine::Session& session, const engine::FrameRequest& request,
                                     std::uint32_t supersample, std::filesystem::path directory,
                                     std::string command);
    /// Drops a picture that is being drawn. A file that is being written is finished.
    void cancel() { picture_.reset(); }
    /// Draws a tile, or looks for the written file. Yields the saved file once. Errors end the picture: the
    /// renderer's; a file that cannot be written.
    [[nodiscard]] Result<std::optional<std::filesystem::path>> step(engine::Session& session);
    /// The share that is drawn, 0..1.
    [[nodiscard]] double progress() const;

private:
    std::unique_ptr<engine::LargePicture> picture_; ///< being drawn
    std::future<Result<std::filesystem::path>> file_;
    std::filesystem::path directory_;
    std::string command_;
};

} // namespace limen::viewer
