#include "world/LeafPose.h"

#include "core/Assert.h"
#include "geometry/Compass.h"

#include <algorithm>
#include <numbers>

namespace limen::world {
namespace {

std::span<const LeafKey> keysOf(const World& world, const Leaf& leaf) {
    LIMEN_ASSERT(std::size_t{leaf.firstKey} + leaf.keyCount <= world.leafKeys.size(),
                 "a leaf's keys are in the world");
    return std::span(world.leafKeys).subspan(leaf.firstKey, leaf.keyCount);
}

/// The distance of the leaf's farthest point from its own origin.
double reachOf(const Leaf& leaf) {
    return glm::length(leaf.body.bounds.centre) + leaf.body.bounds.radius;
}

double angleBetween(const Quat& a, const Quat& b) {
    return 2.0 * std::acos(std::min(std::abs(glm::dot(a, b)), 1.0));
}

/// Metres that a point at this distance from the leaf's origin moves at most from key to key.
double wayBetween(const LeafKey& a, const LeafKey& b, double reach) {
    return glm::length(b.origin - a.origin) + reach * angleBetween(a.orientation, b.orientation);
}

} // namespace

LeafPose leafPose(const World& world, const Leaf& leaf, double open) {
    if (leaf.keyCount == 0)
        return {turnedTo(leaf.yaw + leaf.swing * open), leaf.hinge};
    const std::span<const LeafKey> keys = keysOf(world, leaf);
    const double at = std::clamp(open, 0.0, 1.0) * static_cast<double>(keys.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(at), keys.size() - 1);
    const LeafKey& from = keys[first];
    const LeafKey& to = keys[std::min(first + 1, keys.size() - 1)];
    const double between = at - static_cast<double>(first);
    if (between == 0.0)
        return {glm::mat3_cast(from.orientation), from.origin};
    return {glm::mat3_cast(glm::slerp(from.orientation, to.orientation, between)),
            from.origin + (to.origin - from.origin) * between};
}

bool canMove(const World& world, const Leaf& leaf) {
    if (leaf.keyCount == 0)
        return leaf.swing != 0.0;
    const std::span<const LeafKey> keys = keysOf(world, leaf);
    return std::any_of(keys.begin(), keys.end(), [&](const LeafKey& key) { return !(key == keys.front()); });
}

double leafWay(const World& world, const Leaf& leaf) {
    if (leaf.keyCount == 0) {
        const Sphere& bounds = leaf.body.bounds;
        return (std::hypot(bounds.centre.x, bounds.centre.y) + bounds.radius) * std::abs(leaf.swing) *
               std::numbers::pi / 180.0;
    }
    const std::span<const LeafKey> keys = keysOf(world, leaf);
    double way = 0.0;
    for (std::size_t i = 1; i < keys.size(); ++i)
        way += wayBetween(keys[i - 1], keys[i], reachOf(leaf));
    return way;
}

Sphere leafReach(const World& world, const Leaf& leaf) {
    if (leaf.keyCount == 0)
        return {leaf.hinge, reachOf(leaf)};
    // Around the middle of all keys. A point strays from its nearest key by half the way between two keys at most.
    const std::span<const LeafKey> keys = keysOf(world, leaf);
    Vec3 centre(0.0);
    for (const LeafKey& key : keys)
        centre += (key.origin + key.orientation * leaf.body.bounds.centre) / static_cast<double>(keys.size());
    double radius = 0.0, stray = 0.0;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Vec3 middle = keys[i].origin + keys[i].orientation * leaf.body.bounds.centre;
        radius = std::max(radius, glm::length(middle - centre) + leaf.body.bounds.radius);
        if (i > 0)
            stray = std::max(stray, wayBetween(keys[i - 1], keys[i], reachOf(leaf)) / 2.0);
    }
    return {centre, radius + stray};
}

} // namespace limen::world
