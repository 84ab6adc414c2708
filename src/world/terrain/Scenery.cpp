#include "world/terrain/Scenery.h"

#include "core/Assert.h"
#include "geometry/Angles.h"
#include "world/LandRandom.h"
#include "world/terrain/SceneryFit.h"

#include <algorithm>

namespace limen::world {
namespace {

constexpr double kRoadHalfWidth = 5.0; ///< metres

/// The random numbers of the k-th entry of a scene at the global vertex (x, y).
struct RandomGenerator {
    std::uint32_t x, y, k;
    [[nodiscard]] double roll(std::uint32_t seed) const { return landRandom(x, y, seed + k); }
};

/// Offset from the vertex, metres: a random displacement, rotated into a random quadrant.
Vec2 displacement(const dat::SceneObject& object, const RandomGenerator& random) {
    double dx = object.baseLoc.origin.x, dy = object.baseLoc.origin.y;
    if (object.displaceX > 0.0f)
        dx += random.roll(seed::kDisplaceX) * static_cast<double>(object.displaceX);
    if (object.displaceY > 0.0f)
        dy += random.roll(seed::kDisplaceY) * static_cast<double>(object.displaceY);
    const double quadrant = landRandom(random.x, random.y, seed::kQuadrant);
    if (quadrant >= 0.75)
        return {dy, -dx};
    if (quadrant >= 0.5)
        return {-dx, -dy};
    if (quadrant >= 0.25)
        return {-dy, dx};
    return {dx, dy};
}

/// Compass direction of a horizontal vector: degrees, 0 north, clockwise. 0 for a zero vector.
double headingOf(double x, double y) {
    if (std::hypot(x, y) < 1e-6)
        return 0.0;
    return std::fmod(450.0 - std::atan2(y, x) / kDegree, 360.0);
}

Quat orientationOf(const dat::SceneObject& object, const RandomGenerator& random, const Vec3& normal) {
    const Quat stored(object.baseLoc.orientation);
    const double length = glm::length(stored);
    const Quat base = std::isfinite(length) && length > 1e-6 ? stored / length : Quat(1.0, 0.0, 0.0, 0.0);
    double heading = 0.0;
    if (object.align != 0)
        heading = headingOf(-normal.x, -normal.y);
    else if (object.maxRotation > 0.0f)
        heading = random.roll(seed::kRotation) * static_cast<double>(object.maxRotation);
    else
        return base;
    // A heading replaces the turn about z and keeps the pitch: the slope of the object's y axis.
    const double half = -heading * kDegree * 0.5;
    const double pitch = std::asin(std::clamp((base * Vec3(0.0, 1.0, 0.0)).z, -1.0, 1.0));
    return Quat(std::cos(half), 0.0, 0.0, std::sin(half)) *
           Quat(std::cos(pitch * 0.5), std::sin(pitch * 0.5), 0.0, 0.0);
}

double scaleOf(const dat::SceneObject& object, const RandomGenerator& random) {
    const double low = object.minScale, high = object.maxScale;
    const double scale = low == high ? high : low * std::pow(high / low, random.roll(seed::kScale));
    return std::isfinite(scale) && scale > 0.0 && scale < 1000.0 ? scale : 1.0;
}

/// Places one entry at a vertex. No value if chance, a road, a building or the slope forbids it.
std::optional<SceneryObject> grow(const dat::SceneObject& object, const RandomGenerator& random,
                                  const Ground& ground, int vertex, const std::set<int>& builtCells) {
    if (object.object == 0 || object.weenieObj != 0 ||
        !(random.roll(seed::kFrequency) < static_cast<double>(object.frequency)))
        return std::nullopt;
    const Vec2 offset = displacement(object, random);
    const double x = vertex / 9 * kLandcellSize + offset.x, y = vertex % 9 * kLandcellSize + offset.y;
    if (!(x >= 0.0 && y >= 0.0 && x < kBlockSize && y < kBlockSize) || isOnRoad(ground, x, y))
        return std::nullopt;
    if (builtCells.contains(static_cast<int>(x / kLandcellSize) * 8 + static_cast<int>(y / kLandcellSize)))
        return std::nullopt;
    const GroundPoint point = groundAt(ground.coord, ground.heights, x, y);
    if (point.normal.z < static_cast<double>(object.minSlope) ||
        point.normal.z > static_cast<double>(object.maxSlope))
        return std::nullopt;
    return SceneryObject{
        object.object, {x, y, point.z}, orientationOf(object, random, point.normal), scaleOf(object, random)};
}

/// The scene of a vertex, or null.
const dat::Scene* sceneAt(const Ground& ground, const dat::Region& region, int vertex, Records& records) {
    const std::uint32_t type = ground.type(vertex / 9, vertex % 9),
                        scenery = ground.scenery(vertex / 9, vertex % 9);
    if (type >= region.terrainTypes.size() || scenery >= region.terrainTypes[type].sceneTypes.size())
        return nullptr;
    const std::uint32_t sceneType = region.terrainTypes[type].sceneTypes[scenery];
    if (sceneType >= region.sceneTypes.size() || region.sceneTypes[sceneType].scenes.empty())
        return nullptr;
    const std::vector<std::uint32_t>& scenes = region.sceneTypes[sceneType].scenes;
    const auto gx = static_cast<std::uint32_t>(ground.coord.x * 8 + vertex / 9);
    const auto gy = static_cast<std::uint32_t>(ground.coord.y * 8 + vertex % 9);
    const auto index =
        static_cast<std::size_t>(static_cast<double>(scenes.size()) * landRandom(gx, gy, seed::kScene));
    return records.scene(scenes[index < scenes.size() ? index : 0]);
}

} // namespace

bool isOnRoad(const Ground& ground, double x, double y) {
    LIMEN_ASSERT(x >= 0.0 && y >= 0.0 && x <= kBlockSize && y <= kBlockSize, "the position is in the block");
    const int cellX = std::min(static_cast<int>(x / kLandcellSize), 7),
              cellY = std::min(static_cast<int>(y / kLandcellSize), 7);
    const double dx = x - cellX * kLandcellSize, dy = y - cellY * kLandcellSize;
    constexpr double w = kRoadHalfWidth, far = kLandcellSize - kRoadHalfWidth;
    const auto bit = [&](int stepX, int stepY) {
        return ground.road(cellX + stepX, cellY + stepY) != 0 ? 1 : 0;
    };
    // Corners in the order of docs/formats/landscape.md#roads: r00, r01 (north), r10 (east), r11.
    switch (bit(0, 0) << 3 | bit(0, 1) << 2 | bit(1, 0) << 1 | bit(1, 1)) {
    case 0b1111:
        return true;
    case 0b1110:
        return dx < w || dy < w;
    case 0b1101:
        return dx < w || dy > far;
    case 0b1100:
        return dx < w;
    case 0b1011:
        return dx > far || dy < w;
    case 0b1010:
        return dy < w;
    case 0b1001:
        return std::abs(dx - dy) < w;
    case 0b1000:
        return dx + dy < w;
    case 0b0111:
        return dx > far || dy > far;
    case 0b0110:
        return std::abs(dx + dy - kLandcellSize) < w;
    case 0b0101:
        return dy > far;
    case 0b0100:
        return kLandcellSize + dx - dy < w;
    case 0b0011:
        return dx > far;
    case 0b0010:
        return kLandcellSize - dx + dy < w;
    case 0b0001:
        return 2.0 * kLandcellSize - dx - dy < w;
    default:
        return false;
    }
}

std::vector<SceneryObject> growScenery(const Ground& ground, const dat::Region& region,
                                       const std::set<int>& builtCells, Records& records) {
    std::vector<SceneryObject> grown;
    for (int vertex = 0; vertex < 81; ++vertex) {
        const dat::Scene* scene = sceneAt(ground, region, vertex, records);
        if (scene == nullptr)
            continue;
        RandomGenerator random{static_cast<std::uint32_t>(ground.coord.x * 8 + vertex / 9),
                               static_cast<std::uint32_t>(ground.coord.y * 8 + vertex % 9), 0};
        for (const dat::SceneObject& object : scene->objects) {
            const std::optional<SceneryObject> one = grow(object, random, ground, vertex, builtCells);
            if (one && isWithinBlock(one->model, one->origin, one->orientation, records))
                grown.push_back(*one);
            ++random.k;
        }
    }
    return grown;
}

} // namespace limen::world
