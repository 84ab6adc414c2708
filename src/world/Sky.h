#pragma once

#include "dat/records/Landscape.h"
#include "geometry/Vec.h"
#include "world/Index.h"
#include "world/Particles.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace limen::world {

/// One mesh of a sky object. It is drawn around the eye, between two times of day.
struct SkyPart {
    std::uint32_t dayGroup = 0, objectIndex = 0;
    std::uint32_t mesh = kNone;      ///< index into World::meshes
    std::uint32_t firstMaterial = 0; ///< run of World::materialRefs
    dat::SkyObject object;
    /// The model of some keyframes that replaces the object's own, if this mesh belongs to it; 0: the own
    /// model.
    std::uint32_t replacement = 0;

    // world/SkyCover.h
    static constexpr double kCoversNothing = 2.0;
    bool isOpaque = false;              ///< every triangle, if the object is not transparent
    double coversFrom = kCoversNothing; ///< opaque and in its own pose: coveredFrom of its triangles
    std::uint32_t shape = 0;            ///< the first part with the same triangles
};

/// Particles that fall around the eye while a sky object is shown (SkyObject::script).
struct SkyWeather {
    std::uint32_t dayGroup = 0;
    dat::SkyObject object;
    /// Without a carrier, outdoors, alone. Of SkyParticles::Around its style has no `offset`: `spread` displaces births
    /// instead.
    ParticleSource source;
    Vec3 spread{0.0}; ///< greatest distance of births from the eye along each axis, metres
    double drift =
        0.0; ///< greatest horizontal distance of a particle's points from its place of birth, metres
};

/// A time of day in one of the Region's day groups.
struct SkyHour {
    std::uint32_t dayGroup = 0;
    double time = 0.5; ///< fraction of the day
};

/// The sky of the Region; no day groups without one.
struct Sky {
    dat::SkyDesc desc;
    dat::GameTime time;
    std::vector<SkyPart> parts;
    std::vector<SkyWeather> weather;
};

/// Light and fog at one time of day, interpolated between keyframes (docs/formats/sky_weather.md#keyframes).
struct SkyState {
    Vec3f sunDirection{12.0f / 13.0f, 0.0f, 5.0f / 13.0f}; ///< towards the light
    Vec3f sunColour{1.3f};                                 ///< times brightness
    float sunBright = 1.3f;
    Vec3f ambient{0.4f}; ///< of the ground, times brightness
    Vec3f ambientColour{1.0f};
    Vec3f fogColour{0.6f, 0.7f, 0.8f};
    float fogNear = 1e9f, fogFar = 2e9f; ///< metres; no fog by default

    /// The ambient light of everything but the ground.
    [[nodiscard]] Vec3f thingsAmbient() const { return ambient + 0.2f * sunBright * ambientColour; }
};

/// The state of one sky part at a time of day.
struct SkyPlacement {
    std::uint32_t part = 0;   ///< index into Sky::parts
    glm::mat3 rotation{1.0f}; ///< world from model
    Vec3f offset{0.0f};       ///< of the model's origin from the eye, metres
    float transparent = 0.0f; ///< 0 opaque .. 1 hidden
    float luminosity = 0.0f;  ///< emission of surfaces without one of their own
    float diffuse = 1.0f;     ///< factor of the sun's light
    bool isOverLand = false;  ///< drawn over everything outdoors, else behind it
    Vec2f uvOffset{0.0f};
};

/// The light at `time` (fraction of the day, 0..1) in day group `dayGroup` (clamped). Defaults without a sky.
[[nodiscard]] SkyState skyAt(const Sky& sky, std::uint32_t dayGroup, double time);

/// The time of the last update of the light, and of the sky's objects; fractions of the day.
[[nodiscard]] double timeOfLight(const Sky& sky, double time);
[[nodiscard]] double timeOfSky(const Sky& sky, double time);

/// `time`: fraction of the day.
[[nodiscard]] bool isShown(const dat::SkyObject& object, double time);

/// The day group that a text names: by number, from 0, or by name, ignoring case. Without day groups, number
/// 0 is valid. No value: there is no such group.
[[nodiscard]] std::optional<std::uint32_t> dayGroupNamed(const dat::SkyDesc& sky, std::string_view text);

/// `dayGroup` if it has rain over the land, else the first that has, else `dayGroup`.
[[nodiscard]] std::uint32_t rainyDayGroup(const dat::SkyDesc& sky, std::uint32_t dayGroup);

/// The viewer of a sky.
struct SkyView {
    std::uint32_t dayGroup = 0;
    double time = 0.5;      ///< fraction of the day
    double seconds = 0.0;   ///< age of the world, which moves textures
    double eyeZ = 0.0;      ///< global, metres
    bool isOutdoors = true; ///< the eye; else nothing is over the land
    Vec3 origin{0.0};       ///< of objects that are not weather, from the eye, metres
};

/// The sky parts that are shown, in drawing order. `out` is overwritten and keeps its capacity.
void skyPlacements(const Sky& sky, const SkyView& view, std::vector<SkyPlacement>& out);

} // namespace limen::world
