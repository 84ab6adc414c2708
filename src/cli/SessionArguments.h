#pragma once

#include "engine/SessionOptions.h"

#include <string>

namespace CLI {
class App;
}

namespace limen::cli {

/// Adds the options for loading and drawing a world.
void addSessionOptions(CLI::App& command, engine::SessionOptions& options);

/// Adds --gate.
void addGate(CLI::App& command, engine::SessionOptions& options);

/// Adds --draw, with the way of drawing without it, as its help names it.
void addDrawing(CLI::App& command, engine::SessionOptions& options, gpu::Drawing usual,
                const std::string& usualText);

} // namespace limen::cli
