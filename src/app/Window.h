#pragma once

#include "app/Gamepad.h"
#include "app/Parse.h"
#include "app/Picture.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

struct GLFWwindow;

namespace limen::app {

/// The keys that do something once, when pressed.
enum class Key {
    Help,
    Ids,
    Regions,
    Panel,
    Check,
    Probe,
    Freeze,
    FullScreen,
    Walk,
    Chase,
    Doors,
    Use,
    Rain,
    Later,
    Leave,
    Place1,
    Place2,
    Place3,
    Place4,
    Place5,
    Place6,
    Place7,
    Place8,
    Place9
};

/// What hands hold down just now.
struct HeldInput {
    bool forward = false, back = false, left = false, right = false, up = false, down = false, fast = false;
    bool jump = false;               ///< one of the keys for up, too
    double lookX = 0.0, lookY = 0.0; ///< pixels dragged since the last poll, y down
    double wheel = 0.0;              ///< notches turned since the last poll, away from the hand
    std::optional<Sticks> sticks;    ///< of the first gamepad, if there is one
};

/// A pixel, from the window's upper left corner.
struct PixelPlace {
    std::uint32_t x = 0, y = 0;
};

/// A window with an OpenGL 4.5 context that is current while it lives.
class Window {
public:
    /// Errors: no display; no window or context of that kind.
    [[nodiscard]] static Result<std::unique_ptr<Window>> open(const char* title, PixelSize size);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Takes in what happened since the last call. `mouseIsTaken`: the panel uses the mouse.
    void poll(bool mouseIsTaken);
    [[nodiscard]] const std::vector<Key>& pressed() const { return pressed_; } ///< since the last poll
    [[nodiscard]] const HeldInput& held() const { return held_; }
    /// Where the left button was pressed and let go at one place, since the last poll; the last such place.
    [[nodiscard]] std::optional<PixelPlace> clicked() const { return clicked_; }
    [[nodiscard]] bool wantsToClose() const;
    /// Size in pixels; 1x1 at least (a window made small as an icon has none).
    [[nodiscard]] PixelSize size() const;
    [[nodiscard]] double seconds() const; ///< since the library started
    /// Reads what was drawn into the window, before `show`.
    [[nodiscard]] Picture read() const;
    void show();
    /// Fills the screen that the window is on, or gives it back.
    void switchFullScreen();
    [[nodiscard]] GLFWwindow* handle() const { return window_; }

    /// Called by the library.
    void receiveKey(int key);
    void receiveButton(bool isDown);
    void receiveCursor(double x, double y);
    void receiveWheel(double notches) { wheel_ += notches; }

private:
    explicit Window(GLFWwindow* window);
    void pollGamepad();
    [[nodiscard]] std::optional<PixelPlace> pixelAt(double x, double y) const;
    GLFWwindow* window_;
    std::vector<Key> pending_, pressed_;
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
};

} // namespace limen::app
