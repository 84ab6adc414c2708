#include "core/platform/Environment.h"
#include "doctor/Machine.h"

#include <xcb/xcb.h>

namespace limen::doctor {
namespace {

bool answersAsXServer(const std::string& display) {
    xcb_connection_t* connection = xcb_connect(display.c_str(), nullptr);
    const bool answers = xcb_connection_has_error(connection) == 0;
    xcb_disconnect(connection);
    return answers;
}

} // namespace

DisplayFacts queryDisplay() {
    DisplayFacts facts;
    facts.x11 = platform::environmentVariable("DISPLAY");
    facts.wayland = platform::environmentVariable("WAYLAND_DISPLAY");
    facts.answers = !facts.x11.empty() && answersAsXServer(facts.x11);
    return facts;
}

SystemWords systemWords() {
    return {"install the package fonts-dejavu-core", "install the package ffmpeg (optional)"};
}

} // namespace limen::doctor
