#include "cli/world/PlacedImport.h"

#include "core/AbsolutePath.h"
#include "core/NumberText.h"
#include "core/platform/Environment.h"
#include "engine/DatDirectory.h"
#include "output/OutputFile.h"
#include "placements/Import.h"
#include "placements/WorldDb.h"
#include "placements/server/ServerUrl.h"

#include <algorithm>
#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <memory>

namespace limen::cli {
namespace {

/// The file to write: as given, or beside the dat files.
Result<std::filesystem::path> outputOf(const PlacedImport& arguments) {
    if (!arguments.output.empty())
        return arguments.output;
    if (arguments.dat.empty())
        return placements::kWorldDbName;
    return engine::findDatDirectory(arguments.dat).map([](const engine::DatDirectory& found) {
        return found.paths.directory / placements::kWorldDbName;
    });
}

/// The sources as the file keeps them.
std::string sourceText(const std::vector<std::string>& sources) {
    std::string text;
    for (const std::string& source : sources) {
        const bool isUrl = placements::isServerUrl(source);
        text += (text.empty() ? "" : ", ") + (isUrl ? source : absolutePath(source).string());
    }
    return text;
}

std::string nowText() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

/// Reads the sources with a progress bar. A signal cancels it.
Result<placements::Content> readSources(const PlacedImport& arguments, const Console& console) {
    std::unique_ptr<Progress> bar;
    const placements::ImportProgress progress = [&](std::size_t done, std::size_t total) {
        if (bar == nullptr)
            bar = std::make_unique<Progress>(console, "importing", total);
        bar->step(done);
        return !console.interrupt().isRequested();
    };
    if (placements::isServerUrl(arguments.sources.front())) {
        return placements::importServer(
            {arguments.sources.front(), platform::environmentVariable("MYSQL_PWD"), arguments.optionFile},
            progress);
    }
    return placements::importSqlFiles({arguments.sources.begin(), arguments.sources.end()}, progress);
}

void report(const std::filesystem::path& path, const placements::WriteCounts& counts,
            const Console& console) {
    const std::string all = fmt::format("{} placed objects, {} templates", groupedText(counts.placements),
                                        groupedText(counts.templates));
    if (counts.isUnchanged()) {
        console.note(fmt::format("limen: {} is up to date: {}", path.string(), all));
        return;
    }
    console.wrote(path, all);
    const auto changes = [&](const char* what, std::size_t written, std::size_t removed) {
        if (written + removed > 0)
            console.note(fmt::format("limen: {}: {} written, {} removed", what, groupedText(written),
                                     groupedText(removed)));
    };
    changes("landblocks", counts.landblocksWritten, counts.landblocksRemoved);
    changes("templates", counts.templatesWritten, counts.templatesRemoved);
}

} // namespace

Result<Exit> importPlaced(const PlacedImport& arguments, const Console& console) {
    const auto isUrl = [](const std::string& source) { return placements::isServerUrl(source); };
    if (arguments.sources.size() > 1 &&
        std::any_of(arguments.sources.begin(), arguments.sources.end(), isUrl))
        return fail(ErrorCode::BadArgument, "SOURCE", "a server is the only source; give one URL, or paths");
    const Result<std::filesystem::path> path = outputOf(arguments);
    if (!path)
        return Failure(path.error());
    if (Result<void> writable = output::checkWritable(*path); !writable)
        return Failure(writable.error());
    console.interrupt().defer();
    const Result<placements::Content> content = readSources(arguments, console);
    if (!content)
        return console.interrupt().isRequested() ? Result<Exit>(Exit::Interrupted) : Failure(content.error());
    const Result<placements::WriteCounts> counts = [&] {
        const Waiting waiting(console, "writing " + path->filename().string());
        return placements::writeWorldDb(*path, *content, {sourceText(arguments.sources), nowText()},
                                        [&] { return !console.interrupt().isRequested(); });
    }();
    if (!counts)
        return console.interrupt().isRequested() ? Result<Exit>(Exit::Interrupted) : Failure(counts.error());
    report(*path, *counts, console);
    return Exit::Done;
}

} // namespace limen::cli
