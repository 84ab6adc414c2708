#pragma once

#include "engine/LoadedPart.h"
#include "frame/FrameView.h"
#include "world/DynamicState.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace limen::bench {

inline constexpr const char* kPlainWay = "plain"; ///< name of the plain renderer's way
inline constexpr const char* kPeerWay = "peer";   ///< name of the scene graph's way

/// A view to draw: its part of the world, and the dynamic state that all ways share.
struct FramePlace {
    std::shared_ptr<const engine::LoadedPart> part;
    frame::FrameView view;
    world::DynamicState dynamics;
};

/// A finished frame, top row first.
struct FramePicture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< alpha 255
    std::vector<float> depth;       ///< near plane / view depth; 0: no surface
};

/// One of the ways of drawing that `limen bench frame` compares. Each has an OpenGL context of its own or
/// shares one; `enter` precedes all other calls after another way was used. The way's name is that of its
/// column.
class FrameWay {
public:
    explicit FrameWay(std::string name) : name_(std::move(name)) {}
    FrameWay(const FrameWay&) = delete;
    FrameWay& operator=(const FrameWay&) = delete;
    virtual ~FrameWay() = default;

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Makes the way's context current. Errors: Driver.
    [[nodiscard]] virtual Result<void> enter() = 0;
    /// Uploads a place. It must stay where it is until the next one is shown. Errors: Driver; the renderer's.
    [[nodiscard]] virtual Result<void> show(const FramePlace& place) = 0;
    /// Draws the place, and returns when the rasteriser is done. Errors: the renderer's.
    [[nodiscard]] virtual Result<void> draw() = 0;
    /// The last frame.
    [[nodiscard]] virtual FramePicture read() = 0;

private:
    std::string name_;
};

} // namespace limen::bench
