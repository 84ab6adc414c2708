#pragma once

#include "viewer/Recording.h"
#include "viewer/WorldView.h"
#include "viewer/map/MapPage.h"
#include "viewer/open/WorldOpening.h"
#include "viewer/pages/Pages.h"
#include "viewer/photo/PhotoView.h"

#include <memory>
#include <utility>

namespace limen::viewer {

/// The key bindings and their file.
struct ViewerKeys {
    KeyBindings bindings;
    std::filesystem::path file; ///< empty: no configuration directory
};

struct ApplicationOptions {
    engine::SessionOptions session; ///< of every world that is opened; its directory is not used
    bool isQualityFixed =
        false; ///< the command line chose quality options: those of the settings do not apply
    /// The first view of the first world, by the command line. Unset, and in later worlds: the last place there,
    /// else the world's first place.
    std::function<Result<engine::ViewRequest>(const engine::WorldSource&)> start;
    engine::ViewRequest view; ///< size, time and weather of views that `start` does not make
    bool flies = false, isChased = false;
    bool isFovFixed = false;       ///< the command line chose the field of view
    bool isLookFixed = false;      ///< the command line chose the look
    double step = 0.0;             ///< seconds of a frame; 0: measured
    std::optional<double> uiScale; ///< of the command line; none: that of the settings
    /// Scale and frame rate of the command line; none: those of the settings.
    std::optional<std::uint32_t> scale;
    std::optional<double> frameRate;
    ViewerKeys keys;
    std::filesystem::path screenshots;  ///< directory of pictures
    std::filesystem::path record;       ///< file of the recorded walk; empty: none
    std::filesystem::path settingsFile; ///< empty: settings are not written
    SettingsFile settings;
    std::string version;                                ///< of the program
    std::vector<std::filesystem::path> gameDirectories; ///< found on this computer
};

/// The program in the window: pages, settings, and a world that can be replaced while it runs.
class Application {
public:
    /// Window and device must outlive it.
    Application(Window& window, gpu::GlDevice& device, ApplicationOptions options);
    ~Application();

    /// Begins to open a world; empty: the built-in one. The world on the screen stays until the new one is
    /// ready.
    void open(const std::string& directory);
    /// Waits until the world is open. For scripts. Errors: it did not open.
    [[nodiscard]] Result<void> finishOpening();

    /// Runs one frame: events, world, pages. Errors: the driver's; the frame loop must end.
    [[nodiscard]] Result<void> frame();
    /// Waits for window events while the window is hidden. Draws nothing and stops the world's time.
    void rest();
    [[nodiscard]] bool isLeaving() const { return pages_.quits || window_.wantsToClose(); }

    /// Saves the recorded walk and the settings. Needs no display. Errors: a file that cannot be
    /// written; the others are saved all the same.
    [[nodiscard]] Result<void> save();

    /// Lines for a person on the terminal since the last call: saved files, faults of settings.
    [[nodiscard]] std::vector<std::string> takeNotes() { return std::exchange(notes_, {}); }

    [[nodiscard]] const WorldView* world() const { return world_.get(); }
    [[nodiscard]] WorldView* world() { return world_.get(); }
    [[nodiscard]] const PageState& pages() const { return pages_; }
    [[nodiscard]] const std::string& directory() const { return directory_; }
    [[nodiscard]] LoadingFacts loading() const { return opening_ ? opening_->facts() : LoadingFacts{}; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] const KeyBindings& bindings() const { return keys_.bindings; }
    [[nodiscard]] const std::optional<Rebinding>& rebinding() const { return rebinding_; }
    [[nodiscard]] const Ui& ui() const { return ui_; }
    [[nodiscard]] const ScaleFacts& scale() const { return scale_.facts(); }
    [[nodiscard]] double uiScale() const { return overlay_.scale(); }
    [[nodiscard]] double hint() const { return hintOpacity_; }
    [[nodiscard]] bool isCaptured() const { return window_.isCaptured(); }
    [[nodiscard]] const MapPage& map() const { return map_; }
    [[nodiscard]] const PhotoView* photo() const { return photo_.get(); }
    [[nodiscard]] const Recording& recording() const { return recording_; }
    [[nodiscard]] engine::PixelSize size() const { return window_.size(); }
    /// The notice shown over the picture; empty: none.
    [[nodiscard]] std::string noticeText() const;

private:
    void takeSettings();
    [[nodiscard]] Result<engine::ViewRequest> startIn(const engine::WorldSource& source,
                                                      const std::optional<LastPlace>& last) const;
    [[nodiscard]] bool isFovFixed() const { return options_.isFovFixed; }
    [[nodiscard]] double uiScaleWanted() const { return options_.uiScale.value_or(settings_.uiScale); }

    [[nodiscard]] ScaleWish scaleWanted() const;

    // Events of a frame.
    void takeKeys();
    void press(Action action);
    void rebind(KeyCode key);
    void keepBindings(KeyBindings bindings);
    void takePointer();
    void go(const PageEvent& event);
    void setCapture(bool isCaptured);
    void keepPicture();

    // Worlds.
    void stepOpening();
    void show(OpenedWorld opened);
    void fail(const std::string& reason);
    void dropOpening();
    void noteLastPlace();
    [[nodiscard]] Result<void> frameWorld();
    [[nodiscard]] Result<void> framePhoto();
    [[nodiscard]] std::uint32_t chooseScale(bool isHeld);
    void present();
    void beginRecording();
    void record();
    void endRecording();

    // The overlay stage.
    void drawOverlay();
    void drawHint();
    void drawMap();
    void drawPhoto();
    void take(const PageChoice& choice);
    void takeNew(const Settings& settings);
    void takeUiScale(double scale);
    /// Shows the world in the look of the settings. Requires a world.
    void showLook();
    void takeScale(const ScaleWish& wish);
    void searchObjects(const std::string& text);
    void keepSettings();
    void notice(std::string text);

    Window& window_;
    gpu::GlDevice& device_;
    ApplicationOptions options_;
    Overlay overlay_;
    Pages drawnPages_;
    Ui ui_;
    PageState pages_;
    Settings settings_;
    ViewerKeys keys_;
    std::optional<Rebinding> rebinding_; ///< set while waiting for a key
    std::unique_ptr<WorldView> world_;
    std::vector<engine::FoundObject> objects_; ///< the result of the last search
    MapPage map_;
    bool isMapShown_ = false;
    PictureScale scale_;
    std::unique_ptr<PhotoView> photo_; ///< in photo mode; refers to world_
    std::string directory_;            ///< of world_
    std::unique_ptr<WorldOpening> opening_;
    std::vector<std::unique_ptr<WorldOpening>> cancelled_; ///< whose threads have not ended yet
    bool isFirstWorld_ = true;
    bool capturesAgain_ = false; ///< the mouse was captured before a page was opened
    bool wantsPicture_ = false, hasSaveFailed_ = false;
    Recording recording_;
    std::optional<Error> recordError_;
    struct Notice {
        std::string text;
        double until = 0.0; ///< as Window::seconds
    };
    Notice notice_;
    std::vector<std::string> notes_;
    double lastSeconds_ = 0.0, frameSeconds_ = 0.0;
    double hintSeconds_ = 0.0, hintOpacity_ = 0.0;
};

} // namespace limen::viewer
