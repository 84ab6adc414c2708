#include "cli/Choices.h"
#include "cli/world/PlacedList.h"
#include "cli/world/WorldVerbs.h"
#include "core/NumberText.h"
#include "engine/placed/RowsOfWorldFile.h"
#include "output/OutputFile.h"
#include "placements/ExportSql.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

struct WorldExportArguments {
    std::string dat, output, as = "sql";
};

/// The rows of a database, or those that a world.json gives.
Result<placements::Content> contentOf(const PlacedWorld& world, const Console& console) {
    if (world.database != nullptr)
        return world.database->readAll();
    engine::WorldFileRows rows = engine::rowsOf(*world.file);
    console.note(
        fmt::format("limen: rows for {} doors and {} standing people; rows cannot hold {} panes and emitters",
                    rows.doors, rows.people, rows.left));
    return std::move(rows.content);
}

/// Writes each landblock and each template to a file of SQL below a directory.
Result<Exit> exportSql(const PlacedWorld& world, const std::filesystem::path& directory,
                       const Console& console) {
    const Result<placements::Content> content = contentOf(world, console);
    if (!content)
        return Failure(content.error());
    std::size_t done = 0;
    const std::size_t total = content->landblocks.size() + content->templates.size();
    console.interrupt().defer();
    Progress progress(console, "exporting", total);
    const auto write = [&](const placements::SqlText& file) -> Result<void> {
        progress.step(++done);
        const std::filesystem::path path = directory / file.path;
        return output::makeDirectory(path.parent_path()).and_then([&] {
            return output::writeFile(path, file.text);
        });
    };
    for (const auto& [id, landblock] : content->landblocks) {
        if (console.interrupt().isRequested())
            return Exit::Interrupted;
        if (Result<void> written = write(sqlOf(id, landblock)); !written)
            return Failure(written.error());
    }
    for (const auto& [id, of] : content->templates) {
        if (console.interrupt().isRequested())
            return Exit::Interrupted;
        if (Result<void> written = write(sqlOf(of)); !written)
            return Failure(written.error());
    }
    console.wrote(directory, fmt::format("{} files", groupedText(total)));
    return Exit::Done;
}

/// Writes all objects to one file of JSON: a list, in the form of `limen world show`.
Result<Exit> exportJson(const PlacedWorld& world, const std::filesystem::path& path, const Console& console) {
    const Result<std::vector<PlacedLine>> lines = listPlaced(world, {});
    if (!lines)
        return Failure(lines.error());
    console.interrupt().defer();
    Progress progress(console, "exporting", lines->size());
    std::string text = "[";
    for (std::size_t i = 0; i < lines->size(); ++i) {
        if (console.interrupt().isRequested())
            return Exit::Interrupted;
        const Result<nlohmann::ordered_json> object = describePlaced(world, (*lines)[i].id);
        if (!object)
            return Failure(object.error());
        text +=
            (i > 0 ? ",\n" : "\n") + object->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        progress.step(i + 1);
    }
    text += "\n]\n";
    if (Result<void> written = output::writeFile(path, text); !written)
        return Failure(written.error());
    console.wrote(path, fmt::format("{} objects", groupedText(lines->size())));
    return Exit::Done;
}

Result<Exit> runWorldExport(const WorldExportArguments& arguments, const Console& console) {
    const bool isSql = arguments.as == "sql";
    const std::filesystem::path output = !arguments.output.empty() ? arguments.output
                                         : isSql                   ? "."
                                                                   : "world-objects.json";
    if (Result<void> ready = isSql ? output::makeDirectory(output) : output::checkWritable(output); !ready)
        return Failure(ready.error());
    const Result<PlacedWorld> world = openPlacedWorld(arguments.dat);
    if (!world)
        return Failure(world.error());
    return isSql ? exportSql(*world, output, console) : exportJson(*world, output, console);
}

} // namespace

void addWorldExportVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("export", "write the placed objects of a world as SQL or as JSON");
    const auto arguments = std::make_shared<WorldExportArguments>();
    verb->add_option("--dat", arguments->dat,
                     "read the world.db or world.json of this directory, or this file (the built-in world)")
        ->type_name("PATH");
    verb->add_option("--as", arguments->as, "write files of SQL in a directory, or one file of JSON (sql)")
        ->type_name("sql|json")
        ->check(oneOf({"sql", "json"}));
    verb->add_option("-o,--output", arguments->output,
                     "write this file or directory (., or world-objects.json)")
        ->type_name("PATH");
    verb->footer(
        "The files of SQL have the layout of the community's world database. A server executes them, and\n"
        "limen world import reads them.\n"
        "Examples:\n  limen world export --as json -o objects.json\n"
        "  limen world export --dat DIR -o sql");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runWorldExport(*arguments, console); };
    });
}

} // namespace limen::cli
