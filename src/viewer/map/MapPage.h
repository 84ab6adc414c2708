#pragma once

#include "engine/map/MapInBackground.h"
#include "engine/map/MarksInBackground.h"
#include "engine/map/PlacesOnMap.h"
#include "viewer/map/MapTexture.h"
#include "viewer/map/MapView.h"
#include "viewer/pages/Ui.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limen::viewer {

/// The input of the map page for one frame.
struct MapFacts {
    std::shared_ptr<const engine::WorldSource> source; ///< of the shown world
    Vec3 eye{0.0};                                     ///< global metres
    double yaw = 0.0;                                  ///< degrees, 0 north
    std::vector<dat::BlockCoord> loaded;               ///< landblocks with their interiors in memory
};

/// The user's choice on the map page: at most one destination.
struct MapChoice {
    std::optional<Vec2> point;        ///< go to the ground here, global metres
    std::optional<std::size_t> place; ///< go to this place: index of the world's places
    bool isBack = false;              ///< leave the page
};

/// The page with the map: the landscape from above with its places, the eye and the loaded landblocks. Wheel
/// zooms, drag moves, a click goes there. Paints the map on a thread, when it is first shown.
class MapPage {
public:
    /// Draws the page over the whole window, inside a Dear ImGui frame. `isNew`: the page was not shown in the
    /// last frame; the view then starts around the eye.
    [[nodiscard]] MapChoice draw(Ui& ui, const MapFacts& facts, bool isNew);

    /// For `--tell`: the view, the text under the cursor, whether all blocks and marks are shown.
    [[nodiscard]] const MapView& view() const { return view_; }
    [[nodiscard]] const ScreenBox& box() const { return box_; }
    [[nodiscard]] const std::string& pointed() const { return pointed_; }
    [[nodiscard]] bool isPainted() const {
        return work_ != nullptr && work_->isDone() && reading_ == nullptr && isFitted_;
    }

private:
    void takeMap(const MapFacts& facts);
    void drawMap(Ui& ui, const MapFacts& facts, MapChoice& choice);
    void drawMarks(const MapFacts& facts);
    /// Begins to read the marks of the world.
    void beginMarks();
    /// Takes them when they are read.
    void takeMarks();
    void drawObjects();
    void drawSwitches(Ui& ui);
    void drawPlaceNames(std::span<const world::Place> places);
    void drawSide(Ui& ui, std::span<const world::Place> places, MapChoice& choice);
    void drawList(Ui& ui, const char* heading, std::span<const world::Place> places, bool ofDungeons,
                  MapChoice& choice);
    void takeMouse(MapChoice& choice);

    std::shared_ptr<const engine::WorldSource> source_; ///< of `work_`
    std::unique_ptr<engine::MapInBackground> work_;
    std::shared_ptr<const engine::LandscapeMap> map_; ///< null: nothing painted yet
    /// Placed objects of one kind. Only their points along the ground, so those indoors are marked, too.
    struct Marks {
        std::vector<Vec2> points; ///< global metres
        bool isShown = true;
    };
    static constexpr std::size_t kMarkKindCount = 3;
    std::array<Marks, kMarkKindCount> marks_;            ///< portals, lifestones, doors
    std::unique_ptr<engine::MarksInBackground> reading_; ///< null: all are read
    std::vector<engine::PlaceOnMap> places_;
    std::uint64_t revision_ = 0;
    MapTexture texture_;
    MapView view_;
    ScreenBox box_;
    bool isFitted_ = false; ///< the view belongs to this map
    double dragged_ = 0.0;  ///< units since the button was pressed
    std::array<char, 64> search_{};
    std::string pointed_, note_;
};

} // namespace limen::viewer
