#include "world/Places.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace limen::world {
namespace {

using Json = nlohmann::json;

/// Larger files are something else.
constexpr std::uintmax_t kMostBytes = 16u << 20;

Result<std::string> readText(const std::filesystem::path& path) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > kMostBytes)
        return fail(ErrorCode::Unreadable, path.string(),
                    error ? "cannot be read" : "is too large for a world file");
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf()))
        return fail(ErrorCode::Unreadable, path.string(), "cannot be read");
    return text.str();
}

/// Reads a finite number; absent is fine and leaves `out` alone.
bool readNumber(const Json& object, const char* key, double& out) {
    const auto found = object.find(key);
    if (found == object.end())
        return true;
    if (!found->is_number())
        return false;
    out = found->get<double>();
    return std::isfinite(out);
}

/// A cell id: a number, or text such as "0x20300100"; "" and "outside" are the outside.
bool readCell(const Json& object, dat::RecordId& out) {
    const auto found = object.find("cell");
    if (found == object.end() || found->is_null())
        return true;
    if (found->is_number_unsigned()) {
        out = static_cast<dat::RecordId>(found->get<std::uint64_t>());
        return found->get<std::uint64_t>() <= 0xFFFFFFFFu;
    }
    if (!found->is_string())
        return false;
    const std::string text = found->get<std::string>();
    if (text.empty() || text == "outside")
        return true;
    char* end = nullptr;
    const unsigned long long value = std::strtoull(text.c_str(), &end, 0);
    out = static_cast<dat::RecordId>(value);
    return *end == '\0' && value <= 0xFFFFFFFFu;
}

/// A position, as "eye": [x, y, z] or as x, y, z of the object itself.
bool readEye(const Json& object, Vec3& out) {
    const auto found = object.find("eye");
    if (found == object.end())
        return object.contains("x") && object.contains("y") && object.contains("z") &&
               readNumber(object, "x", out.x) && readNumber(object, "y", out.y) &&
               readNumber(object, "z", out.z);
    if (!found->is_array() || found->size() != 3)
        return false;
    for (int axis = 0; axis < 3; ++axis) {
        const Json& value = (*found)[static_cast<std::size_t>(axis)];
        if (!value.is_number() || !std::isfinite(value.get<double>()))
            return false;
        out[axis] = value.get<double>();
    }
    return true;
}

bool readPlace(const Json& object, Place& out) {
    return object.is_object() && readEye(object, out.eye) && readNumber(object, "yaw", out.yaw) &&
           readNumber(object, "pitch", out.pitch) && readCell(object, out.cell);
}

} // namespace

Result<WorldFile> loadWorldFile(const std::filesystem::path& directory) {
    WorldFile world;
    const std::filesystem::path path = directory / "world.json";
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        return world;
    const Result<std::string> text = readText(path);
    if (!text)
        return tl::unexpected(text.error());
    const Json json = Json::parse(*text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed, path.string(), "is not a JSON object");
    if (const auto places = json.find("places"); places != json.end()) {
        if (!places->is_object())
            return fail(ErrorCode::Malformed, path.string(), "\"places\" must be an object of named places");
        for (const auto& [name, value] : places->items()) {
            Place place;
            place.name = name;
            if (!readPlace(value, place))
                return fail(ErrorCode::Malformed, path.string(),
                            "place \"" + name +
                                "\" needs \"eye\": [x, y, z] and may have yaw, pitch and cell");
            world.places.push_back(std::move(place));
        }
    }
    if (const auto tour = json.find("tour"); tour != json.end()) {
        if (!tour->is_array())
            return fail(ErrorCode::Malformed, path.string(), "\"tour\" must be an array of way points");
        for (const Json& value : *tour) {
            Place place;
            if (!readPlace(value, place))
                return fail(ErrorCode::Malformed, path.string(),
                            "way point " + std::to_string(world.tour.size()) +
                                " of the tour needs x, y and z");
            world.tour.push_back(std::move(place));
        }
    }
    return world;
}

} // namespace limen::world
