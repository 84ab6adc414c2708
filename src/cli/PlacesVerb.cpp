#include "cli/OpenWorld.h"
#include "cli/Verbs.h"
#include "engine/WorldSource.h"
#include "engine/map/MapCoordinates.h"
#include "engine/places/FoundPlaces.h"
#include "world/Lookup.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

struct PlacesOptions {
    std::string dat;
    bool json = false;
};

dat::BlockCoord blockOf(const world::Place& place) {
    return place.cell != 0 ? dat::blockOf(place.cell) : world::blockAt(place.eye);
}

/// Cells of dungeons have coordinates that mean nothing on the map.
std::string coordinatesOf(const world::Place& place) {
    return place.cell == 0 ? engine::mapText(Vec2(place.eye)) : "";
}

std::string cellOf(const world::Place& place) {
    return place.cell == 0 ? "outside" : dat::idText(place.cell);
}

std::string tableOf(const world::WorldFile& file) {
    std::size_t widest = 4;
    for (const world::Place& place : file.places)
        widest = std::max(widest, place.name.size());
    std::string text = fmt::format("{:<{}}  {:<14}  block  cell\n", "name", widest, "coordinates");
    for (const world::Place& place : file.places) {
        const dat::BlockCoord block = blockOf(place);
        text += fmt::format("{:<{}}  {:<14}  {:02X}{:02X}   {}{}\n", place.name, widest, coordinatesOf(place),
                            block.x, block.y, cellOf(place), place.name == file.start ? "  (start)" : "");
    }
    return text;
}

std::string jsonOf(const world::WorldFile& file) {
    nlohmann::ordered_json places = nlohmann::ordered_json::array();
    for (const world::Place& place : file.places) {
        const dat::BlockCoord block = blockOf(place);
        places.push_back({{"name", place.name},
                          {"coordinates", coordinatesOf(place)},
                          {"block", fmt::format("{:02X}{:02X}", block.x, block.y)},
                          {"cell", cellOf(place)},
                          {"eye", {place.eye.x, place.eye.y, place.eye.z}},
                          {"yaw", place.yaw},
                          {"pitch", place.pitch}});
    }
    nlohmann::ordered_json json{{"start", file.start}, {"places", std::move(places)}};
    return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<Exit> runPlaces(const PlacesOptions& options, const Console& console) {
    const Result<engine::WorldSource> source = openWorld(console, options.dat);
    if (!source)
        return Failure(source.error());
    if (source->file.places.empty() && !options.json)
        console.note("limen: this world has no places; give a position with --eye X,Y,Z");
    console.data(options.json ? jsonOf(source->file) : tableOf(source->file));
    return Exit::Done;
}

} // namespace

void addPlacesVerb(CLI::App& program, const Console& console, Choice& choice) {
    CLI::App* verb = program.add_subcommand("places", "list the places of a world, for --at");
    const auto options = std::make_shared<PlacesOptions>();
    verb->add_option("--dat", options->dat, "read the world in this directory (the built-in world)")
        ->type_name("DIR");
    verb->add_flag("--json", options->json, "print the places as one JSON object");
    verb->footer(
        "Lists the places of world.json. A world without that file gets the towns, well-known places\n"
        "and dungeons that its records show. Letter case, spaces and hyphens do not matter in --at.\n"
        "Examples:\n  limen places\n  limen places --json");
    verb->callback([&console, &choice, options] {
        choice.run = [&console, options] { return runPlaces(*options, console); };
    });
}

} // namespace limen::cli
