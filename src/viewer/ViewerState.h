#pragma once

#include "viewer/Viewer.h"

namespace limen::viewer {

/// What a window shows after so many frames, as a line of JSON: for scripts, and for tests that follow it.
[[nodiscard]] std::string stateJson(const engine::Session& session, const Viewer& viewer, std::size_t frames);

} // namespace limen::viewer
