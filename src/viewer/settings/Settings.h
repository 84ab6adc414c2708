#pragma once

#include "core/Error.h"
#include "dat/Ids.h"
#include "geometry/Vec.h"
#include "viewer/scale/ScaleWish.h"
#include "world/Look.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

// The user's settings: limen/settings.json in the configuration directory (docs/manual/settings.md).
namespace limen::viewer {

enum class MouseMode : std::uint8_t {
    Capture, ///< a click captures the mouse; Escape and Tab release it
    Drag     ///< the view turns while a button is held
};

/// A viewpoint in one world. The world's directory is its key; empty: the built-in world.
struct LastPlace {
    std::string name;       ///< of the nearest place in the world's list; may be empty
    Vec3 eye{0.0};          ///< global, metres
    double yaw = 0.0;       ///< degrees
    double pitch = 0.0;     ///< degrees
    dat::RecordId cell = 0; ///< the cell that contains the eye; 0: outside
    friend bool operator==(const LastPlace&, const LastPlace&) = default;
};

struct Settings {
    static constexpr std::size_t kMostRecent = 8;
    std::vector<std::string> recent; ///< directories of worlds, the latest first
    std::map<std::string, LastPlace> lastPlaces;
    std::string quality; ///< a name of engine::kQualities; empty: the program's own choice
    world::Look look = world::Look::Retail;
    ScaleWish scale;      ///< of the 3-D picture
    double uiScale = 1.0; ///< 0.5..4, on top of the screen's own scale
    MouseMode mouse = MouseMode::Capture;
    double sensitivity = 1.0;   ///< 0.1..5, factor on the turn per pixel
    bool invertY = false;       ///< mouse and stick: pushing away looks down
    double fieldOfView = 60.0;  ///< vertical, 30..110 degrees
    std::uint32_t width = 1280; ///< of the window, pixels
    std::uint32_t height = 720;
    bool isFullScreen = false;
    friend bool operator==(const Settings&, const Settings&) = default;
};

/// Settings and their file's text. Keys of the file that this program does not know are kept.
struct SettingsFile {
    Settings settings;
    std::string text;               ///< of the file, a JSON object; empty: there is no file
    std::vector<std::string> notes; ///< values that were ignored, each with the reason
};

/// Reads the text of a settings file. A value that is not valid keeps its default, with a note. Errors: the
/// text is not a JSON object.
[[nodiscard]] Result<SettingsFile> parseSettings(const std::string& text);
/// The text to write: the file's text with the values of `settings` replaced.
[[nodiscard]] std::string settingsText(const Settings& settings, const std::string& fileText);

/// $XDG_CONFIG_HOME/limen/settings.json, or ~/.config/limen/settings.json; empty if neither is known.
[[nodiscard]] std::filesystem::path settingsPath();
/// Reads the file. A missing file gives the defaults. A file that is not a JSON object is renamed to
/// settings.json.bad, with a note.
[[nodiscard]] SettingsFile readSettings(const std::filesystem::path& file);
/// Replaces the file in one step, and makes its directory. Keys that another window has added stay. Errors: an
/// empty path; a file that cannot be written.
[[nodiscard]] Result<void> writeSettings(const std::filesystem::path& file, const Settings& settings);

/// Puts a world at the head of the recent ones.
void addRecent(Settings& settings, const std::string& directory);

} // namespace limen::viewer
