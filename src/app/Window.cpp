#include "app/Window.h"

#include <epoxy/gl.h>

// After epoxy, which must come before any other GL header.
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace limen::app {
namespace {

tl::unexpected<Error> refused(const char* what, const char* advice) {
    const char* reason = nullptr;
    (void)glfwGetError(&reason);
    return fail(ErrorCode::Driver, "view",
                fmt::format("{} ({}); {}", what, reason != nullptr ? reason : "no reason given", advice));
}

std::optional<Key> keyOf(int key) {
    switch (key) {
    case GLFW_KEY_F1:
        return Key::Help;
    case GLFW_KEY_F2:
        return Key::Ids;
    case GLFW_KEY_F3:
        return Key::Regions;
    case GLFW_KEY_F4:
        return Key::Panel;
    case GLFW_KEY_F5:
        return Key::Check;
    case GLFW_KEY_F6:
        return Key::Probe;
    case GLFW_KEY_F7:
        return Key::Freeze;
    case GLFW_KEY_F11:
        return Key::FullScreen;
    case GLFW_KEY_G:
        return Key::Walk;
    case GLFW_KEY_C:
        return Key::Chase;
    case GLFW_KEY_O:
        return Key::Doors;
    case GLFW_KEY_E:
        return Key::Use;
    case GLFW_KEY_R:
        return Key::Rain;
    case GLFW_KEY_T:
        return Key::Later;
    case GLFW_KEY_ESCAPE:
        return Key::Leave;
    default:
        break;
    }
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9)
        return static_cast<Key>(static_cast<int>(Key::Place1) + key - GLFW_KEY_1);
    return {};
}

/// Buttons of a gamepad that do what keys do.
constexpr std::array<std::pair<int, Key>, 5> kPadKeys{{{GLFW_GAMEPAD_BUTTON_X, Key::Use},
                                                       {GLFW_GAMEPAD_BUTTON_Y, Key::Chase},
                                                       {GLFW_GAMEPAD_BUTTON_B, Key::Walk},
                                                       {GLFW_GAMEPAD_BUTTON_START, Key::Help},
                                                       {GLFW_GAMEPAD_BUTTON_BACK, Key::Panel}}};

/// The screen that shows a place of the desktop; else the first; null: there is none.
GLFWmonitor* monitorOf(int x, int y) {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode != nullptr && x >= left && x < left + mode->width && y >= top && y < top + mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

} // namespace

Result<std::unique_ptr<Window>> Window::open(const char* title, PixelSize size) {
    if (glfwInit() != GLFW_TRUE)
        return refused("there is no display to open a window on", "limen shot and limen tour need none");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET); // where the driver can tell
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title,
                                          nullptr, nullptr);
    if (window == nullptr) {
        const auto error =
            refused("no window with OpenGL 4.5 could be opened", "limen shot tells more of the driver");
        glfwTerminate();
        return error;
    }
    return std::unique_ptr<Window>(new Window(window));
}

Window::Window(GLFWwindow* window) : window_(window) {
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
        if (action == GLFW_PRESS)
            static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveKey(key);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int) {
        if (button == GLFW_MOUSE_BUTTON_LEFT)
            static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveButton(action == GLFW_PRESS);
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveCursor(x, y);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double notches) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveWheel(notches);
    });
    glfwGetCursorPos(window_, &mouseX_, &mouseY_);
    cursorX_ = mouseX_;
    cursorY_ = mouseY_;
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::receiveKey(int key) {
    if (const std::optional<Key> known = keyOf(key))
        pending_.push_back(*known);
}

void Window::receiveButton(bool isDown) {
    constexpr double kStill = 3.0; // a hand is never quite still
    if (isDown) {
        glfwGetCursorPos(window_, &cursorX_, &cursorY_); // the end of a drag moves it untold
        press_ = mouseIsTaken_ ? std::nullopt : std::make_optional<Press>({cursorX_, cursorY_, 0.0});
        return;
    }
    if (press_ && press_->wandered <= kStill)
        clicked_ = pixelAt(press_->x, press_->y);
    press_.reset();
}

void Window::receiveCursor(double x, double y) {
    if (press_)
        press_->wandered += std::hypot(x - cursorX_, y - cursorY_);
    cursorX_ = x;
    cursorY_ = y;
}

