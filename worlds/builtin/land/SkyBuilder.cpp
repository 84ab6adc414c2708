#include "worlds/builtin/effects/Effects.h"
#include "worlds/builtin/land/RegionBuilder.h"
#include "worlds/pictures/Painters.h"

#include <numbers>

namespace limen::worlds {

namespace {

/// Metres. Sky meshes are drawn around the eye, so their size does not matter.
constexpr double kRadius = 1000.0;
/// Radians from the zenith to the sun at noon, southwards.
constexpr double kSunTilt = 32.0 * std::numbers::pi / 180.0;
constexpr double kSunrise = 0.25, kSunset = 0.75;

/// Indices into the day group's objects.
enum class SkyPiece : std::uint32_t { Night, Day, Dusk, Sun, EveningMoon, MorningMoon, Clouds, Count };

// SkyObject::properties
constexpr std::uint32_t kOverLand = 1, kWeather = 4, kAtViewer = 8;

/// A dome seen from inside: u goes around, v from the zenith (0) past the horizon (kHorizonV) to 22.5° below
/// it (1).
FaceMesh dome(Material material) {
    constexpr int kAround = 24;
    constexpr int kRings = 10;
    FaceMesh mesh;
    const auto at = [](int ring, int k) {
        const double polar = 0.5 * std::numbers::pi / kHorizonV * ring / kRings;
        const double a = 2.0 * std::numbers::pi * (k % kAround) / kAround;
        return kRadius * Vec3(std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar));
    };
    const auto uv = [](int ring, int k) {
        return Vec2(static_cast<double>(k) / kAround, static_cast<double>(ring) / kRings);
    };
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            Face face;
            face.material = material;
            face.points = {at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)};
            face.uvs = {uv(ring, k), uv(ring, k + 1), uv(ring + 1, k + 1), uv(ring + 1, k)};
            if (ring == 0) {
                face.points.erase(face.points.begin());
                face.uvs.erase(face.uvs.begin());
            }
            mesh.add(std::move(face));
        }
    }
    return mesh;
}

/// A disc in the sky at sky angle 0 (in the east). Sky angles turn it over the south to the west.
FaceMesh disc(Material material, double half, double tilt) {
    const Vec3 centre = 0.9 * kRadius * Vec3(std::cos(tilt), -std::sin(tilt), 0.0);
    const Vec3 right = glm::normalize(glm::cross(centre, Vec3(0, 0, 1))) * half;
    const Vec3 up = glm::normalize(glm::cross(right, centre)) * half;
    FaceMesh mesh;
    mesh.card({centre - right - up, centre + right - up, centre + right + up, centre - right + up}, material,
              true);
    return mesh;
}

/// A shallow bowl overhead for the clouds. Its rim is below the horizon.
FaceMesh cloudBowl() {
    constexpr int kAround = 20;
    constexpr int kRings = 6;
    FaceMesh mesh;
    const auto at = [](int ring, int k) {
        const double t = static_cast<double>(ring) / kRings;
        const double a = 2.0 * std::numbers::pi * (k % kAround) / kAround;
        return Vec3(kRadius * t * std::cos(a), kRadius * t * std::sin(a), 240.0 - 400.0 * t * t);
    };
    const auto uv = [&](int ring, int k) { return Vec2(at(ring, k)) / 560.0; };
    for (int ring = 0; ring < kRings; ++ring) {
        for (int k = 0; k < kAround; ++k) {
            Face face;
            face.material = Material::Clouds;
            face.points = {at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k)};
            face.uvs = {uv(ring, k), uv(ring, k + 1), uv(ring + 1, k + 1), uv(ring + 1, k)};
            if (ring == 0) {
                face.points.erase(face.points.begin());
                face.uvs.erase(face.uvs.begin());
            }
            mesh.add(std::move(face));
        }
    }
    return mesh;
}

