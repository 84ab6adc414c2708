#pragma once

#include "cli/Console.h"
#include "core/Error.h"

#include <cstddef>
#include <string>

namespace limen::cli {

/// The options of `limen dat verify --retail`.
struct RetailArguments {
    std::string path, report; ///< empty: the built-in world; no report file
    std::size_t most = 50;
    bool json = false, all = false;
};

/// Judges the facts about the original files (doctor/retail/Suite.h). Exit: Finding if one is wrong. Errors: those of
/// opening the files; the report cannot be written.
[[nodiscard]] Result<Exit> runRetail(const RetailArguments& arguments, const Console& console);

} // namespace limen::cli
