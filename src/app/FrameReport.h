#pragma once

#include "app/Camera.h"
#include "app/IdTable.h"
#include "frame/FramePlan.h"
#include "gpu/device/Device.h"
#include "motion/DynamicStateBuilder.h"
#include "visibility/VisibleSet.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace limen::app {

/// One stage's work and time. A time that was not measured is NaN and becomes null.
struct StageFigures {
    std::string name;
    std::uint32_t draws = 0;
    double cpuMs = 0.0, gpuMs = 0.0;
};

/// What the wiring knows about a frame beside the rooms' own structs.
struct FrameFigures {
    std::string driver;
    std::string textures; ///< "bindless" or "array pages"
    std::vector<StageFigures> stages;
    std::uint32_t glCalls = 0;
    std::uint32_t ringStalls = 0; ///< frames that waited for the GPU, and times the ring grew, so far
    std::size_t bytesWritten = 0; ///< by the frame
    std::string trouble;          ///< as gpu::FrameReport has it
    gpu::DeviceObjects resident;
    double floodMs = 0.0, planMs = 0.0, submitMs = 0.0, gpuMs = 0.0;
};

/// The eye of a frame and how its root was found.
struct FrameEye {
    Camera camera;
    PixelSize size;
    world::SpaceIndex root = world::kOutside;
    bool rootAmbiguous = false; ///< several cells claim the eye
    Vec3 player{0.0};
    std::optional<motion::PlayerBody> body; ///< what the player walks in; then `player` is not asked
    bool isHeld = false;                    ///< something keeps it nearer behind the body than it would be
    double time = 0.5;
    std::uint32_t dayGroup = 0; ///< of the Region's kinds of days
    Weather weather = Weather::Clear;
    double seconds = 0.0;         ///< since the world began: where villagers, sprites and clouds are
    std::optional<double> doors;  ///< how far all doors stand open, 0..1; none: each as eachDoor says
    std::vector<double> eachDoor; ///< by World::doors; those beyond its end stand as they rest
};

/// The frame as JSON (docs/interface.md). `ids` is the id image, or empty if it was not drawn.
[[nodiscard]] nlohmann::ordered_json frameJson(const world::World& world, const IdTable& table,
                                               const FrameEye& eye, const world::DynamicState& dynamics,
                                               const visibility::VisibleSet& visible,
                                               const frame::FramePlan& plan, const FrameFigures& figures,
                                               std::span<const std::uint32_t> ids);

/// The player's body; null: none.
[[nodiscard]] nlohmann::ordered_json bodyJson(const world::World& world,
                                              const std::optional<motion::PlayerBody>& body);

/// The cells that any visit may see, by id, each once, ascending; without the outside.
[[nodiscard]] std::vector<dat::RecordId> cellsSeen(const world::World& world,
                                                   const visibility::VisibleSet& visible);

/// A visit's region in NDC. Corners at the eye itself (w = 0) have no place on the screen and are left out.
[[nodiscard]] std::vector<Vec2> regionNdc(const visibility::VisibleSet& visible,
                                          const visibility::Visit& visit);

/// The command that draws this frame again, root named. `datOption` is "" or " --dat DIR".
[[nodiscard]] std::string reproduction(const world::World& world, const FrameEye& eye,
                                       const std::string& datOption);

} // namespace limen::app