/// Rain around the eye: eight faces that lean together above it. `radius`: at the height of the eye, metres.
FaceMesh rainSheet(double radius) {
    constexpr int kFaces = 8;
    constexpr double kLow = -1.2, kHigh = 2.4,
                     kLean = 0.28; // of the radius; the lean: for each unit of height
    FaceMesh mesh;
    const auto at = [radius](int k, double height) {
        const double a = 2.0 * std::numbers::pi * (k % kFaces) / kFaces;
        const double r = radius * (1.0 - kLean * height);
        return Vec3(r * std::cos(a), r * std::sin(a), radius * height);
    };
    for (int k = 0; k < kFaces; ++k) {
        Face face;
        face.material = Material::Rain;
        face.points = {at(k + 1, kLow), at(k, kLow), at(k, kHigh), at(k + 1, kHigh)};
        const double rows = kHigh - kLow;
        face.uvs = {Vec2(2.0 * k + 2.0, rows), Vec2(2.0 * k, rows), Vec2(2.0 * k, 0.0),
                    Vec2(2.0 * k + 2.0, 0.0)};
        mesh.add(std::move(face));
    }
    return mesh;
}

dat::SkyObject skyObject(dat::RecordId mesh, double begin, double end, double fromAngle, double toAngle,
                         std::uint32_t properties) {
    dat::SkyObject object;
    object.object = mesh;
    object.beginTime = static_cast<float>(begin);
    object.endTime = static_cast<float>(end);
    object.beginAngle = static_cast<float>(fromAngle);
    object.endAngle = static_cast<float>(toAngle);
    object.properties = properties;
    return object;
}

/// A time of day: its light, the opacity of each dome (0..1), and the clouds' own light in hundredths.
struct SkyKeyframe {
    double time = 0.0;
    double sun = 0.0;
    std::uint32_t sunColour = 0xFFFFFFFF;
    double ambient = 0.0;
    std::uint32_t ambientColour = 0xFFFFFFFF;
    std::uint32_t fogColour = 0xFF000000;
    double day = 0.0, dusk = 0.0, clouds = 0.0;
    float cloudLight = 0.0f;
};

constexpr std::array kStates{
    SkyKeyframe{0.00, 0.66, 0xFF9FB4E0, 1.05, 0xFF3C4666, 0xFF1A2130, 0.00, 0.00, 0.98, 1},
    SkyKeyframe{0.19, 0.54, 0xFF9FB4E0, 1.05, 0xFF3C4666, 0xFF1A2130, 0.00, 0.00, 0.98, 1},
    SkyKeyframe{0.235, 0.05, 0xFFFF9050, 1.15, 0xFF76728E, 0xFF564A58, 0.25, 0.75, 0.80, 8},
    SkyKeyframe{0.27, 0.55, 0xFFFFA060, 1.20, 0xFF8E8692, 0xFFB08C80, 0.60, 0.90, 0.85, 30},
    SkyKeyframe{0.31, 0.66, 0xFFFFCF98, 0.95, 0xFF8890A2, 0xFFBFC3C4, 0.95, 0.35, 0.90, 45},
    SkyKeyframe{0.37, 0.80, 0xFFFFE6C4, 0.86, 0xFF8C9AB2, 0xFFC3D2DC, 1.00, 0.00, 0.90, 50},
    SkyKeyframe{0.43, 0.86, 0xFFFFF0DC, 0.86, 0xFF8E9CB4, 0xFFC6D6E0, 1.00, 0.00, 0.90, 50},
    SkyKeyframe{0.50, 0.88, 0xFFFFF4E4, 0.86, 0xFF909EB4, 0xFFC8D8E2, 1.00, 0.00, 0.90, 50},
    SkyKeyframe{0.57, 0.86, 0xFFFFF0DC, 0.86, 0xFF8E9CB4, 0xFFC6D6E0, 1.00, 0.00, 0.90, 50},
    SkyKeyframe{0.63, 0.80, 0xFFFFE4C0, 0.86, 0xFF8C98B0, 0xFFC6D0D6, 1.00, 0.00, 0.90, 50},
    SkyKeyframe{0.69, 0.64, 0xFFFFC88C, 0.95, 0xFF858898, 0xFFC4B8AE, 0.95, 0.40, 0.90, 45},
    SkyKeyframe{0.73, 0.55, 0xFFFF9455, 1.20, 0xFF8C828E, 0xFFB08472, 0.60, 0.95, 0.85, 30},
    SkyKeyframe{0.765, 0.05, 0xFFFF7848, 1.15, 0xFF726B8A, 0xFF54465A, 0.22, 0.75, 0.80, 8},
    SkyKeyframe{0.81, 0.54, 0xFF9FB4E0, 1.05, 0xFF3C4666, 0xFF1A2130, 0.00, 0.00, 0.98, 1}};

