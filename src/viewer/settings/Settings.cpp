#include "viewer/settings/Settings.h"

#include "engine/Quality.h"
#include "engine/UserFiles.h"
#include "output/OutputFile.h"
#include "viewer/KeyBindings.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace limen::viewer {
namespace {

namespace fs = std::filesystem;
using SettingsJson = nlohmann::ordered_json;

constexpr const char* kAutomatic = "auto";

/// Reads values of one JSON object. A value that is not valid is noted and left out.
class SettingsReader {
public:
    SettingsReader(const SettingsJson& json, std::vector<std::string>& notes) : json_(json), notes_(notes) {}

    void number(const char* key, double least, double most, double& value) const {
        const SettingsJson* found = find(key);
        if (found == nullptr)
            return;
        const double read = found->is_number() ? found->get<double>() : std::nan("");
        if (read >= least && read <= most)
            value = read;
        else
            ignore(key, fmt::format("a number from {} to {}", least, most));
    }
    void flag(const char* key, bool& value) const {
        const SettingsJson* found = find(key);
        if (found != nullptr && found->is_boolean())
            value = found->get<bool>();
        else if (found != nullptr)
            ignore(key, "true or false");
    }
    /// `isValid` decides about a text.
    template <class Valid>
    void text(const char* key, const char* expected, Valid&& isValid, std::string& value) const {
        const SettingsJson* found = find(key);
        if (found == nullptr)
            return;
        const std::string read = found->is_string() ? found->get<std::string>() : std::string();
        if (found->is_string() && isValid(read))
            value = read;
        else
            ignore(key, expected);
    }
    /// A number, or the text "auto" for 0.
    void automatic(const char* key, double least, double most, double& value) const {
        const SettingsJson* found = find(key);
        if (found == nullptr)
            return;
        const double read = found->is_number() ? found->get<double>() : std::nan("");
        if (*found == kAutomatic)
            value = 0.0;
        else if (read >= least && read <= most)
            value = read;
        else
            ignore(key, fmt::format("{} or a number from {} to {}", kAutomatic, least, most));
    }
    /// The object or list of a key; null if it is missing or of another type.
    [[nodiscard]] const SettingsJson* part(const char* key, bool isList) const {
        const SettingsJson* found = find(key);
        if (found == nullptr || (isList ? found->is_array() : found->is_object()))
            return found;
        ignore(key, isList ? "a list" : "an object");
        return nullptr;
    }

private:
    [[nodiscard]] const SettingsJson* find(const char* key) const {
        const auto found = json_.find(key);
        return found == json_.end() ? nullptr : &*found;
    }
    void ignore(const char* key, std::string_view expected) const {
        notes_.push_back(fmt::format("{}: ignored; expected {}", key, expected));
    }

