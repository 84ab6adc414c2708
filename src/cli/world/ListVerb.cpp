#include "cli/Choices.h"
#include "cli/Parse.h"
#include "cli/world/PlacedList.h"
#include "cli/world/WorldVerbs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

struct WorldListArguments {
    std::string dat, name, type, block;
    double limit = 0.0;
    bool json = false;
};

/// Text of a file without control characters, which a terminal would obey.
std::string plain(std::string text) {
    for (char& c : text)
        c = static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    return text;
}

std::string cellText(const PlacedLine& line) {
    return line.cell == 0 ? "outside" : dat::idText(line.cell);
}

std::string tableLine(const PlacedLine& line) {
    return fmt::format("{:<12} {:<10} {:<10} {:<10} {:>9.2f} {:>9.2f} {:>8.2f}  {}\n", plain(line.id),
                       line.type, line.origin, cellText(line), line.position.x, line.position.y,
                       line.position.z, plain(line.name));
}

std::string jsonLine(const PlacedLine& line) {
    const nlohmann::ordered_json object{
        {"id", line.id},           {"type", line.type},
        {"template", line.origin}, {"name", line.name},
        {"cell", cellText(line)},  {"position", {line.position.x, line.position.y, line.position.z}}};
    return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

Result<Exit> runWorldList(const WorldListArguments& arguments, const Console& console) {
    PlacedFilter filter{arguments.name, arguments.type, std::nullopt,
                        static_cast<std::size_t>(arguments.limit)};
    if (!arguments.block.empty()) {
        constexpr std::uint32_t kGreatestBlock = 0xFFFF;
        const Result<dat::RecordId> block = parseRecordId("--block", arguments.block);
        if (!block || *block > kGreatestBlock)
            return fail(ErrorCode::BadArgument, "--block", "give a landblock in hexadecimal, e.g. A9B4");
        filter.block = *block;
    }
    const Result<PlacedWorld> world = openPlacedWorld(arguments.dat);
    if (!world)
        return Failure(world.error());
    const Result<std::vector<PlacedLine>> lines = listPlaced(*world, filter);
    if (!lines)
        return Failure(lines.error());
    if (lines->empty())
        console.note(fmt::format("limen: no such object is in {}", world->path.string()));
    else if (!arguments.json)
        console.data(fmt::format("{:<12} {:<10} {:<10} {:<10} {:>9} {:>9} {:>8}  name\n", "id", "type",
                                 "template", "cell", "x", "y", "z"));
    for (const PlacedLine& line : *lines)
        console.data(arguments.json ? jsonLine(line) : tableLine(line));
    return Exit::Done;
}

struct WorldShowArguments {
    std::string dat, id;
};

Result<Exit> runWorldShow(const WorldShowArguments& arguments, const Console& console) {
    const Result<PlacedWorld> world = openPlacedWorld(arguments.dat);
    if (!world)
        return Failure(world.error());
    const Result<nlohmann::ordered_json> object = describePlaced(*world, arguments.id);
    if (!object)
        return Failure(object.error());
    console.data(object->dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    return Exit::Done;
}

} // namespace

void addWorldListVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("list", "list the placed objects of a world");
    const auto arguments = std::make_shared<WorldListArguments>();
    verb->add_option("--dat", arguments->dat,
                     "read the world.db or world.json of this directory, or this file (the built-in world)")
        ->type_name("PATH");
    verb->add_option("--name", arguments->name, "list only objects with this text in their name (all)")
        ->type_name("TEXT");
    verb->add_option("--type", arguments->type, "list only objects of this type, e.g. door (all)")
        ->type_name("TYPE");
    verb->add_option("--block", arguments->block, "list only objects of this landblock, e.g. A9B4 (all)")
        ->type_name("XXYY");
    verb->add_option("--limit", arguments->limit, "list at most this number of objects (all)")
        ->type_name("N")
        ->check(within(1, 1e9));
    verb->add_flag("--json", arguments->json, "print one JSON object per line");
    verb->footer("Positions are global metres.\n"
                 "Examples:\n  limen world list --type door\n  limen world list --name mill --json");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runWorldList(*arguments, console); };
    });
}

void addWorldShowVerb(CLI::App& world, const Console& console, Choice& choice) {
    CLI::App* verb = world.add_subcommand("show", "print one placed object, or one template, as JSON");
    const auto arguments = std::make_shared<WorldShowArguments>();
    verb->add_option(
            "ID", arguments->id,
            "print the object with this id, e.g. 0x7A9B4000, or the template with this number, e.g. 412")
        ->required()
        ->type_name("");
    verb->add_option("--dat", arguments->dat,
                     "read the world.db or world.json of this directory, or this file (the built-in world)")
        ->type_name("PATH");
    verb->footer("Objects of a world.json have their name as id.\n"
                 "Examples:\n  limen world show inn.front\n  limen world show 0x7A9B4000 --dat DIR");
    verb->callback([&console, &choice, arguments] {
        choice.run = [&console, arguments] { return runWorldShow(*arguments, console); };
    });
}

} // namespace limen::cli
