#pragma once

#include "cli/Verbs.h"

// The verbs below `limen world`.
namespace limen::cli {

void addWorldImportVerb(CLI::App& world, const Console& console, Choice& choice);
void addWorldListVerb(CLI::App& world, const Console& console, Choice& choice);
void addWorldShowVerb(CLI::App& world, const Console& console, Choice& choice);
void addWorldExportVerb(CLI::App& world, const Console& console, Choice& choice);
void addWorldStatsVerb(CLI::App& world, const Console& console, Choice& choice);

} // namespace limen::cli
