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
enum class SkyPiece : std::uint32_t { Night, Day, Dusk, Sun, Moon, Clouds, Count };

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

/// A shallow bowl overhead for the clouds.
FaceMesh cloudBowl() {
    constexpr int kAround = 20;
    constexpr int kRings = 6;
    FaceMesh mesh;
    const auto at = [](int ring, int k) {
        const double t = static_cast<double>(ring) / kRings;
        const double a = 2.0 * std::numbers::pi * (k % kAround) / kAround;
        return Vec3(kRadius * t * std::cos(a), kRadius * t * std::sin(a), 240.0 * (1.0 - t * t) + 6.0);
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

/// A time of day: its light and the opacity of each dome (0..1).
struct SkyKeyframe {
    double time = 0.0;
    double sun = 0.0;
    std::uint32_t sunColour = 0xFFFFFFFF;
    double ambient = 0.0;
    std::uint32_t ambientColour = 0xFFFFFFFF;
    std::uint32_t fogColour = 0xFF000000;
    double day = 0.0, dusk = 0.0, clouds = 0.0;
};

constexpr std::array kStates{
    SkyKeyframe{0.00, 0.30, 0xFF9FB4E0, 0.70, 0xFF3C4666, 0xFF10141F, 0.00, 0.00, 0.10},
    SkyKeyframe{0.19, 0.24, 0xFF9FB4E0, 0.70, 0xFF3C4666, 0xFF10141F, 0.00, 0.00, 0.10},
    SkyKeyframe{0.235, 0.00, 0xFFFF9050, 0.80, 0xFF5A5570, 0xFF564A58, 0.25, 0.75, 0.35},
    SkyKeyframe{0.27, 0.45, 0xFFFFA060, 0.72, 0xFF77707F, 0xFFB08C80, 0.60, 0.90, 0.70},
    SkyKeyframe{0.31, 0.66, 0xFFFFCF98, 0.64, 0xFF8890A2, 0xFFBFC3C4, 0.95, 0.35, 0.85},
    SkyKeyframe{0.37, 0.78, 0xFFFFE6C4, 0.70, 0xFF8C9AB2, 0xFFC3D2DC, 1.00, 0.00, 0.90},
    SkyKeyframe{0.43, 0.82, 0xFFFFF0DC, 0.72, 0xFF8E9CB4, 0xFFC6D6E0, 1.00, 0.00, 0.90},
    SkyKeyframe{0.50, 0.84, 0xFFFFF4E4, 0.74, 0xFF909EB4, 0xFFC8D8E2, 1.00, 0.00, 0.90},
    SkyKeyframe{0.57, 0.82, 0xFFFFF0DC, 0.72, 0xFF8E9CB4, 0xFFC6D6E0, 1.00, 0.00, 0.90},
    SkyKeyframe{0.63, 0.78, 0xFFFFE4C0, 0.70, 0xFF8C98B0, 0xFFC6D0D6, 1.00, 0.00, 0.90},
    SkyKeyframe{0.69, 0.64, 0xFFFFC88C, 0.62, 0xFF858898, 0xFFC4B8AE, 0.95, 0.40, 0.85},
    SkyKeyframe{0.73, 0.45, 0xFFFF9455, 0.70, 0xFF74697A, 0xFFB08472, 0.60, 0.95, 0.70},
    SkyKeyframe{0.765, 0.00, 0xFFFF7848, 0.80, 0xFF564F6C, 0xFF54465A, 0.22, 0.75, 0.35},
    SkyKeyframe{0.81, 0.24, 0xFF9FB4E0, 0.70, 0xFF3C4666, 0xFF10141F, 0.00, 0.00, 0.10}};

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
    key.dirHeading = static_cast<float>(std::atan2(towards.y, towards.x) * 180.0 / std::numbers::pi);
    key.dirPitch = static_cast<float>(std::asin(towards.z) * 180.0 / std::numbers::pi);
    key.dirColour.argb = m.sunColour;
    key.ambBright = static_cast<float>(m.ambient);
    key.ambColour.argb = m.ambientColour;
    key.minFog = 140.0f;
    key.maxFog = 1100.0f;
    key.fogColour.argb = m.fogColour;
    key.fogMode = 3;
    const auto replace = [&key](SkyPiece piece, double shown) {
        dat::SkyObjectReplace r;
        r.objectIndex = static_cast<std::uint32_t>(piece);
        r.transparent = static_cast<float>(1.0 - shown);
        r.luminosity = 1.0f;
        r.maxBright = 1.0f;
        key.replaces.push_back(r);
    };
    replace(SkyPiece::Day, m.day);
    replace(SkyPiece::Dusk, m.dusk);
    replace(SkyPiece::Clouds, m.clouds);
    if (m.dusk > 0.5) {
        replace(SkyPiece::Sun, 1.0);
        key.replaces.back().gfxObj = lowSun;
    }
    return key;
}

/// An overcast sky with falling snow.
dat::DayGroup snowyDays(dat::RecordId night, dat::RecordId cloud, dat::RecordId snow) {
    constexpr double kSun = 0.35, kAmbient = 1.15; // factors of a fair day's light
    constexpr std::uint32_t kLight = 0xFFE4E8F0, kMist = 0xFFC2C7CC, kDark = 0xFF14161A;
    dat::DayGroup group;
    group.chance = 0.2f;
    group.name = "Snow";
    group.objects.push_back(skyObject(night, 0.0, 0.0, 0.0, 0.0, 0));
    group.objects.push_back(skyObject(cloud, 0.0, 0.0, 0.0, 0.0, 0));
    group.objects.push_back(skyObject(0, 0.0, 0.0, 0.0, 0.0, 8));
    group.objects.back().script = snow;
    for (const SkyKeyframe& fair : kStates) {
        dat::SkyTimeOfDay key = keyframe(fair, 0);
        key.dirBright *= static_cast<float>(kSun);
        key.ambBright *= static_cast<float>(kAmbient);
        key.dirColour.argb = kLight;
        key.fogColour.argb = fair.day > 0.5 ? kMist : kDark;
        key.minFog = 20.0f;
        key.maxFog = 420.0f;
        std::erase_if(key.replaces, [](const dat::SkyObjectReplace& r) {
            return r.objectIndex != static_cast<std::uint32_t>(SkyPiece::Day);
        });
        group.times.push_back(std::move(key));
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
    fair.objects.push_back(skyObject(mesh(disc(Material::Moon, 26.0, 0.5 * kSunTilt)), kSunset - early,
                                     kSunrise + early, -slack, 180.0 + slack, 0));
    dat::SkyObject clouds = skyObject(mesh(cloudBowl()), 0.0, 0.0, 0.0, 0.0, 2);
    clouds.texVelocityX = 0.0015f;
    clouds.texVelocityY = 0.0006f;
    fair.objects.push_back(clouds);
    const dat::RecordId lowSun = mesh(disc(Material::Sun, 150.0, kSunTilt));
    for (const SkyKeyframe& state : kStates)
        fair.times.push_back(keyframe(state, lowSun));
    dat::SkyDesc sky;
    sky.tickSize = 5.0;
    sky.lightTickSize = 1.0;
    sky.dayGroups.push_back(std::move(fair));
    // Separate statements fix the order of the ids. The evaluation order of arguments differs between
    // compilers.
    const dat::RecordId snow = addSnowScript(writer);
    const dat::RecordId cloud = mesh(dome(Material::SkySnow));
    sky.dayGroups.push_back(snowyDays(night, cloud, snow));
    return sky;
}

} // namespace limen::worlds
