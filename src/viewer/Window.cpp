#include "viewer/Window.h"

#include "viewer/DisplayLoss.h"

#include <epoxy/gl.h>

// After epoxy, which must come before any other GL header.
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace limen::viewer {
namespace {

Failure refused(const char* what, const char* advice) {
    const char* reason = nullptr;
    (void)glfwGetError(&reason);
    return fail(ErrorCode::Driver, "view",
                fmt::format("{} ({}); {}", what, reason != nullptr ? reason : "no reason given", advice));
}

/// KeyCode uses GLFW's numbers with its own names.
constexpr bool isCode(std::string_view name, int glfw) {
    return keyNamed(name) == std::optional(static_cast<KeyCode>(glfw));
}
static_assert(isCode("Space", GLFW_KEY_SPACE) && isCode("'", GLFW_KEY_APOSTROPHE) &&
              isCode(",", GLFW_KEY_COMMA) && isCode("-", GLFW_KEY_MINUS) && isCode(".", GLFW_KEY_PERIOD) &&
              isCode("/", GLFW_KEY_SLASH) && isCode("0", GLFW_KEY_0) && isCode("9", GLFW_KEY_9) &&
              isCode(";", GLFW_KEY_SEMICOLON) && isCode("=", GLFW_KEY_EQUAL) && isCode("A", GLFW_KEY_A) &&
              isCode("Z", GLFW_KEY_Z) && isCode("[", GLFW_KEY_LEFT_BRACKET) &&
              isCode("\\", GLFW_KEY_BACKSLASH) && isCode("]", GLFW_KEY_RIGHT_BRACKET) &&
              isCode("`", GLFW_KEY_GRAVE_ACCENT));
static_assert(isCode("Escape", GLFW_KEY_ESCAPE) && isCode("Enter", GLFW_KEY_ENTER) &&
              isCode("Tab", GLFW_KEY_TAB) && isCode("Backspace", GLFW_KEY_BACKSPACE) &&
              isCode("Insert", GLFW_KEY_INSERT) && isCode("Delete", GLFW_KEY_DELETE) &&
              isCode("Right", GLFW_KEY_RIGHT) && isCode("Left", GLFW_KEY_LEFT) &&
              isCode("Down", GLFW_KEY_DOWN) && isCode("Up", GLFW_KEY_UP) &&
              isCode("PageUp", GLFW_KEY_PAGE_UP) && isCode("PageDown", GLFW_KEY_PAGE_DOWN) &&
              isCode("Home", GLFW_KEY_HOME) && isCode("End", GLFW_KEY_END) &&
              isCode("CapsLock", GLFW_KEY_CAPS_LOCK) && isCode("ScrollLock", GLFW_KEY_SCROLL_LOCK) &&
              isCode("NumLock", GLFW_KEY_NUM_LOCK) && isCode("PrintScreen", GLFW_KEY_PRINT_SCREEN) &&
              isCode("Pause", GLFW_KEY_PAUSE) && isCode("F1", GLFW_KEY_F1) && isCode("F12", GLFW_KEY_F12));
static_assert(isCode("Keypad0", GLFW_KEY_KP_0) && isCode("Keypad9", GLFW_KEY_KP_9) &&
              isCode("KeypadDecimal", GLFW_KEY_KP_DECIMAL) && isCode("KeypadDivide", GLFW_KEY_KP_DIVIDE) &&
              isCode("KeypadMultiply", GLFW_KEY_KP_MULTIPLY) && isCode("KeypadMinus", GLFW_KEY_KP_SUBTRACT) &&
              isCode("KeypadPlus", GLFW_KEY_KP_ADD) && isCode("KeypadEnter", GLFW_KEY_KP_ENTER) &&
              isCode("KeypadEqual", GLFW_KEY_KP_EQUAL) && isCode("LeftShift", GLFW_KEY_LEFT_SHIFT) &&
              isCode("LeftControl", GLFW_KEY_LEFT_CONTROL) && isCode("LeftAlt", GLFW_KEY_LEFT_ALT) &&
              isCode("LeftSuper", GLFW_KEY_LEFT_SUPER) && isCode("RightShift", GLFW_KEY_RIGHT_SHIFT) &&
              isCode("RightControl", GLFW_KEY_RIGHT_CONTROL) && isCode("RightAlt", GLFW_KEY_RIGHT_ALT) &&
              isCode("RightSuper", GLFW_KEY_RIGHT_SUPER) && isCode("Menu", GLFW_KEY_MENU));

/// Gamepad buttons and their actions.
constexpr std::array<std::pair<int, Action>, 5> kPadActions{{{GLFW_GAMEPAD_BUTTON_X, Action::Use},
                                                             {GLFW_GAMEPAD_BUTTON_Y, Action::Chase},
                                                             {GLFW_GAMEPAD_BUTTON_B, Action::Walk},
                                                             {GLFW_GAMEPAD_BUTTON_START, Action::Menu},
                                                             {GLFW_GAMEPAD_BUTTON_BACK, Action::Panel}}};

/// The OpenGL version that the driver offers, e.g. "3.3 (llvmpipe)"; empty if no window opens.
std::string offeredInstead() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (window == nullptr)
        return {};
    glfwMakeContextCurrent(window);
    const auto text = [](GLenum name) {
        const GLubyte* value = glGetString(name);
        return value != nullptr ? std::string(reinterpret_cast<const char*>(value)) : std::string("?");
    };
    std::string offer = fmt::format("{} ({})", text(GL_VERSION), text(GL_RENDERER));
    glfwDestroyWindow(window);
    return offer;
}

/// The monitor at a desktop position, else the primary one; null without monitors.
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

Result<std::unique_ptr<Window>> Window::open(const char* title, engine::PixelSize size) {
    if (glfwInit() != GLFW_TRUE)
        return refused("no display to open a window on", "set DISPLAY, or use limen shot or limen tour");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET); // if the driver supports it
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    GLFWwindow* window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title,
                                          nullptr, nullptr);
    if (window == nullptr) {
        const std::string offer = offeredInstead();
        const auto error = offer.empty()
                               ? refused("no OpenGL window could be opened",
                                         "use limen shot, which needs no window and reports driver faults")
                               : fail(ErrorCode::Driver, "view",
                                      "OpenGL 4.5 core profile is required and the driver offers " + offer +
                                          "; update the driver");
        glfwTerminate();
        return error;
    }
    return std::unique_ptr<Window>(new Window(window));
}