std::optional<PixelPlace> Window::pixelAt(double x, double y) const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    if (x < 0.0 || y < 0.0 || x >= width || y >= height)
        return {};
    const PixelSize pixels = size();
    return PixelPlace{static_cast<std::uint32_t>(x * pixels.width / width),
                      static_cast<std::uint32_t>(y * pixels.height / height)};
}

void Window::poll(bool mouseIsTaken) {
    pending_.clear();
    clicked_.reset();
    wheel_ = 0.0;
    mouseIsTaken_ = mouseIsTaken;
    glfwPollEvents();
    pressed_ = pending_;
    const auto down = [this](auto... keys) { return ((glfwGetKey(window_, keys) == GLFW_PRESS) || ...); };
    held_ = {};
    held_.forward = down(GLFW_KEY_W, GLFW_KEY_UP);
    held_.back = down(GLFW_KEY_S, GLFW_KEY_DOWN);
    held_.left = down(GLFW_KEY_A, GLFW_KEY_LEFT);
    held_.right = down(GLFW_KEY_D, GLFW_KEY_RIGHT);
    held_.up = down(GLFW_KEY_E, GLFW_KEY_SPACE);
    held_.jump = down(GLFW_KEY_SPACE);
    held_.down = down(GLFW_KEY_Q, GLFW_KEY_LEFT_CONTROL);
    held_.fast = down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    held_.wheel = mouseIsTaken ? 0.0 : wheel_;
    pollGamepad();
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    const bool button = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                        glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    const bool drags = button && (dragging_ || !mouseIsTaken);
    if (drags && dragging_) {
        held_.lookX = x - mouseX_;
        held_.lookY = y - mouseY_;
    }
    if (drags != dragging_)
        glfwSetInputMode(window_, GLFW_CURSOR, drags ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (drags != dragging_) // the mode change moves the cursor
        glfwGetCursorPos(window_, &x, &y);
    dragging_ = drags;
    mouseX_ = x;
    mouseY_ = y;
}

void Window::pollGamepad() {
    GLFWgamepadstate pad{};
    int joystick = GLFW_JOYSTICK_1;
    while (joystick <= GLFW_JOYSTICK_LAST && glfwGetGamepadState(joystick, &pad) != GLFW_TRUE)
        ++joystick;
    std::uint32_t down = 0;
    if (joystick <= GLFW_JOYSTICK_LAST) {
        held_.sticks = Sticks{pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X], pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y],
                              pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]};
        for (int button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button)
            down |= pad.buttons[button] == GLFW_PRESS ? 1u << button : 0u;
    }
    const auto isDown = [down](int button) { return (down >> button & 1u) != 0; };
    held_.jump |= isDown(GLFW_GAMEPAD_BUTTON_A);
    held_.up |= isDown(GLFW_GAMEPAD_BUTTON_A);
    held_.down |= isDown(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER);
    for (const auto& [button, key] : kPadKeys) {
        if (isDown(button) && (padButtons_ >> button & 1u) == 0)
            pressed_.push_back(key);
    }
    padButtons_ = down;
}

bool Window::wantsToClose() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

PixelSize Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {static_cast<std::uint32_t>(std::max(1, width)), static_cast<std::uint32_t>(std::max(1, height))};
}

double Window::seconds() const {
    return glfwGetTime();
}

Picture Window::read() const {
    const PixelSize pixels = size();
    std::vector<std::uint8_t> rgba(std::size_t{pixels.width} * pixels.height * 4);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, static_cast<GLsizei>(pixels.width), static_cast<GLsizei>(pixels.height), GL_RGBA,
                 GL_UNSIGNED_BYTE, rgba.data());
    const std::size_t row = std::size_t{pixels.width} * 4;
    for (std::size_t top = 0, bottom = pixels.height - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                         rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                         rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
    return pictureFromRgba(pixels.width, pixels.height, rgba);
}

void Window::switchFullScreen() {
    if (framed_) {
        glfwSetWindowMonitor(window_, nullptr, framed_->x, framed_->y, framed_->width, framed_->height,
                             GLFW_DONT_CARE);
        framed_.reset();
        return;
    }
    Frame frame;
    glfwGetWindowPos(window_, &frame.x, &frame.y);
    glfwGetWindowSize(window_, &frame.width, &frame.height);
    GLFWmonitor* monitor = monitorOf(frame.x + frame.width / 2, frame.y + frame.height / 2);
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr)
        return;
    framed_ = frame;
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::show() {
    glfwSwapBuffers(window_);
}

} // namespace limen::app
