#pragma once

#include "app/Viewer.h"

namespace limen::app {

/// What a window shows after so many frames, as a line of JSON: for scripts, and for tests that follow it.
[[nodiscard]] std::string stateJson(const Session& session, const Viewer& viewer, std::size_t frames);

} // namespace limen::app
