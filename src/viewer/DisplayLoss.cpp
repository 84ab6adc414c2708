#include "viewer/DisplayLoss.h"

#ifdef LIMEN_X11
#include <X11/Xlib.h>

// As in GLFW/glfw3native.h, which wants headers of extensions that nothing here uses.
extern "C" Display* glfwGetX11Display(void);

namespace limen::viewer {

void noteDisplayLoss(bool& isLost) {
    Display* display = glfwGetX11Display();
    if (display == nullptr)
        return;                                     // Wayland's
    XSetIOErrorHandler([](Display*) { return 0; }); // the usual one says its own line
    XSetIOErrorExitHandler(
        display, [](Display*, void* lost) { *static_cast<bool*>(lost) = true; }, &isLost);
}

} // namespace limen::viewer
#else
namespace limen::viewer {

void noteDisplayLoss(bool&) {}

} // namespace limen::viewer
#endif
