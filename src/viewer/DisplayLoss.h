#pragma once

namespace limen::viewer {

/// Sets `isLost` when the connection to the X server breaks. Without this Xlib ends the program. After the
/// loss, calls of the library do nothing. `isLost` must outlive the connection. No effect without X11.
/// Requires an initialised GLFW.
void noteDisplayLoss(bool& isLost);

} // namespace limen::viewer
