#include "world/Places.h"

#include "world/JsonFields.h"
#include "world/Lookup.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace limen::world {
namespace {

using Json = nlohmann::json;

/// A larger file is not a world file.
constexpr std::uintmax_t kMostBytes = 16u << 20;

Result<std::string> readText(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kMostBytes)
        return fail(ErrorCode::Unreadable, path.string(),
                    error ? "cannot be read; check its permissions"
                          : "is too large for a world file; remove it");
    std::ifstream file(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
        return fail(ErrorCode::Unreadable, path.string(), "cannot be read; check its permissions");
    return text;
}

/// A position, as "eye": [x, y, z] or as x, y, z of the object itself.
bool readEye(const Json& object, Vec3& out) {
    const auto found = object.find("eye");
    if (found == object.end())
        return object.contains("x") && object.contains("y") && object.contains("z") &&
               readField(object, "x", out.x) && readField(object, "y", out.y) &&
               readField(object, "z", out.z);
    return readField(object, "eye", out);
}

bool readPlace(const Json& object, Place& out) {
    return object.is_object() && readEye(object, out.eye) && readField(object, "yaw", out.yaw) &&
           readField(object, "pitch", out.pitch) && readId(object, "cell", out.cell);
}

bool isPlace(const WorldFile& world, const std::string& name) {
    return std::any_of(world.places.begin(), world.places.end(),
                       [&](const Place& place) { return place.name == name; });
}

dat::BlockCoord blockOfPlace(const Place& place) {
    return place.cell != 0 ? dat::blockOf(place.cell) : blockAt(place.eye);
}

} // namespace

bool isJump(const Place& from, const Place& to) {
    if (from.cell == 0 && to.cell == 0)
        return false;
    const dat::BlockCoord a = blockOfPlace(from), b = blockOfPlace(to);
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) > 1;
}

Result<WorldFile> loadWorldFile(const std::filesystem::path& directory) {
    const std::filesystem::path path = directory / kWorldFileName;
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return WorldFile();
    const Result<std::string> text = readText(path);
    if (!text)
        return Failure(text.error());
    return parseWorldFile(*text, path.string());
}

Result<WorldFile> parseWorldFile(const std::string& text, const std::string& file) {
    WorldFile world;
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed, file,
                    "is not a JSON object; docs/world-file.md describes the form, and without the file the "
                    "world opens, too");
    if (const auto places = json.find("places"); places != json.end()) {
        if (!places->is_object())
            return fail(ErrorCode::Malformed, file, "\"places\" must be an object of named places");
        for (const auto& [name, value] : places->items()) {
            Place place;
            place.name = name;
            if (!readPlace(value, place))
                return fail(ErrorCode::Malformed, file,
                            "place \"" + name +
                                "\" needs \"eye\": [x, y, z] and may have yaw, pitch and cell");
            world.places.push_back(std::move(place));
        }
    }
    if (!readField(json, "start", world.start) || (!world.start.empty() && !isPlace(world, world.start)))
        return fail(ErrorCode::Malformed, file, "\"start\" must be the name of one of its places");
    if (const auto tour = json.find("tour"); tour != json.end()) {
        if (!tour->is_array())
            return fail(ErrorCode::Malformed, file, "\"tour\" must be an array of way points");
        for (const Json& value : *tour) {
            Place place;
            if (!readPlace(value, place))
                return fail(ErrorCode::Malformed, file,
                            "way point " + std::to_string(world.tour.size()) +
                                " of the tour needs x, y and z");
            world.tour.push_back(std::move(place));
        }
    }
    Result<MovingEntries> moving = readMovingEntries(json, file);
    if (!moving)
        return Failure(moving.error());
    world.moving = std::move(*moving);
    return world;
}

} // namespace limen::world
