#pragma once

#include "cli/help/CommandFacts.h"

namespace limen::cli {

/// The kind of value that an option or an argument takes, read from its notation.
enum class ValueKind { None, Choice, Place, Verb, File, Directory, Other };
[[nodiscard]] ValueKind valueKindOf(const OptionFacts& option);

} // namespace limen::cli
