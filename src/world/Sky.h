#pragma once

#include "dat/records/Landscape.h"
#include "geometry/Vec.h"
#include "world/Particles.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace limen::world {

/// One object of the sky dome: a mesh around the eye, shown between two times of day.
struct SkyPart {
    std::uint32_t dayGroup = 0, objectIndex = 0;
    std::uint32_t mesh = 0xFFFFFFFFu; ///< index into World::meshes
    std::uint32_t firstMaterial = 0;  ///< run of World::materialRefs
    dat::SkyObject object;
    /// What keyframes put in the object's place while they rule, if this shows that; 0: the object's own model.
    std::uint32_t replacement = 0;
};

/// Particles that an object of the sky lets fall around the eye while it is shown (SkyObject::script).
struct SkyWeather {
    std::uint32_t dayGroup = 0;
    dat::SkyObject object;
    /// Carried by nothing, and alone outside. Its style has no `offset`: births are spread by `spread` instead.
    ParticleSource source;
    Vec3 spread{0.0}; ///< how far births lie from the eye along each axis at most, metres
    double drift =
        0.0; ///< how far particles then go on the level at most, metres, with all that is drawn of them
};

/// A time of day in one of the Region's day groups.
struct SkyHour {
    std::uint32_t dayGroup = 0;
    double time = 0.5; ///< fraction of the day
};

/// The sky as the Region describes it; no day groups when it has none.
struct Sky {
    dat::SkyDesc desc;
    dat::GameTime time;
    std::vector<SkyPart> parts;
    std::vector<SkyWeather> weather;
};

/// Light and fog at one time of day, interpolated between keyframes (docs/formats/sky_weather.md#keyframes).
struct SkyState {
    Vec3f sunDirection{0.0f, 0.0f, 1.0f}; ///< towards the light
    Vec3f sunColour{0.0f};                ///< times brightness
    Vec3f ambient{0.4f};
    Vec3f fogColour{0.6f, 0.7f, 0.8f};
    float fogNear = 1e9f, fogFar = 2e9f; ///< metres; no fog by default
};

/// One sky object as it stands at a time of day.
struct SkyPlacement {
    std::uint32_t part = 0;   ///< index into Sky::parts
    glm::mat3 rotation{1.0f}; ///< world from model, about the eye
    float transparent = 0.0f; ///< 0 opaque .. 1 hidden
    float luminosity = 1.0f;
    Vec2f uvOffset{0.0f};
};

/// The light at `time` (fraction of the day, 0..1) in day group `dayGroup` (clamped). Defaults without a sky.
[[nodiscard]] SkyState skyAt(const Sky& sky, std::uint32_t dayGroup, double time);

/// Whether an object shows at a time of day, fraction.
[[nodiscard]] bool isShown(const dat::SkyObject& object, double time);

/// The day group that a text names: its number, from 0, or its name, whatever the case of its letters. Without day groups 0 names what
/// is there. Nothing: it names none.
[[nodiscard]] std::optional<std::uint32_t> dayGroupNamed(const dat::SkyDesc& sky, std::string_view text);

/// The sky objects visible then, in drawing order. `out` is overwritten and keeps its capacity.
void skyPlacements(const Sky& sky, std::uint32_t dayGroup, double time, double seconds,
                   std::vector<SkyPlacement>& out);

} // namespace limen::world
