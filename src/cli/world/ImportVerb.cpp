#include "cli/Choices.h"
#include "cli/world/WorldVerbs.h"
#include "core/AbsolutePath.h"
#include "core/NumberText.h"
#include "core/platform/Environment.h"
#include "engine/DatDirectory.h"
#include "output/OutputFile.h"
#include "placements/Import.h"
#include "placements/WorldDb.h"
#include "placements/server/ServerUrl.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <memory>

namespace limen::cli {
namespace {

struct WorldImportArguments {
    std::vector<std::string> sources;
    std::string dat, output, optionFile;
};

/// The file to write: as given, or beside the dat files.
Result<std::filesystem::path> outputOf(const WorldImportArguments& arguments) {
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
Result<placements::Content> readSources(const WorldImportArguments& arguments, const Console& console) {
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

Result<Exit> runWorldImport(const WorldImportArguments& arguments, const Console& console) {
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

} // namespace

void addWorldImportVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("import", "write a world.db from the community's world database");
    const auto arguments = std::make_shared<WorldImportArguments>();
    verb->add_option("SOURCE", arguments->sources,
                     "read these directories, archives or files of SQL, or this server; later paths replace "
                     "earlier ones")
        ->required()
        ->type_name("")
        ->check(notEmpty());
    verb->add_option("--dat", arguments->dat, "write the file beside these dat files (the working directory)")
        ->type_name("DIR");
    verb->add_option("-o,--output", arguments->output, "write this file (world.db)")->type_name("FILE");
    verb->add_option("--option-file", arguments->optionFile,
                     "read user and password of the server from this option file of MySQL (none)")
        ->type_name("FILE");
    verb->footer(
        "The files of the core come first, then those of the patches. A second import writes only the "
        "landblocks\n"
        "and templates that differ. A server is given as mariadb://USER@HOST/DATABASE or, for a socket, as\n"
        "mariadb://USER@/DATABASE?socket=PATH; the password is in the variable MYSQL_PWD or in an option "
        "file.\n"
        "The server is only read. Where world.db stands beside the dat files, every verb shows its objects.\n"
        "Examples:\n  limen world import core patches --dat DIR\n"
        "  limen world import mariadb://ann@localhost/ace_world -o world.db");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runWorldImport(*arguments, console); };
    });
}

} // namespace limen::cli
