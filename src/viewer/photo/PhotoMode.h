#pragma once

#include "engine/FrameRequest.h"
#include "play/PlayInput.h"
#include "play/RootTracker.h"

#include <array>
#include <string_view>

namespace limen::viewer {

/// A size of pictures. {0, 0}: that of the window.
struct PhotoSize {
    std::string_view name;
    engine::PixelSize pixels;
};
inline constexpr std::array<PhotoSize, 5> kPhotoSizes{{{"as the window", {0, 0}},
                                                       {"1920 x 1080", {1920, 1080}},
                                                       {"3840 x 2160", {3840, 2160}},
                                                       {"8192 x 4608", {8192, 4608}},
                                                       {"8192 x 8192", {8192, 8192}}}};

/// The settings of photo mode. They change the picture, not the world.
struct PhotoSettings {
    static constexpr double kLeastFov = 10.0, kMostFov = 120.0;
    double time = 0.5;          ///< fraction of the day
    std::uint32_t dayGroup = 0; ///< index of the Region's day groups
    engine::Weather weather = engine::Weather::Clear;
    double fov = 60.0;             ///< vertical, degrees
    std::size_t size = 0;          ///< of kPhotoSizes
    std::uint32_t supersample = 1; ///< samples along a pixel's side
    bool showsBody = false;        ///< the player's body, if there is one
    friend bool operator==(const PhotoSettings&, const PhotoSettings&) = default;
};

/// Photo mode: a camera that flies freely in the world as it was when the mode began. The world's time stands
/// still, and nothing of the player's state changes.
class PhotoMode {
public:
    /// `world`: the frame on the screen. The part of the world must stay the same while the mode lasts.
    explicit PhotoMode(const engine::FrameRequest& world);

    [[nodiscard]] const PhotoSettings& settings() const { return settings_; }
    void set(const PhotoSettings& settings);
    /// Flies and turns the camera: FlyCamera's rules. Acts are ignored.
    void move(const world::World& world, const play::PlayInput& input);

    /// The size of the picture to take. `window`: pixels.
    [[nodiscard]] engine::PixelSize sizeIn(engine::PixelSize window) const;
    /// The frame for the window. It shows the whole picture: the window's field of view is wider where the
    /// shapes differ.
    [[nodiscard]] engine::FrameRequest preview(engine::PixelSize window) const;
    /// The frame of the picture to take.
    [[nodiscard]] engine::FrameRequest picture(engine::PixelSize window) const;

private:
    engine::FrameRequest request_;
    PhotoSettings settings_;
    play::RootTracker tracker_;
};

/// The share of the window, 0..1 each way, that the picture covers in the preview.
[[nodiscard]] Vec2 shownShare(engine::PixelSize picture, engine::PixelSize window);

} // namespace limen::viewer
