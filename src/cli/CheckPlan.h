#pragma once

#include "check/Run.h"
#include "cli/Console.h"
#include "engine/SessionOptions.h"
#include "engine/WorldSource.h"

#include <memory>
#include <string>

// The views of `limen check`.
namespace limen::cli {

/// The options as typed; empty: not given.
struct CheckOptions {
    engine::SessionOptions session;
    std::string kinds, size, block, directory, resume, walk, doors = "rest", day, weather = "clear",
                                                             look = "retail", format = "png", report, command;
    std::size_t views = 1000;
    std::uint64_t seed = 1;
    bool apart = false, json = false;
};

/// The views to draw and trace: of a recorded walk, else of the chosen kinds. Errors: an option's; the walk's;
/// a world without content for these kinds.
[[nodiscard]] Result<check::RunRequest> planCheck(const CheckOptions& options,
                                                  const std::shared_ptr<const engine::WorldSource>& source,
                                                  const Console& console);

} // namespace limen::cli
