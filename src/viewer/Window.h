#pragma once

#include "engine/Camera.h"
#include "output/Picture.h"
#include "viewer/HeldInput.h"
#include "viewer/KeyBindings.h"
#include "viewer/WindowGeometry.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct GLFWwindow;

namespace limen::viewer {

/// The input devices that the panel uses at the moment.
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

    /// Processes the events since the last call. A key pressed and released in between counts as held for one
    /// frame. `wait`: waits for an event, for at most this time in seconds.
    void poll(const Taken& taken, const KeyBindings& bindings, double wait = 0.0);
    /// One-shot actions since the last poll.
    [[nodiscard]] const std::vector<Action>& pressed() const { return pressed_; }
    /// The named keys pressed since the last poll, bound or not.
    [[nodiscard]] const std::vector<KeyCode>& pressedKeys() const { return keys_; }
    [[nodiscard]] const HeldInput& held() const { return held_; }
    /// The pixel of the last click (press and release of the left button without a drag) since the last poll.
    [[nodiscard]] std::optional<PixelPlace> clicked() const { return clicked_; }
    /// Paths that were dropped onto the window since the last poll.
    [[nodiscard]] const std::vector<std::filesystem::path>& dropped() const { return dropped_; }
    /// Whether the gamepad's button for Back (B) was pressed since the last poll.
    [[nodiscard]] bool isPadBack() const { return isPadBack_; }
    [[nodiscard]] bool hasGamepad() const { return held_.sticks.has_value(); }
    /// Captures the mouse, or releases it. While it is captured, each movement turns the view.
    void capture(bool isCaptured);
    [[nodiscard]] bool isCaptured() const { return isCaptured_; }
    [[nodiscard]] bool wantsToClose() const;
    /// True after the connection to the X server is lost.
    [[nodiscard]] bool isLost() const { return isLost_; }
    /// False while the window is minimised or hidden.
    [[nodiscard]] bool isShown() const;
    /// Waits for a window event, at most 0.1 s.
    void rest();
    [[nodiscard]] const WindowSizes& sizes() const { return sizes_; } ///< at the last poll
    /// Size in pixels, at least 1x1 (GLFW reports 0x0 for a minimised window).
    [[nodiscard]] engine::PixelSize size() const { return sizes_.pixels; }
    [[nodiscard]] double seconds() const; ///< since GLFW was initialised
    /// Reads the drawn frame. Call it before `show`.
    [[nodiscard]] output::Picture read() const;
    void show();
    /// Toggles full screen on the window's monitor.
    void switchFullScreen();
    [[nodiscard]] bool isFullScreen() const { return framed_.has_value(); }
    /// Frames a second of the window's monitor when it was opened, focused or switched; 60 if it is unknown.
    [[nodiscard]] double displayRate() const { return displayRate_; }
    void setTitle(const std::string& title);
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

    /// GLFW callbacks.
    void receiveKey(int key);
    void receiveFocus(bool isHere);
    void receiveButton(bool isDown);
    void receiveCursor(double x, double y);
    void receiveWheel(double notches) { wheel_ += notches; }
    void receiveDrop(std::span<const char* const> paths);

private:
    explicit Window(GLFWwindow* window);
    void pollKeys(bool keysAreTaken, const KeyBindings& bindings);
    void pollGamepad();
    void pollMouse(bool mouseIsTaken);
    void takeSizes();
    void takeDisplayRate();
    void setPointer();
    GLFWwindow* window_;
    WindowSizes sizes_;
    double displayRate_ = 60.0;
    std::vector<KeyCode> pending_, keys_;
    std::vector<Action> pressed_;
    HeldInput held_;
    double mouseX_ = 0.0, mouseY_ = 0.0;
    bool dragging_ = false, isCaptured_ = false;
    bool isPointerHidden_ = false; ///< as GLFW was set last
    bool mouseIsTaken_ = false;
    /// A press of the left button: its start and the length of the cursor's path since, in GLFW's screen
    /// units.
    struct Press {
        double x = 0.0, y = 0.0;
        double wandered = 0.0;
    };
    std::optional<Press> press_;
    double cursorX_ = 0.0, cursorY_ = 0.0; ///< last received position
    std::optional<PixelPlace> clicked_;
    double wheel_ = 0.0;
    std::vector<std::filesystem::path> pendingDrops_, dropped_;
    bool isPadBack_ = false;
    std::uint32_t padButtons_ = 0; ///< gamepad buttons that were down at the last poll, one bit each
    /// The window's position and size before full screen.
    struct Frame {
        int x = 0, y = 0, width = 0, height = 0;
    };
    std::optional<Frame> framed_;
    bool isLost_ = false;
};

} // namespace limen::viewer
