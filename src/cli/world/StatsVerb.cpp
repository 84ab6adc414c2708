#include "cli/OpenWorld.h"
#include "cli/world/PlacedWorld.h"
#include "cli/world/WorldVerbs.h"
#include "core/NumberText.h"
#include "engine/placed/PlacedHealth.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

namespace limen::cli {
namespace {

struct WorldStatsArguments {
    std::string dat;
    bool json = false, resolve = false;
};

/// Counts in the order of their names.
using Counts = std::map<std::string, std::size_t>;

/// The source of a world's objects, and their counts.
struct WorldStats {
    std::string source, time;
    std::size_t landblocks = 0, templates = 0, links = 0;
    Counts byType;
    std::optional<engine::PlacedHealth> health{}; ///< where it was asked for
};

Result<WorldStats> statsOf(const placements::WorldDb& database) {
    const Result<placements::Origin> origin = database.origin();
    const Result<placements::Content> content = database.readAll();
    if (!origin || !content)
        return Failure(!origin ? origin.error() : content.error());
    WorldStats stats{
        origin->source, origin->time, content->landblocks.size(), content->templates.size(), 0, {}};
    for (const auto& [id, landblock] : content->landblocks) {
        stats.links += landblock.links.size();
        for (const placements::Placement& placement : landblock.placements) {
            const auto of = content->templates.find(placement.templateId);
            ++stats.byType[of != content->templates.end() ? placements::typeName(of->second.type)
                                                          : "without a template"];
        }
    }
    return stats;
}

WorldStats statsOf(const PlacedWorld& world) {
    WorldStats stats;
    stats.source = world.path.string();
    stats.byType = {{"door", world.file->moving.doors.size()},
                    {"villager", world.file->moving.villagers.size()},
                    {"emitter", world.file->moving.emitters.size()}};
    return stats;
}

std::string statsTable(const WorldStats& stats) {
    std::string text = fmt::format("source      {}\n", stats.source);
    if (!stats.time.empty())
        text += fmt::format("imported    {}\nlandblocks  {:>9}\ntemplates   {:>9}\nlinks       {:>9}\n",
                            stats.time, groupedText(stats.landblocks), groupedText(stats.templates),
                            groupedText(stats.links));
    std::size_t total = 0;
    for (const auto& [type, count] : stats.byType)
        total += count;
    text += fmt::format("objects     {:>9}\n", groupedText(total));
    for (const auto& [type, count] : stats.byType)
        text += fmt::format("  {:<18} {:>9}\n", type, groupedText(count));
    if (stats.health) {
        text += fmt::format("drawn       {:>9}\ndoors       {:>9}, {} in an opening\n",
                            groupedText(stats.health->visible), groupedText(stats.health->doors),
                            groupedText(stats.health->hungDoors));
        for (const auto& [reason, names] : stats.health->unresolved)
            text += fmt::format("  {:>9}  {}\n", groupedText(names.size()), reason);
    }
    return text;
}

std::string statsJson(const WorldStats& stats) {
    nlohmann::ordered_json object{{"source", stats.source},         {"imported", stats.time},
                                  {"landblocks", stats.landblocks}, {"templates", stats.templates},
                                  {"links", stats.links},           {"objects", stats.byType}};
    if (stats.health)
        object["compared"] = {{"drawn", stats.health->visible},
                              {"doors", stats.health->doors},
                              {"doors_in_an_opening", stats.health->hungDoors},
                              {"unresolved", stats.health->unresolved}};
    return object.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// Compares the world.db of a directory with the dat files there.
Result<engine::PlacedHealth> healthOf(const std::string& dat, const Console& console) {
    const Result<engine::WorldSource> source = openWorld(console, dat, engine::PlaceSearch::Skip);
    if (!source)
        return Failure(source.error());
    if (source->placed == nullptr)
        return fail(ErrorCode::NotFound, source->archive.directory().string(),
                    "no world.db is beside the dat files; write one with limen world import");
    console.interrupt().defer();
    std::unique_ptr<Progress> bar;
    return engine::placedHealth(*source->placed, source->archive, [&](std::size_t done, std::size_t total) {
        if (bar == nullptr)
            bar = std::make_unique<Progress>(console, "comparing", total);
        bar->step(done);
        return !console.interrupt().isRequested();
    });
}

Result<Exit> runWorldStats(const WorldStatsArguments& arguments, const Console& console) {
    const Result<PlacedWorld> world = openPlacedWorld(arguments.dat);
    if (!world)
        return Failure(world.error());
    Result<WorldStats> stats = world->database != nullptr ? statsOf(*world->database) : statsOf(*world);
    if (!stats)
        return Failure(stats.error());
    if (arguments.resolve) {
        Result<engine::PlacedHealth> health = healthOf(arguments.dat, console);
        if (!health)
            return console.interrupt().isRequested() ? Result<Exit>(Exit::Interrupted)
                                                     : Failure(health.error());
        stats->health = std::move(*health);
    }
    console.data(arguments.json ? statsJson(*stats) : statsTable(*stats));
    return Exit::Done;
}

} // namespace

void addWorldStatsVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("stats", "count the placed objects of a world by type");
    const auto arguments = std::make_shared<WorldStatsArguments>();
    verb->add_option("--dat", arguments->dat,
                     "read the world.db or world.json of this directory, or this file (the built-in world)")
        ->type_name("PATH");
    verb->add_flag("--json", arguments->json, "print one JSON object");
    verb->add_flag(
        "--resolve", arguments->resolve,
        "compare world.db with the dat files beside it: missing records, and doors without an opening");
    verb->footer("--resolve loads each landblock with doors. With --json it lists the names of all "
                 "unresolved objects.\n"
                 "Examples:\n  limen world stats\n  limen world stats --dat DIR --json");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runWorldStats(*arguments, console); };
    });
}

} // namespace limen::cli
