#pragma once

#include "engine/placed/PlacedObjects.h"
#include "viewer/pages/PageChoice.h"
#include "viewer/pages/Ui.h"
#include "viewer/scale/PictureScale.h"
#include "world/Places.h"

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace limen::viewer {

/// Progress of a world that is loading.
struct LoadingFacts {
    std::string step;                       ///< e.g. "reading landblocks"
    std::size_t searched = 0, toSearch = 0; ///< steps of the search for places; 0: none
    std::size_t blocksRead = 0, blocks = 0;
    double uploaded = 0.0; ///< share of the upload, 0..1
    double seconds = 0.0;  ///< since loading began
};

/// Letters from which a text is searched among placed objects. Fewer match so many that the search is felt.
inline constexpr std::size_t kLeastSearched = 3;

/// The input of all pages for one frame. Plain data; pages do not see the session.
struct PagesFacts {
    const PageState& state;
    const Settings& settings;
    const KeyBindings& bindings;
    const std::optional<Rebinding>& rebinding;
    const LoadingFacts& loading;
    std::span<const std::filesystem::path> gameDirectories; ///< found on this computer
    std::span<const world::Place> places;                   ///< of the shown world
    std::span<const engine::FoundObject> objects;           ///< found by the last search of this page
    bool hasObjects = false;                                ///< the world has a world.db
    Vec3 eye{0.0};                                          ///< global, metres
    std::string worldName;                                  ///< of the shown world; empty: none
    std::string version, driver, fontNote;                  ///< for the About page
    const ScaleFacts& scale;
    double uiScale = 1.0; ///< size of letters in use, 0.5..4: the command line's or that of the settings
    bool hasGamepad = false;
};

class OpenPage;

/// Draws the current page. Holds the pages' own state: a half-typed path, a filter.
class Pages {
public:
    Pages();
    ~Pages();
    [[nodiscard]] PageChoice draw(Ui& ui, const PagesFacts& facts);

private:
    std::unique_ptr<OpenPage> open_;
    std::string placesFilter_;
    std::optional<double> draggedUiScale_; ///< of the slider that is held
    Page last_ = Page::World;
};

// One function for each page, in a file of its own. `dragged`: the size of letters while its slider is held.
[[nodiscard]] PageChoice drawMenu(Ui& ui, const PagesFacts& facts);
[[nodiscard]] PageChoice drawLoading(Ui& ui, const PagesFacts& facts);
[[nodiscard]] PageChoice drawPlaces(Ui& ui, const PagesFacts& facts, std::string& filter);
[[nodiscard]] PageChoice drawGraphics(Ui& ui, const PagesFacts& facts, std::optional<double>& dragged);
[[nodiscard]] PageChoice drawControls(Ui& ui, const PagesFacts& facts);
[[nodiscard]] PageChoice drawAbout(Ui& ui, const PagesFacts& facts);

} // namespace limen::viewer
