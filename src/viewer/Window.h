#pragma once

#include "cli/Parse.h"
#include "output/Picture.h"
#include "viewer/HeldInput.h"
#include "viewer/KeyBindings.h"
#include "viewer/WindowGeometry.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

struct GLFWwindow;

namespace limen::viewer {

/// What the panel uses itself just now.
struct Taken {
    bool mouse = false, keys = false;
};

/// A window with an OpenGL 4.5 context that is current while it lives.
class Window {
public:
    /// Errors: no display; no window or context of that kind.
    [[nodiscard]] static Result<std::unique_ptr<Window>> open(const char* title, engine::PixelSize size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Takes in what happened since the last call. A key that was pressed and let go meanwhile counts as held once.
    void poll(const Taken& taken, const KeyBindings& bindings);
    /// What is to be done of what is done once, by keys and buttons pressed since the last poll.
    [[nodiscard]] const std::vector<Action>& pressed() const { return pressed_; }
    /// The keys with a name that were pressed since the last poll, whatever they do.
    [[nodiscard]] const std::vector<KeyCode>& pressedKeys() const { return keys_; }
    [[nodiscard]] const HeldInput& held() const { return held_; }
    /// Where the left button was pressed and let go at one place, since the last poll; the last such place.
    [[nodiscard]] std::optional<PixelPlace> clicked() const { return clicked_; }
    [[nodiscard]] bool wantsToClose() const;
    /// True when there is no display any more: the X server has gone away.
    [[nodiscard]] bool isLost() const { return isLost_; }
    /// False: it is minimised or not on the screen, and nobody sees what is drawn.
    [[nodiscard]] bool isShown() const;
    /// Waits until something happens to the window, a fraction of a second at most.
    void rest();
    [[nodiscard]] const WindowSizes& sizes() const { return sizes_; } ///< at the last poll
    /// Size in pixels; 1x1 at least (a window made small as an icon has none).
    [[nodiscard]] engine::PixelSize size() const { return sizes_.pixels; }
    [[nodiscard]] double seconds() const; ///< since the library started
    /// Reads what was drawn into the window, before `show`.
    [[nodiscard]] output::Picture read() const;
    void show();
    /// Fills the screen that the window is on, or gives it back.
    void switchFullScreen();
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

    /// Called by the library.
    void receiveKey(int key);
    void receiveFocus(bool isHere);
    void receiveButton(bool isDown);
    void receiveCursor(double x, double y);
    void receiveWheel(double notches) { wheel_ += notches; }

private:
    explicit Window(GLFWwindow* window);
    void pollKeys(bool keysAreTaken, const KeyBindings& bindings);
    void pollGamepad();
    void pollMouse(bool mouseIsTaken);
    void takeSizes();
    GLFWwindow* window_;
    WindowSizes sizes_;
    std::vector<KeyCode> pending_, keys_;
    std::vector<Action> pressed_;
    HeldInput held_;
    double mouseX_ = 0.0, mouseY_ = 0.0;
    bool dragging_ = false;
    bool mouseIsTaken_ = false;
    /// The left button, held down: where that began, and how far the cursor has come since, in the library's units.
    struct Press {
        double x = 0.0, y = 0.0;
        double wandered = 0.0;
    };
    std::optional<Press> press_;
    double cursorX_ = 0.0, cursorY_ = 0.0; ///< as last received
    std::optional<PixelPlace> clicked_;
    double wheel_ = 0.0;
    std::uint32_t padButtons_ = 0; ///< of the gamepad, that were down at the last poll; a bit each
    /// Where the window was before it filled the screen.
    struct Frame {
        int x = 0, y = 0, width = 0, height = 0;
    };
    std::optional<Frame> framed_;
    bool isLost_ = false;
};

} // namespace limen::viewer