/// The direction to the sun (by day) or the moon (by night).
Vec3 lightDirection(double time) {
    const bool day = time > 0.22 && time < 0.78;
    const double half = kSunset - kSunrise;
    const double since = day ? time - kSunrise : (time < 0.5 ? time + 1.0 : time) - kSunset;
    const double angle = std::numbers::pi * std::clamp(since / half, 0.02, 0.98);
    const double tilt = day ? kSunTilt : 0.5 * kSunTilt;
    return {std::cos(tilt) * std::cos(angle), -std::sin(tilt), std::cos(tilt) * std::sin(angle)};
}

/// `lowSun`: replaces the sun while dusk or dawn is strongest.
dat::SkyTimeOfDay keyframe(const SkyKeyframe& m, dat::RecordId lowSun) {
    dat::SkyTimeOfDay key;
    const Vec3 towards = lightDirection(m.time);
    key.begin = static_cast<float>(m.time);
    key.dirBright = static_cast<float>(m.sun);
    key.dirHeading = static_cast<float>(std::atan2(towards.x, towards.y) * 180.0 / std::numbers::pi);
    key.dirPitch = static_cast<float>(std::asin(towards.z) * 180.0 / std::numbers::pi);
    key.dirColour.argb = m.sunColour;
    key.ambBright = static_cast<float>(m.ambient);
    key.ambColour.argb = m.ambientColour;
    key.minFog = 140.0f;
    key.maxFog = 1100.0f;
    key.fogColour.argb = m.fogColour;
    key.fogMode = 3;
    const auto replace = [&key](SkyPiece piece, double shown, float light) {
        constexpr float kNotSet = -1.0f;
        dat::SkyObjectReplace r;
        r.objectIndex = static_cast<std::uint32_t>(piece);
        r.transparent = static_cast<float>(100.0 * (1.0 - shown));
        r.luminosity = r.maxBright = light > 0.0f ? light : kNotSet;
        key.replaces.push_back(r);
    };
    replace(SkyPiece::Day, m.day, 0.0f); // domes have their own light
    replace(SkyPiece::Dusk, m.dusk, 0.0f);
    replace(SkyPiece::Clouds, m.clouds, m.cloudLight);
    if (m.dusk > 0.5) {
        replace(SkyPiece::Sun, 1.0, 0.0f);
        key.replaces.back().gfxObj = lowSun;
    }
    return key;
}

/// A sky that is one cloud.
struct Overcast {
    const char* name = "";
    double sun = 1.0, ambient = 1.0; ///< factors of a fair day's light
    std::uint32_t light = 0xFFFFFFFF, mist = 0xFF000000;
    float nearFog = 0.0f, farFog = 0.0f; ///< metres
};

/// `night`, `cloud`: domes, objects 0 and 1. Others follow.
dat::DayGroup overcastDays(const Overcast& kind, dat::RecordId night, dat::RecordId cloud) {
    constexpr std::uint32_t kDark = 0xFF14161A;
    dat::DayGroup group;
    group.chance = 0.2f;
    group.name = kind.name;
    group.objects.push_back(skyObject(night, 0.0, 0.0, 0.0, 0.0, 0));
    group.objects.push_back(skyObject(cloud, 0.0, 0.0, 0.0, 0.0, 0));
    for (const SkyKeyframe& fair : kStates) {
        dat::SkyTimeOfDay key = keyframe(fair, 0);
        key.dirBright *= static_cast<float>(kind.sun);
        key.ambBright *= static_cast<float>(kind.ambient);
        key.dirColour.argb = kind.light;
        key.fogColour.argb = fair.day > 0.5 ? kind.mist : kDark;
        key.minFog = kind.nearFog;
        key.maxFog = kind.farFog;
        std::erase_if(key.replaces, [](const dat::SkyObjectReplace& r) {
            return r.objectIndex != static_cast<std::uint32_t>(SkyPiece::Day);
        });
        group.times.push_back(std::move(key));
    }
    return group;
}

