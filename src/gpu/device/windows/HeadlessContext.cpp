#include "gpu/device/HeadlessContext.h"

#include "core/platform/windows/Text.h"

#include <array>
#include <utility>

#include <epoxy/wgl.h>
#include <fmt/format.h>

namespace limen::gpu {
namespace {

Failure refusedBySystem(const char* step) {
    return fail(
        ErrorCode::Driver, "WGL",
        fmt::format("no headless OpenGL 4.5 core context: {}: {}; install or update the graphics driver",
                    step, platform::errorText(GetLastError())));
}

/// A window that is never shown, with a device context of its own. Null on failure.
HWND hiddenWindow() {
    constexpr const wchar_t* kClass = L"limen-headless";
    WNDCLASSW windowClass{};
    windowClass.style = CS_OWNDC;
    windowClass.lpfnWndProc = DefWindowProcW;
    windowClass.hInstance = GetModuleHandleW(nullptr);
    windowClass.lpszClassName = kClass;
    RegisterClassW(&windowClass); // fails harmlessly if it is registered
    return CreateWindowExW(0, kClass, L"", WS_POPUP, 0, 0, 16, 16, nullptr, nullptr, windowClass.hInstance,
                           nullptr);
}

bool choosePixelFormat(HDC device) {
    PIXELFORMATDESCRIPTOR wanted{};
    wanted.nSize = sizeof wanted;
    wanted.nVersion = 1;
    wanted.dwFlags = PFD_DRAW_TO_WINDOW | PFD_SUPPORT_OPENGL | PFD_DOUBLEBUFFER;
    wanted.iPixelType = PFD_TYPE_RGBA;
    wanted.cColorBits = 24;
    const int format = ChoosePixelFormat(device, &wanted);
    return format != 0 && SetPixelFormat(device, format, &wanted) != 0;
}

HGLRC createContext(HDC device, bool debug, ContextProfile profile, bool notifiesOfResets) {
    const int profileBit = profile == ContextProfile::Core ? WGL_CONTEXT_CORE_PROFILE_BIT_ARB
                                                           : WGL_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
    const std::array<int, 11> attributes{WGL_CONTEXT_MAJOR_VERSION_ARB,
                                         4,
                                         WGL_CONTEXT_MINOR_VERSION_ARB,
                                         5,
                                         WGL_CONTEXT_PROFILE_MASK_ARB,
                                         profileBit,
                                         WGL_CONTEXT_FLAGS_ARB,
                                         debug ? WGL_CONTEXT_DEBUG_BIT_ARB : 0,
                                         notifiesOfResets ? WGL_CONTEXT_RESET_NOTIFICATION_STRATEGY_ARB : 0,
                                         WGL_LOSE_CONTEXT_ON_RESET_ARB,
                                         0};
    return wglCreateContextAttribsARB(device, nullptr, attributes.data());
}

/// A context of version 4.5, made with the help of an old one, which alone gives access to the extension. Null on
/// failure; GetLastError has the reason.
HGLRC contextOn(HDC device, bool debug, ContextProfile profile) {
    const HGLRC old = wglCreateContext(device);
    if (old == nullptr || wglMakeCurrent(device, old) == 0)
        return nullptr;
    HGLRC context = nullptr;
    if (epoxy_has_wgl_extension(device, "WGL_ARB_create_context_profile")) {
        if (epoxy_has_wgl_extension(device, "WGL_ARB_create_context_robustness"))
            context = createContext(device, debug, profile, true);
        if (context == nullptr)
            context = createContext(device, debug, profile, false);
    }
    const DWORD error = GetLastError();
    wglMakeCurrent(nullptr, nullptr);
    wglDeleteContext(old);
    if (context != nullptr && wglMakeCurrent(device, context) == 0) {
        wglDeleteContext(context);
        return nullptr;
    }
    SetLastError(error);
    return context;
}

/// libepoxy keeps a table of functions for each thread. The table of a new thread is empty, also for the call that makes a
/// context current, until libepoxy is told of such a call.
void prepareThread() {
    epoxy_handle_external_wglMakeCurrent();
}

} // namespace

Result<HeadlessContext> HeadlessContext::create(bool debug, ContextProfile profile,
                                                ContextDisplay /*display*/) {
    prepareThread();
    const HWND window = hiddenWindow();
    if (window == nullptr)
        return refusedBySystem("no window can be made");
    const HDC device = GetDC(window);
    const HGLRC context = choosePixelFormat(device) ? contextOn(device, debug, profile) : nullptr;
    if (context != nullptr) {
        prepareThread(); // functions of the old context count no longer
        return HeadlessContext(window, context);
    }
    const Failure failure = refusedBySystem("the driver made none");
    DestroyWindow(window);
    return failure;
}

HeadlessContext::HeadlessContext(HeadlessContext&& other) noexcept
    : display_(std::exchange(other.display_, nullptr)), context_(std::exchange(other.context_, nullptr)) {}

HeadlessContext& HeadlessContext::operator=(HeadlessContext&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    return *this;
}

Result<void> HeadlessContext::makeCurrent() {
    prepareThread();
    if (wglMakeCurrent(GetDC(static_cast<HWND>(display_)), static_cast<HGLRC>(context_)) == 0)
        return fail(ErrorCode::Driver, "WGL",
                    "the context cannot be made current: " + platform::errorText(GetLastError()));
    return {};
}

HeadlessContext::~HeadlessContext() {
    if (context_ == nullptr)
        return;
    if (wglGetCurrentContext() == context_)
        wglMakeCurrent(nullptr, nullptr);
    wglDeleteContext(static_cast<HGLRC>(context_));
    DestroyWindow(static_cast<HWND>(display_));
}

} // namespace limen::gpu
