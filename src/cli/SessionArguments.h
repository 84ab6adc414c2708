#pragma once

#include "engine/SessionOptions.h"

namespace CLI {
class App;
}

namespace limen::cli {

/// Adds the options for loading and drawing a world.
void addSessionOptions(CLI::App& command, engine::SessionOptions& options);

} // namespace limen::cli