    const SettingsJson& json_;
    std::vector<std::string>& notes_;
};

constexpr double kFarthest = 1e7;                              // metres; beyond the largest map
constexpr double kMostCell = 4294967295.0;                     // a record id
constexpr double kSmallestSide = 64.0, kLargestSide = 16384.0; // pixels

LastPlace lastPlaceIn(const SettingsJson& json, std::vector<std::string>& notes) {
    LastPlace place;
    const SettingsReader reader(json, notes);
    double cell = 0.0;
    reader.text(
        "name", "a text", [](const std::string&) { return true; }, place.name);
    reader.number("x", -kFarthest, kFarthest, place.eye.x);
    reader.number("y", -kFarthest, kFarthest, place.eye.y);
    reader.number("z", -kFarthest, kFarthest, place.eye.z);
    reader.number("yaw", -1e6, 1e6, place.yaw);
    reader.number("pitch", -90.0, 90.0, place.pitch);
    reader.number("cell", 0.0, kMostCell, cell);
    place.cell = static_cast<dat::RecordId>(cell);
    return place;
}

void readWorlds(const SettingsReader& reader, Settings& settings, std::vector<std::string>& notes) {
    if (const SettingsJson* recent = reader.part("recent", true))
        for (const SettingsJson& item : *recent)
            if (item.is_string() && settings.recent.size() < Settings::kMostRecent)
                settings.recent.push_back(item.get<std::string>());
    if (const SettingsJson* places = reader.part("last_places", false))
        for (const auto& [world, place] : places->items())
            if (place.is_object())
                settings.lastPlaces[world] = lastPlaceIn(place, notes);
}

void readWindow(const SettingsJson& json, Settings& settings, std::vector<std::string>& notes) {
    double width = settings.width, height = settings.height;
    const SettingsReader reader(json, notes);
    reader.number("width", kSmallestSide, kLargestSide, width);
    reader.number("height", kSmallestSide, kLargestSide, height);
    reader.flag("full_screen", settings.isFullScreen);
    settings.width = static_cast<std::uint32_t>(width);
    settings.height = static_cast<std::uint32_t>(height);
}

void readScale(const SettingsReader& reader, ScaleWish& wish) {
    double percent = wish.percent;
    reader.automatic("scale", kLeastScale, kFullScale, percent);
    reader.automatic("frame_rate", kLeastRate, kMostRate, wish.frameRate);
    wish.percent = static_cast<std::uint32_t>(percent);
}

SettingsJson placeJson(const LastPlace& place) {
    return {{"name", place.name}, {"x", place.eye.x},     {"y", place.eye.y},  {"z", place.eye.z},
            {"yaw", place.yaw},   {"pitch", place.pitch}, {"cell", place.cell}};
}

std::string dumped(const SettingsJson& json) {
    // Paths can hold any bytes: invalid UTF-8 is replaced.
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// The text of the file; empty if it cannot be read.
std::string textOf(const fs::path& file) {
    constexpr std::size_t kLongest = 1u << 20; // bytes
    return output::readTextFile(file, kLongest).value_or("");
}

} // namespace

Result<SettingsFile> parseSettings(const std::string& text) {
    const SettingsJson json = SettingsJson::parse(text, nullptr, false);
    if (!json.is_object())
        return fail(ErrorCode::Malformed, "settings", "is not a JSON object");
    SettingsFile file{{}, text, {}};
    Settings& settings = file.settings;
    const SettingsReader reader(json, file.notes);
    readWorlds(reader, settings, file.notes);
    reader.text(
        "quality", "low, medium, high, ultra or an empty text",
        [](const std::string& name) { return name.empty() || engine::qualityNamed(name).has_value(); },
        settings.quality);
    std::string look(world::nameOf(settings.look));
    reader.text(
        "look", "retail or enhanced",
        [](const std::string& name) { return world::lookNamed(name).has_value(); }, look);
    settings.look = *world::lookNamed(look);
    readScale(reader, settings.scale);
    reader.number("ui_scale", 0.5, 4.0, settings.uiScale);
    std::string mouse = "capture";
    reader.text(
        "mouse", "capture or drag",
        [](const std::string& name) { return name == "capture" || name == "drag"; }, mouse);
    settings.mouse = mouse == "drag" ? MouseMode::Drag : MouseMode::Capture;
    reader.number("mouse_sensitivity", 0.1, 5.0, settings.sensitivity);
    reader.flag("invert_y", settings.invertY);
    reader.number("field_of_view", 30.0, 110.0, settings.fieldOfView);
    if (const SettingsJson* window = reader.part("window", false))
        readWindow(*window, settings, file.notes);
    return file;
}

std::string settingsText(const Settings& settings, const std::string& fileText) {
    SettingsJson json = SettingsJson::parse(fileText, nullptr, false);
    if (!json.is_object())
        json = SettingsJson::object();
    json["recent"] = settings.recent;
    SettingsJson& places = json["last_places"];
    if (!places.is_object())
        places = SettingsJson::object();
    for (const auto& [world, place] : settings.lastPlaces)
        places[world] = placeJson(place);
    json["quality"] = settings.quality;
    json["look"] = world::nameOf(settings.look);
    json["scale"] =
        settings.scale.percent == 0 ? SettingsJson(kAutomatic) : SettingsJson(settings.scale.percent);
    json["frame_rate"] =
        settings.scale.frameRate == 0.0 ? SettingsJson(kAutomatic) : SettingsJson(settings.scale.frameRate);
    json["ui_scale"] = settings.uiScale;
    json["mouse"] = settings.mouse == MouseMode::Drag ? "drag" : "capture";
    json["mouse_sensitivity"] = settings.sensitivity;
    json["invert_y"] = settings.invertY;
    json["field_of_view"] = settings.fieldOfView;
    SettingsJson& window = json["window"];
    if (!window.is_object())
        window = SettingsJson::object();
    window["width"] = settings.width;
    window["height"] = settings.height;
    window["full_screen"] = settings.isFullScreen;
    return dumped(json);
}

fs::path settingsPath() {
    const fs::path keys = keysPath();
    return keys.empty() ? fs::path() : keys.parent_path() / "settings.json";
}

SettingsFile readSettings(const fs::path& file) {
    std::error_code error;
    if (file.empty() || !fs::exists(file, error))
        return {};
    Result<SettingsFile> read = parseSettings(textOf(file));
    if (read)
        return std::move(*read);
    fs::path bad = file;
    bad += ".bad";
    fs::rename(file, bad, error);
    SettingsFile fresh;
    fresh.notes.push_back(fmt::format("{} is not a JSON object; the defaults apply, and the file {}",
                                      file.string(), error ? "stays" : "is kept as " + bad.string()));
    return fresh;
}

Result<void> writeSettings(const fs::path& file, const Settings& settings) {
    if (file.empty())
        return fail(ErrorCode::Unreadable, "settings",
                    fmt::format("no configuration directory to save them in; set {}",
                                engine::userDirectoryNames().configuration));
    if (Result<void> made = output::makeDirectory(file.parent_path()); !made)
        return made;
    return output::writeFile(file, std::string_view(settingsText(settings, textOf(file))));
}

void addRecent(Settings& settings, const std::string& directory) {
    std::erase(settings.recent, directory);
    settings.recent.insert(settings.recent.begin(), directory);
    if (settings.recent.size() > Settings::kMostRecent)
        settings.recent.resize(Settings::kMostRecent);
}

} // namespace limen::viewer
