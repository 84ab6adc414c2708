#pragma once

#include "viewer/photo/PhotoPage.h"
#include "viewer/photo/PhotoTaker.h"
#include "viewer/scale/PictureScale.h"

#include <functional>

namespace limen::viewer {

/// Photo mode over one world: draws the preview, shows the controls and takes pictures.
class PhotoView {
public:
    /// `frame`: on the screen. The session must outlive it, and show the same part meanwhile.
    PhotoView(engine::Session& session, const engine::FrameRequest& frame)
        : session_(session), mode_(frame) {}

    /// The command line that draws a frame again.
    using CommandOf = std::function<std::string(const engine::FrameRequest&)>;

    /// Moves the camera, draws the next tile of a picture, and draws the preview into the session's target, with
    /// `percent` per cent of the window's pixels each way. Yields a line for a person when a picture is saved or fails.
    /// Errors: the renderer's, for the preview.
    [[nodiscard]] Result<std::string> frame(const play::PlayInput& input, std::uint32_t percent);
    /// As drawTimed, of the last preview.
    [[nodiscard]] double sceneMs() const { return sceneMs_; }
    /// Draws the controls. True: the user leaves.
    [[nodiscard]] bool drawOverlay(Ui& ui, const std::string& takeKeys,
                                   const std::filesystem::path& directory, const CommandOf& commandOf);
    /// Takes a picture after the next `drawOverlay`. No effect while one is being taken.
    void take() { wantsPicture_ = true; }

    [[nodiscard]] const PhotoMode& mode() const { return mode_; }
    [[nodiscard]] engine::PixelSize window() const { return window_; }
    [[nodiscard]] bool isBusy() const { return taker_.isBusy(); }
    [[nodiscard]] const std::string& saved() const { return saved_; }
    [[nodiscard]] const std::string& fault() const { return fault_; }

private:
    [[nodiscard]] PhotoFacts facts(const std::string& takeKeys) const;
    void begin(const std::filesystem::path& directory, const CommandOf& commandOf);

    engine::Session& session_;
    PhotoMode mode_;
    PhotoTaker taker_;
    engine::PixelSize window_;
    std::string saved_, fault_; ///< full path of the last picture; the reason why there is none
    bool wantsPicture_ = false;
    engine::FrameRequest drawn_; ///< the preview in the size in which it is drawn
    double sceneMs_ = 0.0;
};

} // namespace limen::viewer
