#pragma once

#include "engine/SessionOptions.h"

namespace CLI {
class App;
}

namespace limen::cli {

/// Adds the options that say how a world is loaded and drawn.
void addSessionOptions(CLI::App& command, engine::SessionOptions& options);

} // namespace limen::cli
