#pragma once

#include "engine/Session.h"
#include "output/report/ReportHead.h"

namespace CLI {
class App;
}

namespace limen::cli {

/// The command line of a parsed verb, "limen VERB --option value …", quoted for a shell. Order: as declared.
[[nodiscard]] std::string commandLineOf(const CLI::App& verb);

/// World, driver, version, date and options of a session.
[[nodiscard]] output::ReportHead reportHead(const engine::Session& session, const std::string& command);

/// Makes the directory of a report and tests whether its page can be written. Empty: nothing.
[[nodiscard]] Result<void> checkReportPlace(const std::string& directory);
/// Writes DIR/index.html and returns its path.
[[nodiscard]] Result<std::string> writeReport(const std::string& directory, const std::string& page);

} // namespace limen::cli
