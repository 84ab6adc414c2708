#include "cli/world/PlacedList.h"

#include "cli/Choices.h"
#include "world/Lookup.h"
#include "world/World.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace limen::cli {
namespace {

using Json = nlohmann::ordered_json;
using placements::Spot;
using placements::Template;

/// The global position of a spot.
Vec3 globalOf(const Spot& spot) {
    const double x = spot.cell >> 24, y = (spot.cell >> 16) & 0xFF;
    return {x * world::kBlockSize + static_cast<double>(spot.origin[0]),
            y * world::kBlockSize + static_cast<double>(spot.origin[1]), static_cast<double>(spot.origin[2])};
}

std::uint32_t indoorCellOf(const Spot& spot) {
    constexpr std::uint32_t kFirstIndoors = 0x0100;
    return (spot.cell & 0xFFFF) >= kFirstIndoors ? spot.cell : 0;
}

/// An id that is all digits of a base; none else.
std::optional<std::uint32_t> numberOf(std::string_view text, int base) {
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number, base);
    const bool isNumber = read.ec == std::errc() && read.ptr == text.data() + text.size();
    return isNumber ? std::optional(number) : std::nullopt;
}

bool contains(const std::string& text, const std::string& part) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return part.empty() || std::search(text.begin(), text.end(), part.begin(), part.end(),
                                       [&](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

/// The number of the landblock that a global position is in.
std::uint32_t blockNumberOf(std::uint32_t cell, const Vec3& position) {
    if (cell != 0)
        return cell >> 16;
    const dat::BlockCoord block = world::blockAt(position);
    return static_cast<std::uint32_t>(block.x) << 8 | static_cast<std::uint32_t>(block.y);
}

Result<std::vector<PlacedLine>> linesOf(const placements::WorldDb& database, const PlacedFilter& filter) {
    std::optional<std::int32_t> type;
    if (!filter.type.empty()) {
        type = placements::parseType(filter.type);
        if (!type)
            return fail(ErrorCode::BadArgument, "--type",
                        fmt::format("unknown type '{}'{}", filter.type,
                                    suggestion(filter.type, {"generic", "portal", "creature", "vendor",
                                                             "door", "chest", "lifestone", "switch"})));
    }
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    const std::size_t limit = filter.limit == 0 || filter.block ? kAll : filter.limit;
    const Result<std::vector<placements::Found>> found = database.search(filter.name, type, limit);
    if (!found)
        return Failure(found.error());
    std::vector<PlacedLine> lines;
    for (const placements::Found& one : *found)
        if (!filter.block || *filter.block == landblockOf(one.placement.spot))
            lines.push_back({fmt::format("0x{:08X}", one.placement.guid), placements::typeName(one.type),
                             one.name, std::to_string(one.placement.templateId),
                             indoorCellOf(one.placement.spot), globalOf(one.placement.spot)});
    return lines;
}

std::vector<PlacedLine> linesOf(const world::WorldFile& file, const PlacedFilter& filter) {
    std::vector<PlacedLine> lines;
    const auto add = [&](const char* type, const std::string& name, dat::RecordId model, dat::RecordId cell,
                         const Vec3& position) {
        if (!contains(name, filter.name) || (!filter.type.empty() && filter.type != type) ||
            (filter.block && *filter.block != blockNumberOf(cell, position)))
            return;
        lines.push_back({name, type, name, model != 0 ? dat::idText(model) : "", cell, position});
    };
    for (const world::DoorEntry& door : file.moving.doors)
        add("door", door.name, door.leaves.empty() ? 0 : door.leaves.front().model, door.cell,
            door.leaves.empty() ? Vec3(0.0) : door.leaves.front().position);
    for (const world::VillagerEntry& villager : file.moving.villagers) {
        const auto route = std::find_if(file.moving.routes.begin(), file.moving.routes.end(),
                                        [&](const world::RouteEntry& r) { return r.name == villager.route; });
        if (route != file.moving.routes.end())
            add("villager", villager.name, villager.model, route->points.front().cell,
                route->points.front().position);
    }
    for (const world::EmitterEntry& emitter : file.moving.emitters)
        add("emitter", emitter.name, emitter.surface, emitter.cell, emitter.position);
    std::stable_sort(lines.begin(), lines.end(),
                     [](const PlacedLine& a, const PlacedLine& b) { return a.name < b.name; });
    return lines;
}

Json jsonOf(const Spot& spot) {
    return {{"cell", fmt::format("0x{:08X}", spot.cell)}, {"origin", spot.origin}, {"angles", spot.angles}};
}

template <class T>
void put(Json& object, const char* key, const std::optional<T>& value) {
    if (value)
        object[key] = *value;
}
void putId(Json& object, const char* key, std::uint32_t id) {
    if (id != 0)
        object[key] = fmt::format("0x{:08X}", id);
}

Json overridesOf(const Template& of) {
    Json lists = Json::object();
    for (const auto& change : of.palettes)
        lists["palettes"].push_back({{"palette", fmt::format("0x{:08X}", change.palette)},
                                     {"offset", change.offset},
                                     {"length", change.length}});
    for (const auto& change : of.textures)
        lists["textures"].push_back({{"part", change.part},
                                     {"from", fmt::format("0x{:08X}", change.from)},
                                     {"to", fmt::format("0x{:08X}", change.to)}});
    for (const auto& change : of.parts)
        lists["parts"].push_back({{"part", change.part}, {"model", fmt::format("0x{:08X}", change.model)}});
    for (const auto& item : of.items)
        lists["items"].push_back({{"destination", item.destination},
                                  {"template", item.templateId},
                                  {"palette", item.palette},
                                  {"shade", item.shade}});
    for (const auto& entry : of.generator)
        lists["generator"].push_back({{"template", entry.templateId},
                                      {"probability", entry.probability},
                                      {"initially", entry.initCreate},
                                      {"at_most", entry.maxCreate}});
    return lists;
}

Json jsonOf(const Template& of) {
    Json object{{"template", of.id},
                {"class", of.className},
                {"type", placements::typeName(of.type)},
                {"name", of.name}};
    putId(object, "setup", of.setup);
    putId(object, "motion_table", of.motionTable);
    putId(object, "palette_base", of.paletteBase);
    putId(object, "clothing_base", of.clothingBase);
    putId(object, "physics_effects", of.physicsEffects);
    putId(object, "physics_script", of.physicsScript);
    putId(object, "head", of.headObject);
    putId(object, "hair_palette", of.hairPalette);
    putId(object, "eyes_palette", of.eyesPalette);
    putId(object, "skin_palette", of.skinPalette);
    put(object, "palette_template", of.paletteTemplate);
    put(object, "physics_state", of.physicsState);
    put(object, "item_type", of.itemType);
    put(object, "clothing_priority", of.clothingPriority);
    put(object, "valid_locations", of.validLocations);
    put(object, "shade", of.shade);
    put(object, "scale", of.scale);
    put(object, "translucency", of.translucency);
    put(object, "open", of.open);
    put(object, "locked", of.locked);
    put(object, "ethereal", of.ethereal);
    put(object, "visibility", of.visibility);
    put(object, "default_open", of.defaultOpen);
    put(object, "default_locked", of.defaultLocked);
    put(object, "no_draw", of.noDraw);
    object.update(overridesOf(of));
    if (of.destination)
        object["destination"] = jsonOf(*of.destination);
    return object;
}

Failure absent(const std::string& id) {
    return fail(ErrorCode::NotFound, id,
                "no object and no template has this id; list the objects with limen world list");
}

Result<Json> describeTemplate(const placements::WorldDb& database, std::uint32_t number,
                              const std::string& id) {
    const Result<std::optional<Template>> of = database.findTemplate(number);
    if (!of)
        return Failure(of.error());
    if (!*of)
        return absent(id);
    return jsonOf(**of);
}

Result<Json> describe(const placements::WorldDb& database, const std::string& id) {
    const bool isGuid = id.starts_with("0x") || id.starts_with("0X");
    const std::optional<std::uint32_t> number =
        numberOf(std::string_view(id).substr(isGuid ? 2 : 0), isGuid ? 16 : 10);
    if (!number)
        return absent(id);
    if (!isGuid)
        return describeTemplate(database, *number, id);
    const Result<std::optional<placements::Placement>> placement = database.findPlacement(*number);
    if (!placement)
        return Failure(placement.error());
    if (!*placement)
        return absent(id);
    const placements::Placement& found = **placement;
    Json object{{"guid", fmt::format("0x{:08X}", found.guid)},
                {"at", jsonOf(found.spot)},
                {"is_link_child", found.isLinkChild}};
    const Result<Json> of = describeTemplate(database, found.templateId, id);
    object["template"] = of ? *of : Json(found.templateId);
    return object;
}

} // namespace

Result<std::vector<PlacedLine>> listPlaced(const PlacedWorld& world, const PlacedFilter& filter) {
    Result<std::vector<PlacedLine>> lines =
        world.database != nullptr ? linesOf(*world.database, filter) : linesOf(*world.file, filter);
    if (lines && filter.limit != 0 && lines->size() > filter.limit)
        lines->resize(filter.limit);
    return lines;
}

Result<Json> describePlaced(const PlacedWorld& world, const std::string& id) {
    if (world.database != nullptr)
        return describe(*world.database, id);
    for (const PlacedLine& line : linesOf(*world.file, {}))
        if (line.id == id)
            return Json{{"name", line.name},
                        {"type", line.type},
                        {"model", line.origin},
                        {"cell", line.cell == 0 ? "outside" : dat::idText(line.cell)},
                        {"position", {line.position.x, line.position.y, line.position.z}}};
    return absent(id);
}

} // namespace limen::cli
