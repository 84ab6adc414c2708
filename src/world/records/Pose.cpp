#include "world/records/Pose.h"

#include <cmath>

namespace limen::world {

Pose poseOf(const dat::Frame& frame) {
    const Quat q(frame.orientation);
    const double length = glm::length(q);
    const Vec3 origin(frame.origin);
    Pose pose;
    if (std::isfinite(length) && length > 1e-6)
        pose.orientation = q / length;
    if (isFinite(origin))
        pose.origin = origin;
    return pose;
}

const dat::AnimationFrame* restingPose(const dat::Setup& setup) {
    for (const std::uint32_t wanted : {dat::Setup::kPlacementResting, dat::Setup::kPlacementDefault}) {
        for (const auto& [placement, frame] : setup.placementFrames)
            if (placement == wanted)
                return &frame;
    }
    return nullptr;
}

Pose restOf(const dat::Setup& setup, std::size_t part) {
    const dat::AnimationFrame* frames = restingPose(setup);
    return frames != nullptr && part < frames->parts.size() ? poseOf(frames->parts[part]) : Pose();
}

Pose placedPartOf(const dat::Setup& setup, std::uint32_t placement, std::size_t part) {
    for (const std::uint32_t wanted : {placement, dat::Setup::kPlacementDefault})
        for (const auto& [key, frame] : setup.placementFrames)
            if (key == wanted && part < frame.parts.size())
                return poseOf(frame.parts[part]);
    return {};
}

} // namespace limen::world