Window::Window(GLFWwindow* window) : window_(window) {
    noteDisplayLoss(isLost_);
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
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int isHere) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveFocus(isHere == GLFW_TRUE);
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double notches) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))->receiveWheel(notches);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
        static_cast<Window*>(glfwGetWindowUserPointer(w))
            ->receiveDrop(std::span<const char* const>(paths, static_cast<std::size_t>(std::max(count, 0))));
    });
    glfwGetCursorPos(window_, &mouseX_, &mouseY_);
    cursorX_ = mouseX_;
    cursorY_ = mouseY_;
    takeSizes();
    takeDisplayRate();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::receiveKey(int key) {
    if (!nameOf(static_cast<KeyCode>(key)).empty())
        pending_.push_back(static_cast<KeyCode>(key));
}

/// Afterwards GLFW reports the release of all keys and buttons itself.
void Window::receiveFocus(bool isHere) {
    if (isHere)
        takeDisplayRate();
    else
        press_.reset(); // such a release is not a click
}

void Window::receiveButton(bool isDown) {
    constexpr double kStill = 3.0; // units; a smaller movement still counts as a click
    if (isDown) {
        glfwGetCursorPos(window_, &cursorX_, &cursorY_); // the end of a drag moves it without an event
        press_ = mouseIsTaken_ ? std::nullopt : std::make_optional<Press>({cursorX_, cursorY_, 0.0});
        return;
    }
    if (press_ && press_->wandered <= kStill)
        clicked_ = pixelAt(sizes(), press_->x, press_->y);
    press_.reset();
}

void Window::receiveDrop(std::span<const char* const> paths) {
    pendingDrops_.insert(pendingDrops_.end(), paths.begin(), paths.end());
}

void Window::receiveCursor(double x, double y) {
    if (press_)
        press_->wandered += std::hypot(x - cursorX_, y - cursorY_);
    cursorX_ = x;
    cursorY_ = y;
}

void Window::poll(const Taken& taken, const KeyBindings& bindings, double wait) {
    pending_.clear();
    clicked_.reset();
    wheel_ = 0.0;
    mouseIsTaken_ = taken.mouse;
    pendingDrops_.clear();
    if (wait > 0.0)
        glfwWaitEventsTimeout(wait);
    else
        glfwPollEvents();
    dropped_ = pendingDrops_;
    takeSizes();
    held_ = {};
    held_.wheel = taken.mouse ? 0.0 : wheel_;
    pollKeys(taken.keys, bindings);
    pollGamepad();
    pollMouse(taken.mouse);
}