dat::DayGroup snowyDays(dat::RecordId night, dat::RecordId cloud, dat::RecordId snow) {
    dat::DayGroup group =
        overcastDays({"Snow", 0.40, 1.60, 0xFFE4E8F0, 0xFF9BA0A8, 8.0f, 150.0f}, night, cloud);
    group.objects.push_back(skyObject(0, 0.0, 0.0, 0.0, 0.0, kAtViewer));
    group.objects.back().script = snow;
    return group;
}

/// Two sheets of rain, behind and over the land.
dat::DayGroup rainyDays(dat::RecordId night, dat::RecordId cloud, dat::RecordId far, dat::RecordId near) {
    dat::DayGroup group =
        overcastDays({"Rain", 0.30, 1.25, 0xFFC8D0DC, 0xFF80868E, 20.0f, 480.0f}, night, cloud);
    for (const auto& [sheet, pass] : {std::pair{far, 0u}, {near, kOverLand}}) {
        group.objects.push_back(skyObject(sheet, 0.0, 0.0, 0.0, 0.0, kWeather | kAtViewer | pass));
        group.objects.back().texVelocityX = 0.02f;
        group.objects.back().texVelocityY = pass == 0u ? -1.2f : -2.0f;
    }
    return group;
}

} // namespace

dat::SkyDesc buildSky(ModelWriter& writer) {
    const auto mesh = [&writer](const FaceMesh& m) { return writer.addMesh(m, false); };
    const dat::RecordId night = mesh(dome(Material::SkyNight));
    dat::DayGroup fair;
    fair.chance = 0.8f;
    fair.name = "Fair";
    fair.objects.push_back(skyObject(night, 0.0, 0.0, 0.0, 0.0, 0));
    fair.objects.push_back(skyObject(mesh(dome(Material::SkyDay)), 0.0, 0.0, 0.0, 0.0, 0));
    fair.objects.push_back(skyObject(mesh(dome(Material::SkyDusk)), 0.0, 0.0, 0.0, 0.0, 0));
    const double early = 0.03;
    const double slack = 360.0 * early;
    fair.objects.push_back(skyObject(mesh(disc(Material::Sun, 110.0, kSunTilt)), kSunrise - early,
                                     kSunset + early, -slack, 180.0 + slack, 0));
    // No object is shown across midnight: one moon sets at it, another one rises.
    const dat::RecordId moon = mesh(disc(Material::Moon, 26.0, 0.5 * kSunTilt));
    constexpr double kBeside = 1e-4; // of a day: begin and end are not shown themselves
    fair.objects.push_back(skyObject(moon, kSunset - early, 1.0 + kBeside, -slack, 90.0, 0));
    fair.objects.push_back(skyObject(moon, -kBeside, kSunrise + early, 90.0, 180.0 + slack, 0));
    dat::SkyObject clouds = skyObject(mesh(cloudBowl()), 0.0, 0.0, 0.0, 0.0, 2);
    clouds.texVelocityX = 0.0015f;
    clouds.texVelocityY = 0.0006f;
    fair.objects.push_back(clouds);
    const dat::RecordId lowSun = mesh(disc(Material::Sun, 150.0, kSunTilt));
    for (const SkyKeyframe& state : kStates)
        fair.times.push_back(keyframe(state, lowSun));
    dat::SkyDesc sky;
    sky.tickSize = 0.8;
    sky.lightTickSize = 15.0;
    sky.dayGroups.push_back(std::move(fair));
    // Separate statements fix the order of the ids. The evaluation order of arguments differs between
    // compilers.
    const dat::RecordId snow = addSnowScript(writer);
    const dat::RecordId cloud = mesh(dome(Material::SkySnow));
    sky.dayGroups.push_back(snowyDays(night, cloud, snow));
    const dat::RecordId far = mesh(rainSheet(40.0));
    const dat::RecordId near = mesh(rainSheet(12.0));
    sky.dayGroups.push_back(rainyDays(night, cloud, far, near));
    return sky;
}

} // namespace limen::worlds
