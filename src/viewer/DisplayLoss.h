#pragma once

namespace limen::viewer {

/// Has a connection to an X server that breaks noted in `isLost` instead of ending the program; the library's calls then do nothing.
/// `isLost` must live as long as the connection. Where windows are not X11's: nothing. Requires a GLFW that has been started.
void noteDisplayLoss(bool& isLost);

} // namespace limen::viewer
