#pragma once

#include "viewer/Application.h"

namespace limen::viewer {

/// The window's state after `frames` frames, as one line of JSON for scripts and tests.
[[nodiscard]] std::string stateJson(const Application& application, std::size_t frames);

} // namespace limen::viewer
