#include "engine/places/FoundPlaces.h"

#include "core/Hash.h"
#include "core/platform/Process.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

namespace limen::engine {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kSearchVersion = 3;    // raise it when the search finds other places
constexpr std::size_t kMostKept = 8; // results in the cache

/// Header fields, length and time of the files: other files, or the same files changed, have another key.
std::string keyOf(const dat::Archive& archive) {
    std::string text = fmt::format("{}", kSearchVersion);
    for (const dat::File* file : {&archive.portal(), &archive.cell()}) {
        const dat::Header& h = file->header();
        std::error_code error;
        const auto time = fs::last_write_time(file->name(), error).time_since_epoch().count();
        text += fmt::format(" {} {} {} {} {} {} {} {} {}", h.blockSize, h.fileSize, h.type, h.subset, h.root,
                            h.engineVersion, h.gameVersion, h.minorVersion, error ? 0 : time);
    }
    Hash hash;
    for (const char letter : text)
        hash.add(letter);
    return fmt::format("{:016x}", hash.value());
}

json jsonOf(const world::Place& place) {
    return {{"name", place.name},
            {"eye", {place.eye.x, place.eye.y, place.eye.z}},
            {"yaw", place.yaw},
            {"pitch", place.pitch},
            {"cell", place.cell}};
}

std::optional<std::vector<world::Place>> placesIn(const json& list) {
    if (!list.is_array())
        return {};
    std::vector<world::Place> places;
    for (const json& value : list) {
        const auto number = [&](const char* key) {
            return value.contains(key) && value[key].is_number() ? value[key].get<double>() : 0.0;
        };
        if (!value.is_object() || !value.contains("eye") || !value["eye"].is_array() ||
            value["eye"].size() != 3 || !value.contains("name") || !value["name"].is_string())
            return {};
        world::Place place;
        place.name = value["name"].get<std::string>();
        for (int axis = 0; axis < 3; ++axis) {
            const json& part = value["eye"][static_cast<std::size_t>(axis)];
            if (!part.is_number())
                return {};
            place.eye[axis] = part.get<double>();
        }
        place.yaw = number("yaw");
        place.pitch = number("pitch");
        place.cell = static_cast<dat::RecordId>(number("cell"));
        places.push_back(std::move(place));
    }
    return places;
}

std::optional<world::WorldFile> readCached(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return {};
    const json value = json::parse(in, nullptr, false);
    if (!value.is_object() || !value.contains("start") || !value["start"].is_string() ||
        !value.contains("places") || !value.contains("tour"))
        return {};
    auto places = placesIn(value["places"]);
    auto tour = placesIn(value["tour"]);
    if (!places || !tour)
        return {};
    world::WorldFile file;
    file.places = std::move(*places);
    file.tour = std::move(*tour);
    file.start = value["start"].get<std::string>();
    return file;
}

/// Written beside and renamed, so that no process reads half a file. Faults are ignored: it is a cache.
void writeCached(const fs::path& path, const world::WorldFile& file) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    json value{{"start", file.start}, {"places", json::array()}, {"tour", json::array()}};
    for (const world::Place& place : file.places)
        value["places"].push_back(jsonOf(place));
    for (const world::Place& place : file.tour)
        value["tour"].push_back(jsonOf(place));
    const fs::path staging = path.string() + fmt::format(".{}", platform::processId());
    bool isWritten = false;
    {
        std::ofstream out(staging, std::ios::binary);
        out << value.dump(-1, ' ', false, json::error_handler_t::replace);
        isWritten = static_cast<bool>(out.flush());
    }
    if (isWritten)
        fs::rename(staging, path, error);
    fs::remove(staging, error);
}

void removeOldest(const fs::path& directory) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error))
        files.emplace_back(fs::last_write_time(it->path(), error), it->path());
    std::sort(files.begin(), files.end(), std::greater<>());
    for (std::size_t i = kMostKept; i < files.size(); ++i)
        fs::remove(files[i].second, error);
}

} // namespace

Result<world::WorldFile> findPlacesCached(const dat::Archive& archive, const fs::path& root,
                                          std::uint32_t leastBytes, const SearchProgress& progress) {
    if (root.empty() || archive.cell().header().fileSize < leastBytes)
        return findPlaces(archive, progress);
    const fs::path directory = root / "places";
    const fs::path path = directory / (keyOf(archive) + ".json");
    if (std::optional<world::WorldFile> known = readCached(path))
        return std::move(*known);
    Result<world::WorldFile> found = findPlaces(archive, progress);
    if (found) {
        writeCached(path, *found);
        removeOldest(directory);
    }
    archive.letPagesGo(); // the whole index was read
    return found;
}

} // namespace limen::engine
