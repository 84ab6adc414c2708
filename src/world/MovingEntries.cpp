#include "world/MovingEntries.h"

#include "world/JsonFields.h"

namespace limen::world {
namespace {

using Json = nlohmann::json;

bool read(const Json& object, LeafEntry& out) {
    return readId(object, "model", out.model) && out.model != 0 &&
           readField(object, "position", out.position) && readField(object, "yaw", out.yaw) &&
           readField(object, "swing", out.swing) && readId(object, "motionTable", out.motionTable);
}

bool read(const Json& object, RouteEntry::Point& out) {
    return readField(object, "position", out.position) && readId(object, "cell", out.cell);
}

/// Reads a list of entries; true if it is absent.
template <class Entry>
bool readList(const Json& object, const char* key, std::vector<Entry>& out);

bool read(const Json& object, DoorEntry& out) {
    return readField(object, "name", out.name) && readId(object, "cell", out.cell) && out.cell != 0 &&
           readField(object, "portal", out.portal) && readField(object, "opaque", out.opaque) &&
           readField(object, "open", out.open) && out.open >= 0.0 && out.open <= 1.0 &&
           readList(object, "leaves", out.leaves);
}

bool read(const Json& object, RouteEntry& out) {
    return readField(object, "name", out.name) && readField(object, "loop", out.loop) &&
           readList(object, "points", out.points) && out.points.size() >= 2;
}

bool read(const Json& object, PlayEntry& out) {
    return readField(object, "kind", out.kind) && out.kind != 0 &&
           readField(object, "intensity", out.intensity);
}

/// Reads an object within another; true if it is absent.
template <class Entry>
bool readWithin(const Json& object, const char* key, Entry& out) {
    const auto found = object.find(key);
    return found == object.end() || (found->is_object() && read(*found, out));
}

/// A number, or an array of one to four.
bool readShades(const Json& object, std::vector<double>& out) {
    constexpr std::size_t kMostShades = 4;
    const auto found = object.find("shade");
    if (found == object.end())
        return true;
    const Json list = found->is_array() ? *found : Json::array({*found});
    if (list.empty() || list.size() > kMostShades)
        return false;
    out.clear();
    for (const Json& shade : list) {
        if (!shade.is_number())
            return false;
        out.push_back(shade.get<double>());
    }
    return true;
}

bool read(const Json& object, ClothingEntry& out) {
    return readId(object, "table", out.table) && out.table != 0 &&
           readField(object, "palette", out.palette) && readShades(object, out.shades);
}

bool read(const Json& object, VillagerEntry& out) {
    return readField(object, "name", out.name) && readField(object, "route", out.route) &&
           readId(object, "model", out.model) && out.model != 0 && readField(object, "speed", out.speed) &&
           readField(object, "start", out.start) && readWithin(object, "play", out.play) &&
           readList(object, "clothing", out.clothing) && readId(object, "basePalette", out.basePalette);
}

bool read(const Json& object, EmitterEntry& out) {
    return readField(object, "name", out.name) && readField(object, "attachedTo", out.attachedTo) &&
           readId(object, "surface", out.surface) && out.surface != 0 && readId(object, "cell", out.cell) &&
           readField(object, "position", out.position) && readField(object, "velocity", out.velocity) &&
           readField(object, "acceleration", out.acceleration) && readField(object, "rate", out.rate) &&
           readField(object, "life", out.life) && readField(object, "spread", out.spread) &&
           readField(object, "radius", out.radius) && readField(object, "size", out.size) &&
           readField(object, "alpha", out.alpha) && readField(object, "seed", out.seed) && out.rate > 0.0 &&
           out.life > 0.0;
}

template <class Entry>
bool readList(const Json& object, const char* key, std::vector<Entry>& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_array())
        return false;
    for (const Json& value : *found) {
        Entry entry;
        if (!value.is_object() || !read(value, entry))
            return false;
        out.push_back(std::move(entry));
    }
    return true;
}

} // namespace

Result<MovingEntries> readMovingEntries(const Json& world, const std::string& file) {
    MovingEntries entries;
    const auto broken = [&](const char* list, std::size_t index) {
        return fail(ErrorCode::Malformed, file,
                    "entry " + std::to_string(index) + " of \"" + list +
                        "\" does not have the form that docs/world-file.md describes");
    };
    if (!readList(world, "doors", entries.doors))
        return broken("doors", entries.doors.size());
    if (!readList(world, "routes", entries.routes))
        return broken("routes", entries.routes.size());
    if (!readList(world, "villagers", entries.villagers))
        return broken("villagers", entries.villagers.size());
    if (!readList(world, "emitters", entries.emitters))
        return broken("emitters", entries.emitters.size());
    if (const auto player = world.find("player"); player != world.end()) {
        if (!player->is_object() || !readId(*player, "model", entries.player) || entries.player == 0)
            return fail(ErrorCode::Malformed, file, "\"player\" has no \"model\"");
        if (!readList(*player, "clothing", entries.playerClothing))
            return broken("clothing", entries.playerClothing.size());
        if (!readId(*player, "basePalette", entries.playerPalette))
            return fail(ErrorCode::Malformed, file,
                        "\"basePalette\" of \"player\" is not the id of a record");
    }
    std::string weather = "clear";
    if (!readField(world, "weather", weather) || (weather != "clear" && weather != "rain"))
        return fail(ErrorCode::Malformed, file, "\"weather\" must be \"clear\" or \"rain\"");
    entries.rain = weather == "rain";
    return entries;
}

} // namespace limen::world
