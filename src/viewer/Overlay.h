#pragma once

#include "output/Picture.h"
#include "viewer/Window.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace limen::viewer {

/// The Dear ImGui context of the window, with style, font and GL objects. Pages and panels are drawn between
/// `begin` and `end`.
class Overlay {
public:
    /// The window must outlive it.
    explicit Overlay(const Window& window);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// The devices that controls use: the mouse while it is over one, keys while text is typed.
    [[nodiscard]] Taken takes() const;
    /// Begins a frame. `scale`: of the user, on top of the screen's. `selects`: keyboard and gamepad select
    /// controls.
    void begin(double scale, bool selects);
    /// Draws into the bound framebuffer.
    void end();
    /// Clears the window: no world is open.
    void clear();
    /// Draws a picture over the whole window; `opacity` 0..255.
    void drawOver(const output::Picture& picture, int opacity);
    /// The font in use, for the About page.
    [[nodiscard]] const std::string& fontNote() const { return fontNote_; }
    /// The scale of letters and distances, in screen units.
    [[nodiscard]] double scale() const { return scale_.units; }

private:
    void fitScale(double scale);
    struct OverTexture;
    std::unique_ptr<OverTexture> over_;
    const Window& window_;
    std::optional<std::filesystem::path> font_;
    std::string fontNote_;
    UiScale scale_;
    bool isFitted_ = false;
};

} // namespace limen::viewer
