#include "gpu/device/HeadlessContext.h"

#include <epoxy/egl.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace limen::gpu {
namespace {

bool isSoftware(EGLDeviceEXT device) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr &&
           std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

// Displays to try, in order.
std::vector<EGLDisplay> candidateDisplays(ContextDisplay wanted) {
    std::vector<EGLDisplay> displays;
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
        return displays;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(
            eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices{};
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
            const bool isWanted = wanted == ContextDisplay::SoftwareDevice && isSoftware(device);
            displays.insert(isWanted ? displays.begin() : displays.end(),
                            eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
        }
    }
    return displays;
}

EGLConfig configFor(EGLDisplay display) {
    if (epoxy_has_egl_extension(display, "EGL_KHR_no_config_context"))
        return EGL_NO_CONFIG_KHR;
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                                       EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display, wanted.data(), &config, 1, &count);
    return config;
}

EGLContext createContext(EGLDisplay display, bool debug, ContextProfile profile, bool notifiesOfResets) {
    const EGLint profileBit = profile == ContextProfile::Core ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                                              : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
    const std::array<EGLint, 11> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                            4,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            5,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            profileBit,
                                            EGL_CONTEXT_OPENGL_DEBUG,
                                            debug ? EGL_TRUE : EGL_FALSE,
                                            notifiesOfResets ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY
                                                             : EGL_NONE,
                                            EGL_LOSE_CONTEXT_ON_RESET,
                                            EGL_NONE};
    return eglCreateContext(display, configFor(display), EGL_NO_CONTEXT, attributes.data());
}

// A context of this display, made current; null on failure.
EGLContext contextOn(EGLDisplay display, bool debug, ContextProfile profile) {
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
        return EGL_NO_CONTEXT;
    EGLContext context = createContext(display, debug, profile, true);
    if (context == EGL_NO_CONTEXT) // the driver may not support reset notification
        context = createContext(display, debug, profile, false);
    if (context == EGL_NO_CONTEXT)
        return EGL_NO_CONTEXT;
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        eglDestroyContext(display, context);
        return EGL_NO_CONTEXT;
    }
    return context;
}

} // namespace

Result<HeadlessContext> HeadlessContext::create(bool debug, ContextProfile profile, ContextDisplay wanted) {
    const std::vector<EGLDisplay> displays = candidateDisplays(wanted);
    for (EGLDisplay display : displays)
        if (EGLContext context = contextOn(display, debug, profile); context != EGL_NO_CONTEXT)
            return HeadlessContext(display, context);
    return fail(ErrorCode::Driver, "EGL",
                fmt::format("no headless OpenGL 4.5 core context: {} displays tried, last error 0x{:04X}; "
                            "install an OpenGL driver, for example Mesa (libegl-mesa0, libgl1-mesa-dri)",
                            displays.size(), static_cast<unsigned>(eglGetError())));
}

HeadlessContext::HeadlessContext(HeadlessContext&& other) noexcept
    : display_(other.display_), context_(std::exchange(other.context_, nullptr)) {}

HeadlessContext& HeadlessContext::operator=(HeadlessContext&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    return *this;
}

Result<void> HeadlessContext::makeCurrent() {
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        return fail(ErrorCode::Driver, "EGL",
                    fmt::format("the context cannot be made current, error 0x{:04X}",
                                static_cast<unsigned>(eglGetError())));
    return {};
}

HeadlessContext::~HeadlessContext() {
    if (context_ == nullptr)
        return;
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

} // namespace limen::gpu
