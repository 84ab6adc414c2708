#pragma once

#include "viewer/Viewer.h"

namespace limen::viewer {

/// The window's state after `frames` frames, as one line of JSON for scripts and tests.
[[nodiscard]] std::string stateJson(const engine::Session& session, const Viewer& viewer, std::size_t frames);

} // namespace limen::viewer
