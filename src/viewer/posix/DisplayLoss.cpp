#include "viewer/DisplayLoss.h"

#ifdef LIMEN_X11
#include <X11/Xlib.h>

// Declared here because GLFW/glfw3native.h needs headers of X extensions that are not used.
extern "C" Display* glfwGetX11Display(void);

namespace limen::viewer {

void noteDisplayLoss(bool& isLost) {
    Display* display = glfwGetX11Display();
    if (display == nullptr)
        return;                                     // a Wayland session
    XSetIOErrorHandler([](Display*) { return 0; }); // the default handler prints a line
    XSetIOErrorExitHandler(
        display, [](Display*, void* lost) { *static_cast<bool*>(lost) = true; }, &isLost);
}

} // namespace limen::viewer
#else
namespace limen::viewer {

void noteDisplayLoss(bool&) {}

} // namespace limen::viewer
#endif
