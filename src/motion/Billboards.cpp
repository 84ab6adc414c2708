#include "motion/Billboards.h"

#include "core/Assert.h"

#include <algorithm>
#include <cmath>

namespace limen::motion {
namespace {

/// Metres, horizontally, beyond which all parts of an object face the same direction.
constexpr double kSharedBeyond = 5.0;
/// Metres: at this distance from the eye there is no direction.
constexpr double kNoDistance = 1e-6;

Vec3 directionOf(const Vec3& offset) {
    const double length = glm::length(offset);
    return length > kNoDistance ? offset / length : Vec3(0, 0, 1);
}

/// Rotates the axes about the one with number `kept`, so that the axis before it in the order x, z, y
/// follows `heading`.
Mat3 turnedAbout(int kept, const Mat3& axes, const Vec3& heading) {
    const int follows = (kept + 2) % 3, other = (kept + 1) % 3;
    const Vec3 across = heading - axes[kept] * glm::dot(axes[kept], heading);
    const double length = glm::length(across);
    Mat3 turned = axes;
    if (length > kNoDistance)
        turned[follows] = across / length;
    turned[other] = glm::cross(turned[follows], turned[kept]) * (glm::determinant(axes) < 0.0 ? -1.0 : 1.0);
    return turned;
}

/// +y along `heading`, +x level.
Mat3 alongHeading(const Vec3& heading) {
    const double flat = std::hypot(heading.x, heading.y);
    const Vec3 right = flat > kNoDistance ? Vec3(heading.y, -heading.x, 0.0) / flat : Vec3(0, -1, 0);
    return {right, heading, glm::cross(right, heading)};
}

/// The south-west corner of the landblock grid's square around a position.
Vec3 blockCornerOf(const Vec3& position) {
    return {std::floor(position.x / world::kBlockSize) * world::kBlockSize,
            std::floor(position.y / world::kBlockSize) * world::kBlockSize, 0.0};
}

} // namespace

ObjectView::ObjectView(const Vec3& eye, const Vec3& origin, bool isOutdoors, const world::LevelShare& levels)
    : eye_(eye), target_(origin) {
    const Vec3 corner = blockCornerOf(origin);
    const std::array<std::int32_t, 3> local = world::localRangeSteps(origin - corner);
    const auto measure = isOutdoors ? world::LevelMeasure::Landcell : world::LevelMeasure::Object;
    const world::LevelDistance away = world::levelDistance(measure, local, world::rangeStepsOf(eye - corner));
    squared_ = levels.seen(away.squared);
    isShared_ = away.isOfLandcell || std::hypot(origin.x - eye.x, origin.y - eye.y) >= kSharedBeyond;
    if (away.isOfLandcell) {
        const auto middle = [](std::int32_t steps) {
            return static_cast<double>(world::landcellMiddle(steps)) / world::kRangeSteps;
        };
        target_ = corner + Vec3(middle(local[0]), middle(local[1]), 0.0);
        target_.z = eye.z; // a level heading
    }
}

Vec3 ObjectView::headingTo(const Vec3& partMiddle) const {
    return directionOf((isShared_ ? target_ : partMiddle) - eye_);
}

Mat3 turnedToEye(world::Facing facing, const Mat3& linear, const Vec3& heading) {
    const Vec3 scale(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
    if (facing == world::Facing::Fixed || !(std::min({scale.x, scale.y, scale.z}) > 0.0))
        return linear;
    const Mat3 axes(linear[0] / scale.x, linear[1] / scale.y, linear[2] / scale.z);
    const Mat3 turned =
        facing == world::Facing::Eye
            ? alongHeading(heading)
            : turnedAbout(static_cast<int>(facing) - static_cast<int>(world::Facing::AroundX), axes, heading);
    return {turned[0] * scale.x, turned[1] * scale.y, turned[2] * scale.z};
}

void turnToEye(const ObjectView& view, const world::World& world, world::Instance& instance) {
    if (instance.facing == world::Facing::Fixed)
        return;
    const Sphere& mesh = world.meshes[instance.mesh].bounds;
    const Vec3 origin = world.blocks[instance.block].origin() + Vec3(instance.origin);
    const Mat3 own(instance.linear);
    const Mat3 turned = turnedToEye(instance.facing, own, view.headingTo(origin + own * mesh.centre));
    instance.linear = glm::mat3(turned);
    instance.bounds = {
        origin + turned * mesh.centre,
        mesh.radius * std::max({glm::length(turned[0]), glm::length(turned[1]), glm::length(turned[2])})};
}

void addBillboards(DynamicInstances& instances) {
    const world::World& world = instances.world();
    for (const world::Billboard& billboard : world.billboards) {
        LIMEN_ASSERT(billboard.instance < world.instances.size(), "a billboard is an instance");
        const world::Instance& instance = world.instances[billboard.instance];
        const std::size_t first = instances.addCopies(std::span(&instance, 1), billboard.object);
        if (first < instances.count())
            instances.setSpaces(first,
                                std::span(world.members).subspan(instance.firstMember, instance.memberCount));
    }
}

} // namespace limen::motion