void Window::pollKeys(bool keysAreTaken, const KeyBindings& bindings) {
    keys_.clear();
    pressed_.clear();
    const auto isKeyDown = [this](KeyCode key) {
        return glfwGetKey(window_, static_cast<int>(key)) == GLFW_PRESS ||
               std::find(pending_.begin(), pending_.end(), key) != pending_.end();
    };
    const auto isDown = [&](Action action) {
        const std::span<const KeyCode> keys = bindings.keysOf(action);
        return !keysAreTaken && std::any_of(keys.begin(), keys.end(), isKeyDown);
    };
    held_.forward = isDown(Action::Forward);
    held_.back = isDown(Action::Back);
    held_.left = isDown(Action::Left);
    held_.right = isDown(Action::Right);
    held_.fast = isDown(Action::Run);
    held_.jump = isDown(Action::Jump);
    held_.up = isDown(Action::Rise);
    held_.down = isDown(Action::Sink);
    keys_ = pending_;
    for (const KeyCode key : keys_) {
        if (keysAreTaken && key != keyNamed("Escape")) // Escape leaves a page also while a text is typed
            continue;
        for (const Action action : bindings.actionsOf(key))
            pressed_.push_back(action);
    }
}

void Window::pollMouse(bool mouseIsTaken) {
    double x = 0.0, y = 0.0;
    glfwGetCursorPos(window_, &x, &y);
    const bool button = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS ||
                        glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    const bool drags = button && !isCaptured_ && (dragging_ || !mouseIsTaken);
    if ((drags && dragging_) || isCaptured_) {
        held_.lookX = x - mouseX_;
        held_.lookY = y - mouseY_;
    }
    dragging_ = drags;
    setPointer();
    glfwGetCursorPos(window_, &mouseX_, &mouseY_); // a change of mode moves the cursor
}

void Window::setPointer() {
    const bool isHidden = dragging_ || isCaptured_;
    if (isHidden != isPointerHidden_)
        glfwSetInputMode(window_, GLFW_CURSOR, isHidden ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    isPointerHidden_ = isHidden;
}

void Window::capture(bool isCaptured) {
    if (isCaptured == isCaptured_)
        return;
    isCaptured_ = isCaptured;
    setPointer();
    glfwGetCursorPos(window_, &mouseX_, &mouseY_);
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
    for (const auto& [button, action] : kPadActions)
        if (isDown(button) && (padButtons_ >> button & 1u) == 0)
            pressed_.push_back(action);
    const std::uint32_t pressed = down & ~padButtons_;
    isPadBack_ = (pressed >> GLFW_GAMEPAD_BUTTON_B & 1u) != 0;
    padButtons_ = down;
}

bool Window::wantsToClose() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

bool Window::isShown() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return width > 0 && height > 0 && glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_FALSE &&
           glfwGetWindowAttrib(window_, GLFW_VISIBLE) == GLFW_TRUE;
}

void Window::rest() {
    constexpr double kLongest = 0.1; // seconds, so that a lost display is noticed
    glfwWaitEventsTimeout(kLongest);
}

/// A lost display returns arbitrary sizes: keep the old ones.
void Window::takeSizes() {
    WindowSizes sizes;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    sizes.pixels = {static_cast<std::uint32_t>(std::max(1, width)),
                    static_cast<std::uint32_t>(std::max(1, height))};
    glfwGetWindowSize(window_, &sizes.width, &sizes.height);
    float scaleX = 1.0f, scaleY = 1.0f;
    glfwGetWindowContentScale(window_, &scaleX, &scaleY);
    sizes.contentScale = scaleX;
    if (!isLost_)
        sizes_ = sizes;
}

double Window::seconds() const {
    return glfwGetTime();
}

output::Picture Window::read() const {
    const engine::PixelSize pixels = size();
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
    return output::pictureFromRgba(pixels.width, pixels.height, rgba);
}

void Window::switchFullScreen() {
    if (framed_) {
        glfwSetWindowMonitor(window_, nullptr, framed_->x, framed_->y, framed_->width, framed_->height,
                             GLFW_DONT_CARE);
        framed_.reset();
        takeDisplayRate();
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
    takeDisplayRate();
}

/// A question to the X server: not in every frame.
void Window::takeDisplayRate() {
    int x = 0, y = 0;
    glfwGetWindowPos(window_, &x, &y);
    GLFWmonitor* monitor = monitorOf(x + sizes_.width / 2, y + sizes_.height / 2);
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode != nullptr && mode->refreshRate > 0 && !isLost_)
        displayRate_ = mode->refreshRate;
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::show() {
    glfwSwapBuffers(window_);
}

} // namespace limen::viewer
